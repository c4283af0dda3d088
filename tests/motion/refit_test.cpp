// Trees that follow their triangles: a refitted tree is valid and gives the hits of a rebuilt one, and the
// measure decides when to rebuild.
#include <catch2/catch.hpp>

#include "tests/support/check/image_check.hpp"
#include "model/compile/emit.hpp"
#include "model/layout/words.hpp"
#include "model/compile/refit/flat.hpp"
#include "model/compile/refit/refit.hpp"
#include "model/compile/surfaces.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/compile/lattice.hpp"
#include "model/trace/decoder.hpp"
#include "model/trace/record.hpp"
#include "tests/support/scenes/hard_meshes.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::refit_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// A scene in a fixed cube, and its triangles on the lattice of that cube.
struct Film {
    Scene scene;
    Lattice lattice;

    Film(Scene made, const Config& config) : scene(std::move(made)) {
        Scene cube = named("cube");
        add(cube, {-4, -4, -4}, {4, 4, 4}, {4, -4, 4});
        lattice = fit_lattice(cube, {0, 0, 4}, config.coord_bits);
    }
    std::vector<PrimData> prims() const {
        std::vector<PrimData> all;
        for (std::size_t i = 0; i < scene.triangles.size(); ++i)
            all.push_back(snap_primitive(scene, lattice, i));
        return all;
    }
    /// Moves every corner randomly within `far`.
    void shake(double far, Draw& draw) {
        for (glm::dvec3& v : scene.vertices) v = glm::clamp(v + far * draw.point(), -3.9, 3.9);
    }
};

MemoryImage image_of(const Refit& tree, const Film& film) {
    MemoryImage image;
    image.lattice = film.lattice;
    image.report = tree.report();
    image.report.triangles = film.scene.triangles.size();
    image.words.resize(tree.report().bytes / 4);
    tree.write(0, false, image.words.data(), image.lines());
    return image;
}

std::vector<Closest> hits_of(const MemoryImage& image, const Config& config) {
    const Camera camera{{0, 0, 4}, {0.1, 0.2, 0}, {0, 1, 0}, 60};
    return record_trace(image, make_frame(camera, {48, 36}, image, config), config, 1).hits;
}

std::size_t count_different(const std::vector<Closest>& a, const std::vector<Closest>& b) {
    std::size_t count = a.size() != b.size();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        count += a[i].found != b[i].found ||
                 (a[i].found && (a[i].prim != b[i].prim || a[i].t != b[i].t || a[i].u != b[i].u));
    return count;
}

/// Returns the cost from the memory alone: boxes of children are computed from the triangles below them.
double cost_of(const MemoryImage& image, const Config& config) {
    double sum = 0;
    const std::function<LatticeBox(std::uint32_t)> walk = [&](std::uint32_t line) {
        const Node node = bvh::read_node(image, line, config);
        LatticeBox all;
        std::uint32_t inner = 0;
        for (const std::uint32_t kind : node.kind) inner += kind == 1;
        std::uint32_t half = 2 * (node.base + inner);
        for (std::uint32_t i = 0; i < inner; ++i) all.add(walk(node.base + i));
        for (const std::uint32_t kind : node.kind) {
            LatticeBox leaf;
            for (std::uint32_t k = 1; k < kind; ++k, ++half) {
                const PrimData t = read_primitive(image, half, config);
                leaf.add(t.a), leaf.add(t.b), leaf.add(t.c);
            }
            if (kind < 2) continue;
            all.add(leaf);
            sum += double(0.6f) * (kind - 1) * leaf.area();
        }
        sum += all.area();
        return all;
    };
    const LatticeBox root = walk(0);
    return sum / root.area();
}

Config list_of(Config config) {
    config.structure = Structure::none;
    config.leaf_size = 1;
    return config;
}

}   // namespace

TEST_CASE("a tree that follows what has not moved is the tree that was built, byte by byte",
          "[motion][refit]") {
    const Config config = quick_config(GENERATE(from_range(quick_configs())));
    INFO(config.name);
    const Film film(soup(700, 0.3, 4), config);
    const MemoryImage built = compile_triangles(film.prims(), config, "soup");
    Refit tree(config, "soup");
    CHECK(tree.follow(film.prims(), 1e9));
    CHECK(image_of(tree, film).words == built.words);
    CHECK_FALSE(tree.follow(film.prims(), 1));   // it has not become worse
    CHECK(image_of(tree, film).words == built.words);
    CHECK(tree.ratio() == 1);
}

TEST_CASE("a refitted tree holds all its triangles, and gives the hits of a rebuilt one and of no tree",
          "[motion][refit]") {
    const Config config = quick_config(GENERATE(from_range(quick_configs())));
    INFO(config.name);
    Film film(soup(400, 0.5, 9), config);
    Refit tree(config, "soup");
    Draw draw{17};
    for (int frame = 0; frame < 5; ++frame) {
        INFO("frame " << frame);
        CHECK(tree.follow(film.prims(), 1e9) == (frame == 0));
        const MemoryImage refitted = image_of(tree, film);
        CHECK(check_image(refitted, config) == std::vector<std::string>{});
        Refit anew(config, "soup");
        anew.follow(film.prims(), 0);
        const std::vector<Closest> hits = hits_of(refitted, config);
        CHECK(count_different(hits, hits_of(image_of(anew, film), config)) == 0);
        const Config list = list_of(config);
        MemoryImage all = compile_triangles(film.prims(), list, "soup");
        all.lattice = film.lattice;
        CHECK(count_different(hits, hits_of(all, list)) == 0);
        CHECK(std::count_if(hits.begin(), hits.end(), [](const Closest& c) { return c.found; }) > 300);
        film.shake(frame == 2 ? 3 : 0.2, draw);
    }
}

