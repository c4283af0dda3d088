#pragma once
// Payloads as rows of structured NumPy arrays, from each payload's own description
// (model/core/payloads.hpp). A row is packed: its fields follow each other without gaps. A member of 32 bits
// is u4 or i4. A wide member is i8, or two u8 (lower half first) if the configuration needs more than 64
// bits.
//
// Reading a description takes longer than copying a payload. So Rows reads it once for many rows.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/core/payloads.hpp"

namespace rayclock::python {

/// A member of a payload, and its field in a row.
struct RowField {
    std::string name;
    int bits = 0;    ///< width of a number in the chip
    int count = 0;   ///< numbers of an array; 0 for a single number
    bool is_signed = false;
    std::size_t size = 4;     ///< of a number in the payload: 4, 8 or 16 bytes
    std::size_t member = 0;   ///< place in the payload, in bytes
    std::size_t field = 0;    ///< place in the row, in bytes

    int numbers() const { return count > 0 ? count : 1; }
    bool is_pair() const { return size == 16 && bits > 64; }
    /// Returns the bytes of a number in a row.
    std::size_t bytes() const { return is_pair() || size < 16 ? size : 8; }
    std::string format() const {
        return is_pair() ? "<u8" : fmt::format("<{}{}", is_signed ? 'i' : 'u', bytes());
    }
    /// Returns true if a number does not fit in the chip's field.
    bool overflows(std::uint64_t number) const {
        const std::uint64_t bias = is_signed ? std::uint64_t(1) << (bits - 1) : 0;
        return bits < 64 && (number + bias) >> bits != 0;
    }
};

/// Lists the fields of a payload's rows.
template <class Payload> class RowFields {
public:
    explicit RowFields(const Payload& payload) : start_(reinterpret_cast<const char*>(&payload)) {}
    std::vector<RowField> fields;
    std::size_t bytes = 0;   ///< of a row

    template <class T> void operator()(const char* name, const T& member, int width) {
        add<T>(name, &member, width, 0);
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>& member, int width, int count) {
        add<T>(name, member.data(), width, count);
    }

private:
    template <class T> void add(const char* name, const T* member, int width, int count) {
        static_assert(sizeof(T) == 4 || sizeof(T) == 8 || sizeof(T) == 16);
        constexpr bool is_signed = std::is_signed_v<T> || sizeof(T) > 8;
        RowField f{name, width, count, is_signed, sizeof(T), 0, bytes};
        f.member = std::size_t(reinterpret_cast<const char*>(member) - start_);
        bytes += f.bytes() * std::size_t(f.numbers());
        fields.push_back(std::move(f));
    }
    const char* start_;
};

/// Copies payloads from and to rows, for one configuration. Fields that are neighbours in both are copied
/// together.
template <class Payload> class Rows {
    static_assert(std::is_trivially_copyable_v<Payload>);

public:
    explicit Rows(const Config& config) {
        Payload payload;
        RowFields<Payload> listed(payload);
        payload.fields(listed, config);
        fields_ = std::move(listed.fields);
        words_ = listed.bytes / 4;
        bias_.assign(words_, 0);
        beyond_.assign(words_, 0);
        for (const RowField& f : fields_)
            for (int i = 0; i < f.numbers(); ++i) add(f, i);
    }
    const std::vector<RowField>& fields() const { return fields_; }
    std::size_t bytes() const { return words_ * 4; }

    /// Reads a row. Members that the configuration lacks keep their values. Throws UserError that names the
    /// row and the field if a number is too wide.
    void read(Payload& payload, const char* row, std::size_t number) const {
        char* const to = reinterpret_cast<char*>(&payload);
        std::uint32_t beyond = 0;   // bits above the chip's fields
        for (std::size_t w = 0; w < words_; ++w) beyond |= (word(row + 4 * w) + bias_[w]) & beyond_[w];
        for (const Run& run : runs_) copy(to + run.member, row + run.field, run.words);
        for (const RowField& f : long_) {
            std::int64_t value = 0;
            std::memcpy(&value, row + f.field, 8);
            beyond |= f.overflows(std::uint64_t(value));
            std::memcpy(to + f.member, &value, 8);
            value >>= 63;
            if (f.size == 16) std::memcpy(to + f.member + 8, &value, 8);   // little-endian
        }
        if (beyond != 0) refuse(row, number);
    }
    void write(const Payload& payload, char* row) const {
        const char* const from = reinterpret_cast<const char*>(&payload);
        for (const Run& run : runs_) copy(row + run.field, from + run.member, run.words);
        for (const RowField& f : long_) std::memcpy(row + f.field, from + f.member, 8);
    }

private:
    /// Words that follow each other in payload and row.
    struct Run {
        std::size_t member, field, words;
    };

    static std::uint32_t word(const char* at) {
        std::uint32_t value;
        std::memcpy(&value, at, 4);
        return value;
    }
    static void copy(char* to, const char* from, std::size_t words) {
        for (std::size_t w = 0; w < words; ++w) std::memcpy(to + 4 * w, from + 4 * w, 4);
    }
    void add(const RowField& f, int i) {
        RowField one = f;   // one number
        one.member += std::size_t(i) * f.size;
        one.field += std::size_t(i) * f.bytes();
        if (f.size > 4) {
            if (f.is_pair()) {   // two halves of 64 bits
                one.bits = 64, one.size = 8;
                long_.push_back(one);
                one.bits = f.bits - 64, one.member += 8, one.field += 8;
            }
            long_.push_back(one);
            return;
        }
        if (f.bits < 32) {
            bias_[one.field / 4] = f.is_signed ? 1u << (f.bits - 1) : 0;
            beyond_[one.field / 4] = ~((1u << f.bits) - 1);
        }
        if (!runs_.empty() && runs_.back().member + 4 * runs_.back().words == one.member &&
            runs_.back().field + 4 * runs_.back().words == one.field)
            ++runs_.back().words;
        else
            runs_.push_back({one.member, one.field, 1});
    }
    [[noreturn]] void refuse(const char* row, std::size_t number) const {
        const auto check = [&](const RowField& f, std::int64_t value) {
            if (f.overflows(std::uint64_t(value)))
                throw UserError(fmt::format("row {}: {} = {} does not fit in the chip's {} bits", number,
                                            f.name, value, f.bits));
        };
        for (const RowField& f : fields_)
            for (int i = 0; i < f.numbers() && f.size == 4; ++i) {
                const std::uint32_t value = word(row + f.field + 4 * std::size_t(i));
                check(f, f.is_signed ? std::int64_t(std::int32_t(value)) : std::int64_t(value));
            }
        for (const RowField& f : long_) {
            std::int64_t value = 0;
            std::memcpy(&value, row + f.field, 8);
            check(f, value);
        }
        throw std::logic_error("a number was too wide, and is not found again");
    }

    std::vector<RowField> fields_, long_;   ///< all, and numbers of 64 bits
    std::vector<Run> runs_;
    std::size_t words_ = 0;
    /// For each word, the offset of a signed field, and the bits above the field.
    std::vector<std::uint32_t> bias_, beyond_;
};

}   // namespace rayclock::python
