// The fractions of the oracle, judged by their definition in whole numbers, because a special case in the
// library could change a verdict.
#include <catch2/catch.hpp>

#include "tests/support/oracle/fractions.hpp"

using rayclock::oracle::Int;
using rayclock::oracle::Rational;

namespace {

/// Returns true if q equals above / below, in lowest terms and with a denominator above 0.
bool is_fraction(const Rational& q, const Int& above, const Int& below) {
    const Int n = numerator(q), d = denominator(q), size = abs(n);
    return d > 0 && Int(gcd(size, d)) == 1 && Int(n * below) == Int(above * d) &&
           (q < 0) == (Int(above * below) < 0) && (q > 0) == (Int(above * below) > 0);
}

/// Checks all operators on n / d and a whole number of type Whole, in both orders, with and without
/// assignment.
template <class Whole> void check_operators(int n, int d, int w) {
    const Rational q(n, d);
    const Whole whole(w);
    CAPTURE(n, d, w);
    CHECK(is_fraction(q + whole, n + w * d, d));
    CHECK(is_fraction(whole + q, n + w * d, d));
    CHECK(is_fraction(q - whole, n - w * d, d));
    CHECK(is_fraction(whole - q, w * d - n, d));
    CHECK(is_fraction(q * whole, n * w, d));
    CHECK(is_fraction(whole * q, n * w, d));
    if (w != 0) CHECK(is_fraction(q / whole, n, d * w));
    if (w != 0) CHECK(is_fraction(q / whole * Rational(3, 2), 3 * n, 2 * d * w));
    if (n != 0) CHECK(is_fraction(whole / q, w * d, n));
    CHECK((q < whole) == (d > 0 ? n < w * d : n > w * d));
    CHECK((q == whole) == (n == w * d));
    Rational sum = q, difference = q, product = q, quotient = q;
    sum += whole, difference -= whole, product *= whole;
    CHECK(is_fraction(sum, n + w * d, d));
    CHECK(is_fraction(difference, n - w * d, d));
    CHECK(is_fraction(product, n * w, d));
    if (w == 0) return;
    quotient /= whole;
    CHECK(is_fraction(quotient, n, d * w));
}

}   // namespace

TEST_CASE("a fraction and a whole number give the fraction that its definition gives", "[oracle]") {
    for (int n = -4; n <= 4; ++n)
        for (int d = 1; d <= 6; ++d)
            for (const int w : {-70000, -6, -2, -1, 0, 1, 2, 3, 70001}) {
                check_operators<Int>(n, d, w);
                check_operators<int>(n, d, w);
                check_operators<long long>(n, d, w);
                check_operators<Rational>(n, d, w);
            }
}
