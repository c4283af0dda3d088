// Faulty variants of the exact triangle test, and of the boxes of a tree.
#include "sim/explore/stress/controls.hpp"

#include <algorithm>

#include "model/unit/tri/tri.hpp"

namespace rayclock::stress {

namespace {

using Number = std::int64_t;
using oracle::Int128;

/// The oracle's edge functions, into which the controls put faults.
struct Edges {
    Int128 bc, ca, ab, height;
    Int128 size() const { return bc + ca + ab; }
};
Edges edges(const Vec3i& o, const Vec3i& d, const PrimData& t, Number keep = ~Number(0)) {
    const auto from = oracle::triple<Number>(o), along = oracle::triple<Number>(d);
    const auto a = oracle::way(from, oracle::triple<Number>(t.a)),
               b = oracle::way(from, oracle::triple<Number>(t.b)),
               c = oracle::way(from, oracle::triple<Number>(t.c));
    const auto kept = [&](oracle::Triple<Number> area) {
        for (Number& x : area) x &= keep;
        return area;
    };
    const auto bc = oracle::area(b, c);
    return {oracle::volume<Int128>(along, kept(bc)), oracle::volume<Int128>(along, kept(oracle::area(c, a))),
            oracle::volume<Int128>(along, kept(oracle::area(a, b))), oracle::volume<Int128>(a, bc)};
}
bool ahead(const Edges& e) { return e.size() != 0 && e.height != 0 && (e.size() > 0) == (e.height > 0); }

/// Counts edge functions of zero as inside for every triangle: >= instead of the tie rule.
void inclusive(const Vec3i& o, const Vec3i& d, const PrimData& t, const Best&, const Config&, TriRsp& out) {
    const Edges e = edges(o, d, t);
    out.closer = ahead(e) && (std::min({e.bc, e.ca, e.ab}) >= 0 || std::max({e.bc, e.ca, e.ab}) <= 0);
}
/// Counts edge functions of zero as outside (>), and keeps only the product bits in `keep`.
template <Number keep>
void exclusive(const Vec3i& o, const Vec3i& d, const PrimData& t, const Best&, const Config&, TriRsp& out) {
    const Edges e = edges(o, d, t, keep);
    out.closer = ahead(e) && (std::min({e.bc, e.ca, e.ab}) > 0 || std::max({e.bc, e.ca, e.ab}) < 0);
}
/// Treats triangles with a small determinant as edge-on: below 2^-30 of the largest possible value.
void epsilon(const Vec3i& o, const Vec3i& d, const PrimData& t, const Best& best, const Config& c,
             TriRsp& out) {
    const Int128 size = edges(o, d, t).size(), least = Int128(1) << (2 * c.coord_bits + c.dir_bits - 30);
    tri_test(o, d, t, best, c, out);
    if (size < least && -size < least) out.closer = 0;
}

}   // namespace

void shrink_boxes(MemoryImage& image, const Config& config) {
    const auto shrink = [&](const auto& self, std::uint32_t line) -> void {
        Node node = unpack<Node>(image.line(line), config);
        std::uint32_t inner = 0;
        for (std::size_t i = 0; i < std::size_t(config.node_width) && node.kind[i] != 0; ++i) {
            for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
                if (node.lo[k] < node.hi[k]) ++node.lo[k];
                if (node.lo[k] < node.hi[k]) --node.hi[k];
            }
            inner += node.kind[i] == 1;
        }
        const Words words = pack(node, config);
        std::copy(words.begin(), words.end(), image.words.begin() + std::ptrdiff_t(line) * 16);
        for (std::uint32_t i = 0; i < inner; ++i) self(self, node.base + i);
    };
    shrink(shrink, 0);
}

const std::vector<NamedTest>& controls() {
    static const std::vector<NamedTest> all{
        {"inclusive", "control: >= for the tie rule. Must hit twice", inclusive, Walks::no,
         PrimitiveTest::exact, Demand::double_hits},
        {"exclusive", "control: > for the tie rule. Must leak", exclusive<~Number(0)>, Walks::no,
         PrimitiveTest::exact, Demand::leaks},
        {"dropped_bit", "control: the lowest bit of every product is lost. Must leak", exclusive<~Number(1)>,
         Walks::no, PrimitiveTest::exact, Demand::leaks},
        {"epsilon", "control: |det| < 2^-30 of the largest is not a hit. Must leak", epsilon, Walks::no,
         PrimitiveTest::exact, Demand::leaks},
        {"inward_boxes",
         "control: the exact test in child boxes rounded inwards. Must miss what the oracle hits", tri_test,
         Walks::small_boxes, PrimitiveTest::exact, Demand::mismatches},
    };
    return all;
}

}   // namespace rayclock::stress
