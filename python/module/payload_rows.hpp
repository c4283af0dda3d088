#pragma once
// Payloads as rows of structured NumPy arrays, from the one description that each payload gives of itself
// (model/core/payloads.hpp). A row is packed: its fields follow each other without gaps. A member of 32 bits
// is u4 or i4. A wide member is i8, or two u8 (lower half first) if the configuration needs more than 64
// bits.
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/core/payloads.hpp"

namespace rayclock::python {

/// A field of a row.
struct RowField {
    std::string name, format;   ///< of NumPy: "<u4"
    int count = 0;              ///< of an array; 0 for a single number
    int bits = 0;               ///< width of a number in the chip
    bool is_signed = false;
};

/// The number of bytes and the format of a member, in a machine where it has `width` bits.
template <class T> constexpr std::size_t bytes_in_row(int width) {
    return sizeof(T) > 8 && width <= 64 ? 8 : sizeof(T);
}

/// Lists the fields of a row.
class RowFields {
public:
    std::vector<RowField> fields;
    template <class T> void operator()(const char* name, const T&, int width) {
        if (bytes_in_row<T>(width) > 8)
            fields.push_back({name, "<u8", 2, width, true});
        else
            fields.push_back({name, format<T>(bytes_in_row<T>(width)), 0, width, T(-1) < T(0)});
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&, int width, int count) {
        fields.push_back({name, format<T>(sizeof(T)), count, width, T(-1) < T(0)});
    }

private:
    template <class T> static std::string format(std::size_t bytes) {
        return fmt::format("<{}{}", T(-1) < T(0) ? 'i' : 'u', bytes);
    }
};

/// Reads a payload from a row, and finds numbers that are wider than the chip's field.
class RowReader {
public:
    explicit RowReader(const char* row) : at_(row) {}
    /// Returns the name of the first field that is too wide, or null.
    const char* too_wide() const { return too_wide_; }

    template <class T> void operator()(const char* name, T& value, int width) {
        if (sizeof(T) > 8 && width <= 64) {
            std::int64_t narrow;
            take(narrow);
            value = T(narrow);
        } else {
            take(value);
        }
        check(name, value, width);
    }
    template <class T, std::size_t n>
    void operator()(const char* name, std::array<T, n>& value, int width, int count) {
        std::memcpy(value.data(), at_, std::size_t(count) * sizeof(T));
        at_ += std::size_t(count) * sizeof(T);
        for (int i = 0; i < count; ++i) check(name, value[std::size_t(i)], width);
    }

private:
    template <class T> void take(T& value) {
        std::memcpy(&value, at_, sizeof value);
        at_ += sizeof value;
    }
    template <class T> void check(const char* name, T value, int width) {
        if (width >= int(sizeof(T)) * 8) return;
        const T top = T(-1) < T(0) ? T(value >> (width - 1)) : T(value >> width);
        if (top != 0 && !(T(-1) < T(0) && top == T(-1)) && !too_wide_) too_wide_ = name;
    }
    const char* at_;
    const char* too_wide_ = nullptr;
};

/// Writes a payload to a row.
class RowWriter {
public:
    explicit RowWriter(char* row) : at_(row) {}
    template <class T> void operator()(const char*, const T& value, int width) {
        const std::size_t bytes = bytes_in_row<T>(width);
        std::memcpy(at_, &value, bytes);
        at_ += bytes;
    }
    template <class T, std::size_t n>
    void operator()(const char*, const std::array<T, n>& value, int, int count) {
        std::memcpy(at_, value.data(), std::size_t(count) * sizeof(T));
        at_ += std::size_t(count) * sizeof(T);
    }

private:
    char* at_;
};

template <class P> std::vector<RowField> row_fields(const Config& config) {
    RowFields listed;
    P{}.fields(listed, config);
    return listed.fields;
}
inline std::size_t row_bytes(const std::vector<RowField>& fields) {
    std::size_t bytes = 0;
    for (const RowField& f : fields)
        bytes += std::size_t(f.format[2] - '0') * std::size_t(f.count > 0 ? f.count : 1);
    return bytes;
}
/// Reads a row. Throws UserError that names the row and the field if a number is too wide.
template <class P> void read_row(P& payload, const char* row, std::size_t number, const Config& config) {
    RowReader reader(row);
    payload.fields(reader, config);
    if (!reader.too_wide()) return;
    for (const RowField& f : row_fields<P>(config))
        if (f.name == reader.too_wide())
            throw UserError(
                fmt::format("row {}: {} does not fit in the chip's {} bits", number, f.name, f.bits));
}
template <class P> void write_row(const P& payload, char* row, const Config& config) {
    RowWriter writer(row);
    const_cast<P&>(payload).fields(writer, config);
}

}   // namespace rayclock::python