TEST_CASE("a triangle that has no area in one frame is hit in the next", "[motion][refit]") {
    const int test = GENERATE(range(0, int(names_of<PrimitiveTest>().size())));
    INFO("primitive_test=" << name_of(PrimitiveTest(test)));
    const Config config = with(quick_config("default"), {{"primitive_test", test}});
    Film film(soup(50, 0, 3), config);   // all triangles are points
    Refit tree(config, "points");
    tree.follow(film.prims(), 1e9);
    const std::vector<Closest> none = hits_of(image_of(tree, film), config);
    CHECK(std::none_of(none.begin(), none.end(), [](const Closest& c) { return c.found; }));
    Draw draw{5};
    film.shake(1, draw);
    CHECK_FALSE(tree.follow(film.prims(), 1e9));
    Refit anew(config, "points");
    anew.follow(film.prims(), 0);
    const std::vector<Closest> some = hits_of(image_of(tree, film), config);
    CHECK(count_different(some, hits_of(image_of(anew, film), config)) == 0);
    CHECK(std::count_if(some.begin(), some.end(), [](const Closest& c) { return c.found; }) > 300);
}

TEST_CASE("a tree is built anew above the ratio of costs, and not below it", "[motion][refit]") {
    const Config config = quick_config(GENERATE(from_range(quick_configs())));
    INFO(config.name);
    Film film(soup(300, 0.1, 2), config);
    const std::vector<PrimData> before = film.prims();
    Refit tree(config, "soup");
    tree.follow(before, 0);
    const double built = cost_of(image_of(tree, film), config);
    CHECK(tree.cost() == Approx(built).epsilon(1e-6));
    Draw draw{21};
    film.shake(0.8, draw);
    CHECK_FALSE(tree.follow(film.prims(), 1e9));
    const double ratio = cost_of(image_of(tree, film), config) / built;
    CHECK(ratio > 1.5);
    CHECK(tree.ratio() == Approx(ratio).epsilon(1e-6));
    for (const double factor : {0.99, 1.01}) {
        Refit other(config, "soup");
        CHECK(other.follow(before, 1e9));
        CHECK(other.follow(film.prims(), factor * ratio) == (factor < 1));
        CHECK(other.ratio() == Approx(factor < 1 ? 1 : ratio).epsilon(1e-6));
        // The reference is the cost at the last build, not that of the last frame.
        CHECK_FALSE(other.follow(film.prims(), factor < 1 ? 1 : 1.01 * ratio));
    }
    // 0 builds every time, even without motion.
    CHECK(tree.follow(film.prims(), 0));
    CHECK(tree.follow(film.prims(), 0));
}

TEST_CASE("no tree takes more lines than there is room for", "[motion][refit]") {
    for (const std::string& name : quick_configs()) {
        const Config config = quick_config(name);
        for (const int n : {1, 2, 3, 4, 5, 9, 64, 500})
            for (const Scene& scene : {soup(n, 0.2, 1), coincident(n), vanishing(n)}) {
                const Film film(scene, config);
                Refit tree(config, "soup");
                tree.follow(film.prims(), 0);
                CHECK(tree.report().bytes / 64 <= Refit::max_lines(std::uint64_t(n)));
            }
    }
    CHECK(Refit::max_lines(1) == 2);
}

namespace {

/// Compares everything that a ray may read below a node: the chip's memory with the host's. Counts lines of
/// zeros.
void compare_below(std::uint32_t line, const Decoder& host, const MemoryImage& image,
                   const MemoryImage& memory, std::size_t& zeros) {
    REQUIRE(std::equal(image.line(line), image.line(line) + words_per_line, memory.line(line)));
    const WideNode& node = host.below(line);
    for (std::uint32_t i = 0; i < node.children; ++i) {
        if (node.inner_mask >> i & 1) {
            compare_below(node.base + node.offset[i] / 2, host, image, memory, zeros);
            continue;
        }
        for (std::uint32_t k = 0; k < node.count[i]; ++k) {
            const std::uint32_t prim = 2 * node.base + node.offset[i] + k, at = prim / 2;
            REQUIRE(std::equal(image.half_line(prim), image.half_line(prim) + words_per_line / 2,
                               memory.half_line(prim)));
            zeros += std::all_of(image.line(at), image.line(at) + words_per_line,
                                 [](std::uint32_t word) { return word == 0; });
        }
    }
}

}   // namespace

TEST_CASE("uploads give the chip the host's image, whatever its memory held before, even for lines of zeros",
          "[motion][refit]") {
    const Config config = named_config("default");
    const Bounds box{glm::dvec3(-4), glm::dvec3(4)};
    const glm::dvec3 eye(0);
    std::size_t zeros = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        INFO("seed " << seed);
        Scene scene = soup(int(3 + seed % 20), 0.5, seed);
        RefittedScene film(scene, box, std::span(&eye, 1), 0, config);
        MemoryImage memory;
        memory.words.assign(std::size_t(Refit::max_lines(scene.triangles.size())) * words_per_line,
                            0x5a5a5a5a);
        for (int f = 0; f < 4; ++f) {
            const Upload upload = film.next(scene);
            apply(upload, memory);
            compare_below(0, Decoder(film.image(), config), film.image(), memory, zeros);
            Draw draw{100 * seed + std::uint32_t(f)};
            for (glm::dvec3& v : scene.vertices) v = 3.0 * draw.point();
            // The lattice's centre, so that all numbers of the first triangle are 0.
            for (const std::uint32_t v : scene.triangles[0].vertex)
                scene.vertices[v] = film.image().lattice.centre;
        }
    }
    CHECK(zeros > 3);
}

}   // namespace rayclock::test::refit_test
