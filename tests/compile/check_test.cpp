// The validator itself must detect every kind of damage.
#include <catch2/catch.hpp>

#include "tests/support/check/image_check.hpp"
#include "model/compile/compile.hpp"
#include "model/layout/words.hpp"
#include "tests/support/scenes/hard_meshes.hpp"

using namespace rayclock;

namespace {

struct Victim {
    Config config;
    Scene scene = soup(200, 0.3, 21);
    MemoryImage image = compile_scene(scene, {2, 3, 9}, config);

    bool sound() const { return check_image(image, config, &scene).empty(); }
    Node node(std::uint32_t line) const { return bvh::read_node(image, line, config); }
    template <class P> void put(const P& payload, std::size_t word) {
        const Words packed = pack(payload, config);
        std::copy(packed.begin(), packed.end(), image.words.begin() + std::ptrdiff_t(word));
    }
};

}   // namespace

TEST_CASE("the validator notices a box that is rounded inward") {
    Victim victim;
    REQUIRE(victim.sound());
    const Node root = victim.node(0);
    int moved = 0;
    for (std::size_t i = 0; i < std::size_t(3 * victim.config.node_width); ++i) {
        if (root.kind[i / 3] == 0) continue;
        Node node = root;
        // One step less than the compiler's outward rounding.
        node.hi[i] -= 1;
        victim.put(node, 0);
        CHECK_FALSE(victim.sound());
        node = root;
        node.lo[i] += 1;
        victim.put(node, 0);
        CHECK_FALSE(victim.sound());
        ++moved;
    }
    CHECK(moved > 3);
    victim.put(root, 0);
    CHECK(victim.sound());
}

TEST_CASE("the validator notices a damaged node") {
    Victim victim;
    Node root = victim.node(0);
    REQUIRE(root.kind[1] == 1);
    SECTION("origin moved") { root.org[1] += 1; }
    SECTION("finer exponent") { root.exp[0] -= 1; }
    SECTION("block of another node") { root.base = victim.node(root.base).base; }
    SECTION("block beyond the end") { root.base = victim.image.lines() - 1; }
    SECTION("block at the root") { root.base = 0; }
    SECTION("child lost") { root.kind[std::size_t(victim.config.node_width - 1)] = 0; }
    SECTION("children out of order") { root.kind[0] = 2; }
    SECTION("leaf larger than allowed") { root.kind[std::size_t(victim.config.node_width - 1)] = 4; }
    SECTION("no children") { root.kind.fill(0); }
    victim.put(root, 0);
    CHECK_FALSE(victim.sound());
}

TEST_CASE("the validator notices a damaged triangle") {
    Victim victim;
    std::uint32_t line = 0;
    while (victim.node(line).kind[0] == 1) line = victim.node(line).base;
    const std::uint32_t half_line = 2 * victim.node(line).base;
    PrimData triangle = read_primitive(victim.image, half_line, victim.config);
    SECTION("corner moved") { triangle.b[2] += 1; }
    SECTION("corners swapped") { std::swap(triangle.a, triangle.b); }
    SECTION("another triangle's number") { triangle.prim = triangle.prim == 0 ? 1 : 0; }
    SECTION("number that does not exist") { triangle.prim = 200; }
    SECTION("coordinate outside the symmetric lattice") {
        triangle.a[0] = -(1 << (victim.config.coord_bits - 1));
    }
    victim.put(triangle, half_line * words_per_half);
    CHECK_FALSE(victim.sound());
}

TEST_CASE("the validator notices stray bits, lines and figures") {
    Victim victim;
    SECTION("bit above a node") { victim.image.words[15] |= 1u << 31; }
    SECTION("line that nothing leads to") {
        victim.image.words.resize(victim.image.words.size() + words_per_line, 0);
    }
    SECTION("part of a line") { victim.image.words.pop_back(); }
    SECTION("last line missing") { victim.image.words.resize(victim.image.words.size() - words_per_line); }
    SECTION("nothing at all") { victim.image.words.clear(); }
    SECTION("nodes miscounted") { ++victim.image.report.nodes; }
    SECTION("leaves miscounted") { --victim.image.report.leaves; }
    SECTION("too shallow a stack promised") { --victim.image.report.stack_need; }
    SECTION("wrong depth") { ++victim.image.report.depth; }
    SECTION("wrong count of collapsed triangles") { ++victim.image.report.collapsed; }
    SECTION("wrong size") { victim.image.report.bytes += 64; }
    CHECK_FALSE(victim.sound());
}

TEST_CASE("an image of noise gives complaints, not crashes") {
    Victim victim;
    Draw draw{5};
    for (std::uint32_t& word : victim.image.words) word = std::uint32_t(std::int64_t(draw() * 2147483647.0));
    CHECK_FALSE(victim.sound());
}
