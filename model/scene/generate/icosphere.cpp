// A closed sphere without poles or seams: the icosahedron with every triangle cut in four `size` times. All
// vertices lie on the unit sphere and are shared; normals are radial.
#include "model/scene/generate/generate.hpp"

#include <array>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

using Face = std::array<std::uint32_t, 3>;

struct Ball {
    std::vector<glm::dvec3> points;
    std::vector<Face> faces;
};

Ball icosahedron() {
    constexpr double g = std::numbers::phi;
    Ball ball;
    for (const glm::dvec3& p : {glm::dvec3(-1, g, 0),
                                {1, g, 0},
                                {-1, -g, 0},
                                {1, -g, 0},
                                {0, -1, g},
                                {0, 1, g},
                                {0, -1, -g},
                                {0, 1, -g},
                                {g, 0, -1},
                                {g, 0, 1},
                                {-g, 0, -1},
                                {-g, 0, 1}})
        ball.points.push_back(unit(p));
    ball.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return ball;
}

/// The middles of edges, each made once. No vertex has more than six neighbours. So a small table at the
/// lower-numbered end of every edge replaces a hash map.
class Middles {
public:
    explicit Middles(Ball& ball) : ball_(ball), edges_(ball.points.size()) {}

    std::uint32_t operator()(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        for (auto& [other, middle] : edges_[a]) {
            // Point 0 is a corner of the icosahedron, never a middle, so 0 marks a free entry.
            if (middle == 0) {
                other = b;
                middle = static_cast<std::uint32_t>(ball_.points.size());
                ball_.points.push_back(unit(ball_.points[a] + ball_.points[b]));
            }
            if (other == b) return middle;
        }
        std::abort();   // a seventh neighbour: not a subdivided icosahedron
    }

private:
    Ball& ball_;
    std::vector<std::array<std::pair<std::uint32_t, std::uint32_t>, 6>> edges_;
};

void cut_in_four(Ball& ball) {
    Middles middle(ball);
    std::vector<Face> finer;
    finer.reserve(4 * ball.faces.size());
    for (const auto& [a, b, c] : ball.faces) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    ball.faces = std::move(finer);
}

}   // namespace

std::uint64_t icosphere_triangles(int size) { return std::uint64_t{20} << 2 * size; }

Scene make_icosphere(int size) {
    Ball ball = icosahedron();
    ball.points.reserve(icosphere_triangles(size) / 2 + 2);
    for (int i = 0; i < size; ++i) cut_in_four(ball);

    Scene scene;
    scene.camera = Camera{{2, 1.5, 2.5}, {0, 0, 0}, {0, 1, 0}, 45};
    scene.lights = white_lights({{4, 5, 6}, {-6, 2, 3}});
    scene.materials.push_back({.name = "ball",
                               .colour{0.85, 0.6, 0.3},
                               .ambient = 0.1,
                               .diffuse = 0.8,
                               .highlight = 0.4,
                               .shine = shine_of(20)});
    scene.normals = ball.points;
    scene.vertices = std::move(ball.points);
    scene.triangles.reserve(ball.faces.size());
    for (const Face& face : ball.faces) scene.triangles.push_back({face, 0});
    return scene;
}

}   // namespace rayclock
