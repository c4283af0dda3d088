// Every built-in scene has exactly the published number of triangles, and is valid at any size.
#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"
#include "tests/scene/mesh_measures.hpp"

using namespace rayclock;

namespace {

const Builtin& builtin(std::string_view name) {
    for (const Builtin& b : builtins())
        if (b.name == name) return b;
    FAIL("no scene " << name);
    return builtins()[0];
}

template <class T> bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}   // namespace

TEST_CASE("triangle counts are the published ones", "[scene][builtin]") {
    struct Case {
        const char* name;
        int size;
        std::uint64_t triangles;
    };
    // Literal numbers of Haines' package, tessellation factor 3.
    const auto c = GENERATE(values<Case>({
        {"tetra", 1, 4},       {"tetra", 6, 4096},   {"tetra", 8, 65536},    {"mount", 1, 440},
        {"mount", 6, 8624},    {"mount", 7, 33200},  {"mount", 9, 524720},   {"gears", 1, 574},
        {"gears", 4, 36610},   {"gears", 5, 71502},  {"gears", 6, 123554},   {"gears", 8, 292866},
        {"teapot", 1, 58},     {"teapot", 2, 248},   {"teapot", 6, 2328},    {"teapot", 12, 9408},
        {"teapot", 36, 85248}, {"balls", 1, 1082},   {"balls", 2, 9830},     {"balls", 3, 88562},
        {"balls", 4, 797150},  {"rings", 1, 3962},   {"rings", 3, 55442},    {"rings", 5, 217802},
        {"rings", 7, 554402},  {"tree", 1, 398},     {"tree", 6, 16766},     {"tree", 7, 33662},
        {"tree", 11, 540542},  {"icosphere", 1, 80}, {"icosphere", 4, 5120}, {"icosphere", 6, 81920},
        {"cornell", 1, 38},    {"room", 1, 34},
    }));
    CAPTURE(c.name, c.size);
    CHECK(builtin(c.name).triangles(c.size) == c.triangles);
    const Scene scene = builtin(c.name).make(c.size);
    CHECK(scene.triangles.size() == c.triangles);
    CHECK(scene.vertices.capacity() <= scene.vertices.size() + 64);
    CHECK(scene.triangles.capacity() <= scene.triangles.size() + 64);
}

TEST_CASE("the largest size is the largest below about ten million triangles", "[scene][builtin]") {
    for (const Builtin& b : builtins()) {
        CAPTURE(b.name);
        CHECK(b.triangles(b.max_size) <= 10'000'000);
        CHECK(primitive_count(b.make(1, Primitives::native)) > 0);
        if (b.max_size > 1) CHECK(b.triangles(b.max_size + 1) > 10'000'000);
        CHECK(b.default_size <= b.max_size);
        CHECK(b.triangles(b.default_size) < 1'000'000);
    }
}

TEST_CASE("every scene is sound and the same each time", "[scene][builtin]") {
    for (const Builtin& b : builtins())
        for (const int size : {1, std::min(2, b.max_size), std::min(b.default_size, 5)}) {
            CAPTURE(b.name, size);
            const Scene scene = b.make(size), again = b.make(size);
            CHECK_NOTHROW(check_scene(scene, std::string(b.name)));
            REQUIRE(scene.camera);
            CHECK(scene.lights.empty() == (b.name == "square"));
            CHECK(same_bits(scene.vertices, again.vertices));
            CHECK(same_bits(scene.normals, again.normals));
            CHECK(same_bits(scene.triangles, again.triangles));
        }
}

TEST_CASE("every vertex is used, no triangle is degenerate, normals are unit and on the outside",
          "[scene][builtin]") {
    for (const Builtin& b : builtins())
        for (const int size : {1, b.default_size}) {
            CAPTURE(b.name, size);
            if (b.name == "teapot" && size == 1) continue;   // degenerate by definition
            const Scene scene = b.make(size);
            std::vector<bool> used(scene.vertices.size());
            std::size_t degenerate = 0, inside = 0, not_unit = 0;
            for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
                const glm::dvec3 face = face_normal(scene, i);
                degenerate += !(glm::length(face) > 0);
                for (const std::uint32_t v : scene.triangles[i].vertex) {
                    used[v] = true;
                    inside += !scene.normals.empty() && !(glm::dot(scene.normals[v], face) > 0);
                }
            }
            for (const glm::dvec3& n : scene.normals) not_unit += !(std::abs(glm::length(n) - 1) < 1e-12);
            // Each of the teapot's eight cusp rows has one corner without a triangle.
            const std::size_t spare = b.name == "teapot" ? 8 : 0;
            CHECK(static_cast<std::size_t>(std::count(used.begin(), used.end(), false)) == spare);
            CHECK(degenerate == 0);
            CHECK(inside == 0);
            CHECK(not_unit == 0);
        }
}

TEST_CASE("brightness stays between black and white", "[scene][builtin]") {
    for (const Builtin& b : builtins()) {
        const Scene scene = b.make(1);
        const double lights = std::sqrt(static_cast<double>(scene.lights.size()));
        for (const Material& m : scene.materials) {
            CAPTURE(b.name, m.name);
            CHECK(m.ambient >= 0.1);
            CHECK(m.diffuse <= 1);
            CHECK(m.ambient + m.diffuse * lights < 1.45);   // all lights straight from the front
            CHECK(m.index >= 1);
            CHECK(m.shine >= 1);
        }
        for (const Light& light : scene.lights) CHECK(light.colour.x * lights == Approx(1));
    }
}
