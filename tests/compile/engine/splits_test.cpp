// Spatial splits: nothing is lost, references are bounded, and overlapping boxes overlap less.
#include <catch2/catch.hpp>

#include <set>

#include "model/engine/bvh/encode.hpp"
#include "model/unit/tri/vectors.hpp"
#include "tests/compile/listed.hpp"
#include "tests/support/cases/draw.hpp"

namespace rayclock::test::splits_test {

using namespace rayclock;

namespace {

constexpr int parts = 6;   // parts of an edge: points are in units of a sixth of a step

Config split(int width = 8) {
    Config config;
    config.splits = Splits::on;
    config.node_width = width;
    config.leaf_size = width == 8 ? 1 : 3;
    config.stack_depth = 64;
    return config;
}

class Reader {
public:
    Reader(const MemoryImage& image, const Config& config) : image_(image), config_(config) { count(0); }

    /// Returns true if a leaf whose boxes all contain x / parts has the primitive.
    bool holds(std::uint32_t line, const Vec3l& x, std::uint32_t prim) const {
        const Node node = bvh::read_node(image_, line, config_);
        std::uint32_t inner = 0, half_line = first_leaf(node);
        for (std::size_t i = 0; i < std::size_t(config_.node_width) && node.kind[i] > 0; ++i) {
            bool is_in = true;
            for (std::size_t k = 0; k < 3; ++k)
                is_in = is_in &&
                        x[k] >= parts * std::int64_t(bvh::dequantised(node, node.lo[3 * i + k], k)) &&
                        x[k] <= parts * std::int64_t(bvh::dequantised(node, node.hi[3 * i + k], k));
            if (node.kind[i] == 1) {
                if (is_in && holds(node.base + inner, x, prim)) return true;
                ++inner;
            }
            for (std::uint32_t n = 1; n < node.kind[i]; ++n, ++half_line)
                if (is_in && read_primitive(image_, half_line, config_).prim == prim) return true;
        }
        return false;
    }
    std::uint64_t nodes = 0, leaves = 0, references = 0, twice = 0;   ///< `twice`: duplicates within one leaf

private:
    std::uint32_t first_leaf(const Node& node) const {
        std::uint32_t inner = 0;
        for (std::size_t i = 0; i < std::size_t(config_.node_width); ++i) inner += node.kind[i] == 1;
        return 2 * (node.base + inner);
    }
    void count(std::uint32_t line) {
        const Node node = bvh::read_node(image_, line, config_);
        ++nodes;
        std::uint32_t inner = 0, half_line = first_leaf(node);
        for (std::size_t i = 0; i < std::size_t(config_.node_width) && node.kind[i] > 0; ++i) {
            if (node.kind[i] == 1) {
                count(node.base + inner++);
                continue;
            }
            ++leaves;
            std::set<std::uint32_t> there;
            for (std::uint32_t n = 1; n < node.kind[i]; ++n, ++references)
                twice += !there.insert(read_primitive(image_, half_line++, config_).prim).second;
        }
    }

    const MemoryImage& image_;
    const Config& config_;
};

/// Requires that 28 points of every triangle are in a leaf with the triangle. All computation is in whole
/// numbers.
void check_held(const std::vector<PrimData>& prims, const Config& config) {
    const MemoryImage image = compile_triangles(prims, config, "the case");
    const Reader reader(image, config);
    CHECK(image.report.nodes == reader.nodes);
    CHECK(image.report.leaves == reader.leaves);
    CHECK(image.report.references == reader.references);
    CHECK(reader.twice == 0);
    CHECK(reader.references >= prims.size());
    CHECK(reader.references <= 2 * prims.size());
    int lost = 0;
    for (const PrimData& prim : prims) {
        if (prim.kind != PrimKind::triangle) continue;
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                Vec3l x{};
                for (std::size_t k = 0; k < 3; ++k)
                    x[k] = std::int64_t(i) * prim.a[k] + std::int64_t(j) * prim.b[k] +
                           std::int64_t(parts - i - j) * prim.c[k];
                lost += !reader.holds(0, x, prim.prim);
            }
    }
    CHECK(lost == 0);
}

std::vector<PrimData> tangle(unsigned seed, int count, int extent) {
    test::Draw draw{seed};
    std::vector<PrimData> prims;
    const auto any = [&] {
        return Vec3i{draw.between(-extent, extent), draw.between(-extent, extent),
                     draw.between(-extent, extent)};
    };
    while (int(prims.size()) < count) {
        const PrimData t{any(), any(), any(), std::uint32_t(prims.size())};
        if (counts(t, Config{})) prims.push_back(t);
    }
    return prims;
}

std::uint64_t references(const std::vector<PrimData>& prims, const Config& config) {
    return compile_triangles(prims, config, "the case").report.references;
}

}   // namespace

TEST_CASE("boxes with spatial splits hold what lies in them", "[splits]") {
    const int width = GENERATE(8, 4, 2);
    const Config config = split(width);
    INFO("width " << width);
    for (const char* name : {"gears:1", "rings:1", "tree:4", "teapot:4"}) {
        INFO(name);
        check_held(test::prims_of(name, {}, Primitives::triangles), config);
    }
    for (unsigned seed = 1; seed <= 3; ++seed) {
        check_held(tangle(seed, 300, 131071), config);
        check_held(tangle(seed, 300, 40), config);
    }
}

TEST_CASE("overlapping triangles are cut, at most as many as the rule allows", "[splits]") {
    const std::vector<PrimData> rings = test::prims_of("rings:1", {}, Primitives::triangles);
    CHECK(references(rings, split()) > rings.size() + rings.size() / 20);
    Config off = split();
    off.splits = Splits::off;
    CHECK(references(rings, off) == rings.size());
    // Without overlap there is no gain.
    std::vector<PrimData> row;
    for (std::int32_t i = 0; i < 100; ++i)
        row.push_back({{100 * i, 0, 0}, {100 * i + 50, 0, 0}, {100 * i, 50, 20}, std::uint32_t(i)});
    CHECK(references(row, split()) == row.size());
}

TEST_CASE("spatial splits end with identical triangles, and with a single one", "[splits]") {
    for (const std::uint32_t n : {1u, 2u, 300u}) {
        std::vector<PrimData> prims(n, {{0, 0, 0}, {1000, 0, 400}, {0, 1000, 0}, 0});
        for (std::uint32_t i = 0; i < n; ++i) prims[i].prim = i;
        check_held(prims, split());
    }
}

TEST_CASE("planes without end are not cut by spatial splits", "[splits]") {
    check_held(test::prims_of("plane", {}, Primitives::native), split());
}

}   // namespace rayclock::test::splits_test
