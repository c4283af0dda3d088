// Computes the tables of tables.hpp in integers.
#include "model/fixed/tables.hpp"

#include "model/fixed/square_root.hpp"

namespace rayclock {

namespace {

constexpr int table_frac = 60;   // fraction bits of intermediate logarithms and powers
constexpr std::uint64_t table_one = std::uint64_t(1) << table_frac;

std::uint64_t times(std::uint64_t a, std::uint64_t b) { return std::uint64_t(Unsigned(a) * b >> table_frac); }

/// Returns x / 2^drop rounded to nearest.
std::uint32_t table_rounded(std::uint64_t x, int drop) { return std::uint32_t(((x >> (drop - 1)) + 1) >> 1); }

/// Returns round(2^bits log2(x)) for x in 1..2, bit by bit: squaring doubles the logarithm.
std::uint32_t log2_of(std::uint64_t x, int bits) {
    std::uint64_t log = 0;
    for (int i = 0; i <= bits; ++i) {   // one extra bit, to round
        if (x >= 2 * table_one) return std::uint32_t(1) << bits;
        const Unsigned square = Unsigned(x) * x >> table_frac;
        const bool is_set = square >= 2 * table_one;
        log = 2 * log + is_set;
        x = std::uint64_t(square >> is_set);
    }
    return std::uint32_t((log + 1) >> 1);
}

/// Makes entries 0..n-1 from values 0..n.
template <std::size_t n, class Value> std::array<TableEntry, n> make_table(Value value) {
    std::array<TableEntry, n> table;
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint32_t here = value(i), next = value(i + 1);
        table[i] = {here, here > next ? here - next : next - here};
    }
    return table;
}

}   // namespace

const std::array<TableEntry, root_entries>& inverse_root_table() {
    // 2^18 / sqrt((128 + i) / 128) = sqrt(2^43 / (128 + i)), with 20 more bits before rounding.
    static const auto table = make_table<root_entries>(
        [](std::size_t i) { return table_rounded(square_root((Unsigned(1) << 83) / (128 + i)), 20); });
    return table;
}

const std::array<TableEntry, log_entries>& log_table() {
    static const auto table =
        make_table<log_entries>([](std::size_t i) { return log2_of(table_one / 128 * (128 + i), 18); });
    return table;
}

const std::array<TableEntry, exp_entries>& exp_table() {
    static const auto table = make_table<exp_entries>([](std::size_t i) {
        std::uint64_t ratio = table_one / 2, power = table_one;   // 2^(-1/128): seven square roots of a half
        for (int k = 0; k < 7; ++k) ratio = square_root(Unsigned(ratio) << table_frac);
        for (std::size_t k = 0; k < i; ++k) power = times(power, ratio);
        return table_rounded(power, table_frac - 17);
    });
    return table;
}

}   // namespace rayclock
