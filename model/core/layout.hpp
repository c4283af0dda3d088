#pragma once
// Packs and unpacks payloads, from the one description that each payload gives of itself.
//
// A payload has `template <class V> void fields(V& v, const Config& c)`, which names every member with its
// width: v("t_near", t_near, c.t_bits()). The first field is the most significant. Element 0 of an array lies
// at the bottom of its field, so that SystemVerilog's x[i*Width +: Width] is element i. Words are in
// Verilator's order: bits 31..0 in word 0. The generated SystemVerilog structs come from the same calls.
#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

using Words = std::vector<std::uint32_t>;

template <class T> struct ArrayTraits {
    using Element = T;
    static constexpr int size = 1;
};
template <class T, std::size_t n> struct ArrayTraits<std::array<T, n>> {
    using Element = T;
    static constexpr int size = int(n);
};

/// Counts the bits of a payload.
class WidthVisitor {
public:
    int bits = 0;
    template <class T> void operator()(const char*, const T&, int width) { bits += width; }
    template <class T, std::size_t n>
    void operator()(const char*, const std::array<T, n>&, int width, int count) {
        assert(count <= int(n));
        (void)n;
        bits += width * count;
    }
};

/// Writes members into words, from the top down. The words must be zero.
class PackVisitor {
public:
    PackVisitor(Words& words, int bits) : words_(words), at_(bits) {}
    template <class T> void operator()(const char*, const T& value, int width) {
        if constexpr (sizeof(T) > 8) {
            if (width > 64) put(std::uint64_t(value >> 64), width - 64);
            put(std::uint64_t(value), std::min(width, 64));
        } else {
            put(std::uint64_t(value), width);
        }
    }
    template <class T, std::size_t n>
    void operator()(const char*, const std::array<T, n>& value, int width, int count) {
        for (int i = count; i-- > 0;) put(std::uint64_t(value[std::size_t(i)]), width);
    }

private:
    void put(std::uint64_t value, int width) {
        at_ -= width;
        if (width < 64) value &= (std::uint64_t(1) << width) - 1;
        const int shift = at_ % 32;
        std::size_t word = std::size_t(at_ / 32);
        words_[word] |= std::uint32_t(value << shift);
        for (int done = 32 - shift; done < width; done += 32) words_[++word] |= std::uint32_t(value >> done);
    }
    Words& words_;
    int at_;
};

/// Reads members from words, and sign-extends members of a signed type.
class UnpackVisitor {
public:
    UnpackVisitor(const std::uint32_t* words, int bits) : words_(words), at_(bits) {}
    template <class T> void operator()(const char*, T& value, int width) {
        if constexpr (sizeof(T) > 8) {
            const T high = width > 64 ? T(get<std::int64_t>(width - 64)) : 0;
            value =
                width > 64 ? high * (T(1) << 64) + T(get<std::uint64_t>(64)) : T(get<std::int64_t>(width));
        } else {
            value = get<T>(width);
        }
    }
    template <class T, std::size_t n>
    void operator()(const char*, std::array<T, n>& value, int width, int count) {
        for (int i = count; i-- > 0;) value[std::size_t(i)] = get<T>(width);
    }

private:
    template <class T> T get(int width) {
        at_ -= width;
        const int shift = at_ % 32;
        std::size_t word = std::size_t(at_ / 32);
        std::uint64_t value = words_[word] >> shift;
        for (int done = 32 - shift; done < width; done += 32) value |= std::uint64_t(words_[++word]) << done;
        value <<= 64 - width;
        if constexpr (std::is_signed_v<T>)
            return T(std::int64_t(value) >> (64 - width));
        else
            return T(value >> (64 - width));
    }
    const std::uint32_t* words_;
    int at_;
};

template <class P> int bits_of(const Config& config) {
    WidthVisitor width;
    P{}.fields(width, config);
    return width.bits;
}

template <class P> void pack(const P& payload, const Config& config, Words& words) {
    const int bits = bits_of<P>(config);
    words.assign(std::size_t(bits + 31) / 32, 0);
    PackVisitor visitor{words, bits};
    const_cast<P&>(payload).fields(visitor, config);
}
template <class P> Words pack(const P& payload, const Config& config) {
    Words words;
    pack(payload, config, words);
    return words;
}
template <class P> P unpack(const std::uint32_t* words, const Config& config) {
    P payload;
    UnpackVisitor visitor{words, bits_of<P>(config)};
    payload.fields(visitor, config);
    return payload;
}

}   // namespace rayclock
