// Compares positions with the values and sums that the scene description lists for the reference
// generator. Centres and axis ends of tessellated shapes are the means of their vertices.
#include <cmath>

#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"
#include "tests/scene/mesh_measures.hpp"

namespace rayclock::test::values_test {

using namespace rayclock;

namespace {

struct Sums {
    std::size_t points = 0;
    glm::dvec3 sum{0};
    double squares = 0, radii = 0;

    void add(const glm::dvec3& p) {
        ++points;
        sum += p;
        squares += glm::dot(p, p);
    }
};

/// Returns centre and radius of `count` vertices from `first` that are evenly distributed on a sphere or
/// circle.
std::pair<glm::dvec3, double> round_shape(const Scene& scene, std::size_t first, std::size_t count) {
    glm::dvec3 centre(0);
    for (std::size_t i = 0; i < count; ++i) centre += scene.vertices[first + i] / static_cast<double>(count);
    return {centre, glm::length(scene.vertices[first] - centre)};
}

void add_round(Sums& sums, const Scene& scene, std::size_t first, std::size_t count) {
    const auto [centre, radius] = round_shape(scene, first, count);
    sums.add(centre);
    sums.radii += radius;
}

void add_vertices(Sums& sums, const Scene& scene, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) sums.add(scene.vertices[i]);
}

void add_corners(Sums& sums, const Scene& scene, Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
        for (const std::uint32_t v : scene.triangles[i].vertex) sums.add(scene.vertices[v]);
}

/// Checks eight digits, as listed. Zero stands for the rounding error of a long sum.
void check_sums(const Sums& sums, std::size_t points, const glm::dvec3& sum, double squares, double radii) {
    CHECK(sums.points == points);
    for (int axis = 0; axis < 3; ++axis)
        CHECK(sums.sum[axis] == Approx(sum[axis]).epsilon(5e-8).margin(1e-8));
    CHECK(sums.squares == Approx(squares).epsilon(5e-8));
    CHECK(sums.radii == Approx(radii).epsilon(5e-8).margin(1e-12));
}

/// Checks a point; listed values have seven decimals.
void check_point(const glm::dvec3& p, const glm::dvec3& expected) {
    CAPTURE(p.x, p.y, p.z, expected.x, expected.y, expected.z);
    CHECK(glm::length(p - expected) < 1.2e-7);
}

constexpr std::size_t sphere = 56, ring = 12;   // vertices

}   // namespace

TEST_CASE("balls:4 is where the reference generator puts it", "[scene][values]") {
    const Scene scene = make_builtin("balls:4");
    Sums sums;
    add_vertices(sums, scene, 0, 4);
    for (std::size_t first = 4; first < scene.vertices.size(); first += sphere)
        add_round(sums, scene, first, sphere);
    check_sums(sums, 7385, {0, 0, 1470.1632}, 5570.2825, 60.5);

    const auto [second, second_radius] = round_shape(scene, 4 + sphere, sphere);
    check_point(second, {0.2721655, 0.2721655, 0.5443311});
    CHECK(second_radius == Approx(1.0 / 6).epsilon(1e-12));
    const auto [third, third_radius] = round_shape(scene, 4 + 2 * sphere, sphere);
    check_point(third, {0.4203137, 0.4203137, 0.6184051});
    CHECK(third_radius == Approx(1.0 / 18).epsilon(1e-12));
    const auto [last, last_radius] = round_shape(scene, scene.vertices.size() - sphere, sphere);
    check_point(last, {0.4364857, -0.5412422, -0.2222222});
    CHECK(last_radius == Approx(0.5 / 81).epsilon(1e-12));
}

TEST_CASE("gears:4 is where the reference generator puts it", "[scene][values]") {
    const Scene scene = make_builtin("gears:4");
    Sums sums;
    add_vertices(sums, scene, 0, 4);
    // A gear's vertex is a corner of one 144-gon and of two side quads.
    for (int times = 0; times < 3; ++times) add_vertices(sums, scene, 4, scene.vertices.size());
    check_sums(sums, 55300, {0, 0, 31795.2}, 59798.184, 0);
    check_point(scene.vertices[4], {-0.4819603, -0.7488284, 1});
    check_point(scene.vertices[5], {-0.4819603, -0.7316911, 1});
    // Teeth of neighbours interlock: every other gear is turned by half a tooth, along each axis.
    const double rho = 1 / 3.85, half_tooth = 3.14159265358979323846 / 36;
    for (std::size_t gear = 0; gear < 64; ++gear) {
        const std::size_t x = gear % 4, y = gear / 4 % 4, z = gear / 16;
        const glm::dvec3 centre(-1 + rho + 1.9 * rho * double(x), -1 + rho + 1.9 * rho * double(y),
                                1 - double(z) / 4);
        const double angle = (x + y + z) % 2 == 0 ? 0 : half_tooth;
        const glm::dvec3 *corner = &scene.vertices[4 + 288 * gear],
                         tooth = (corner[0] + corner[1]) / 2.0 - centre;
        CHECK(std::atan2(tooth.y, tooth.x) == Approx(angle).margin(1e-12));
        CHECK(tooth.z == Approx(0).margin(1e-15));
        CHECK(corner[0].z - corner[144].z == Approx(0.1).epsilon(1e-12));
    }
    REQUIRE(scene.materials.size() == 65);
    check_point(scene.materials[1].colour, {1, 0.6055227, 0.408284});
    CHECK(scene.materials[1].transmit == 0.8);
    check_point(scene.materials[2].colour, {1, 1, 1});
    CHECK(scene.materials[2].transmit == 0);
}

TEST_CASE("mount:6 is where the reference generator puts it", "[scene][values]") {
    const Scene scene = make_builtin("mount:6");
    Sums sums;
    for (std::size_t i = 0; i < 4; ++i) add_round(sums, scene, i * sphere, sphere);
    add_corners(sums, scene, {4 * 108, scene.triangles.size()});
    check_sums(sums, 24580, {-3.2, 3.2, 4888.7346}, 19401.033, 0.68);

    check_point(round_shape(scene, 0, sphere).first, {-0.8, 0.8, 1.2082066});
    check_point(round_shape(scene, sphere, sphere).first, {-0.6611956, 0.6611956, 0.9305978});
    check_point(round_shape(scene, 2 * sphere, sphere).first, {-0.7491941, 0.9896104, 0.9305978});
    check_point(round_shape(scene, 3 * sphere, sphere).first, {-0.9896104, 0.7491941, 0.9305978});

    double lowest = 1, highest = -1;
    std::map<std::pair<double, double>, double> heights;
    for (std::size_t i = 4 * sphere; i < scene.vertices.size(); ++i) {
        const glm::dvec3& p = scene.vertices[i];
        lowest = std::min(lowest, p.z);
        highest = std::max(highest, p.z);
        const auto [place, is_new] = heights.try_emplace({(p.x + 1) * 32, (p.y + 1) * 32}, p.z);
        if (!is_new) REQUIRE(place->second == p.z);   // neighbours agree bit for bit
    }
    CHECK(heights.size() == 65 * 65);
    CHECK(lowest == Approx(-0.7029533).margin(6e-8));
    CHECK(highest == Approx(0.9231396).margin(6e-8));
    CHECK(heights.at({32, 32}) == Approx(0.5295507).margin(6e-8));
    CHECK(heights.at({32, 0}) == Approx(-0.5481001).margin(6e-8));
    CHECK(heights.at({64, 32}) == Approx(0.6572437).margin(6e-8));
    CHECK(heights.at({16, 16}) == Approx(0.3436389).margin(6e-8));
    CHECK(heights.at({1, 1}) == Approx(-0.0073220).margin(6e-8));
    for (const double x : {0.0, 64.0})
        for (const double y : {0.0, 64.0}) CHECK(heights.at({x, y}) == 0);
}

TEST_CASE("rings:7 is where the reference generator puts it", "[scene][values]") {
    const Scene scene = make_builtin("rings:7");
    Sums sums;
    add_vertices(sums, scene, 0, 4);
    constexpr std::size_t link = 2 * ring + sphere;
    for (std::size_t first = 4; first < scene.vertices.size(); first += link) {
        add_round(sums, scene, first, ring);
        add_round(sums, scene, first + ring, ring);
        add_round(sums, scene, first + 2 * ring, sphere);
    }
    check_sums(sums, 12604, {-4, 184465.79, 2}, 3159283.9, 933.912);
    check_point(scene.vertices[0], {8.8389451, 20.9050074, 10.3389451});
    check_point(round_shape(scene, 4, ring).first, {0.9309947, 2.6131259, 0});
    check_point(round_shape(scene, 4 + ring, ring).first, {0.2876932, 1.7276974, 0});
    check_point(round_shape(scene, 4 + 5 * link, ring).first, {0.7531905, 3.1603509, 0});
}

TEST_CASE("teapot is where the reference generator puts it", "[scene][values]") {
    struct Case {
        std::size_t n, points;
        glm::dvec3 sum;
        double squares;
    };
    const auto c = GENERATE(values<Case>(
        {{6, 6912, {257.0625, 0, 11697.793}, 50010.22}, {12, 27936, {1022.5125, 0, 47243.436}, 201299.55}}));
    const Scene scene = make_builtin("teapot:" + std::to_string(c.n));
    Sums sums;
    for (std::size_t i = 0; i < c.n * c.n; ++i) {   // squares: 0 1 2, 2 3 0
        const auto &first = scene.triangles[2 * i].vertex, &second = scene.triangles[2 * i + 1].vertex;
        for (const std::uint32_t v : {first[0], first[1], first[2], second[1]}) sums.add(scene.vertices[v]);
    }
    add_corners(sums, scene, {2 * c.n * c.n, scene.triangles.size()});
    check_sums(sums, c.points, c.sum, c.squares, 0);
    if (c.n == 12) {
        const std::uint32_t v = scene.triangles[2 * 12 * 12].vertex[1];
        check_point(scene.vertices[v], {1.3874259, -0.1922407, 2.4});
        check_point(scene.normals[v], {-0.8949919, 0.118346, -0.4300973});
    }
}

TEST_CASE("tetra:6 is where the reference generator puts it", "[scene][values]") {
    const Scene scene = make_builtin("tetra:6");
    Sums sums;
    add_corners(sums, scene, whole(scene));
    check_sums(sums, 12288, {0, 0, 0}, 12312, 0);
    const auto& v = scene.triangles[0].vertex;
    CHECK(scene.vertices[v[0]] == glm::dvec3(-1, -1, 1));
    CHECK(scene.vertices[v[1]] == glm::dvec3(-1, -0.9375, 0.9375));
    CHECK(scene.vertices[v[2]] == glm::dvec3(-0.9375, -1, 0.9375));
}

TEST_CASE("tree:11 is where the reference generator puts it", "[scene][values]") {
    const Scene scene = make_builtin("tree:11");
    Sums sums;
    add_vertices(sums, scene, 0, 4);
    constexpr std::size_t branch = 2 * ring + sphere;
    double highest = 0;
    for (std::size_t first = 4; first < scene.vertices.size(); first += branch) {
        add_round(sums, scene, first, ring);
        add_round(sums, scene, first + ring, ring);
        add_round(sums, scene, first + 2 * ring, sphere);
        highest = std::max(highest, round_shape(scene, first + 2 * ring, sphere).first.z);
    }
    check_sums(sums, 12289, {2331.1376, 2480.6035, 30138.962}, 107404.95, 33.568418);
    const auto [second, second_radius] = round_shape(scene, 4 + branch + 2 * ring, sphere);
    check_point(second, {0.4178119, 0, 1.4979289});
    CHECK(second_radius == Approx(0.067335).epsilon(1e-9));
    const auto [last, last_radius] = round_shape(scene, scene.vertices.size() - sphere, sphere);
    check_point(last, {-0.3069131, 0.5377147, 3.1362592});
    CHECK(last_radius == Approx(0.0012274).margin(6e-8));
    CHECK(highest == Approx(3.1362592).margin(6e-8));
}

TEST_CASE("cones are cut where the description says", "[scene][values]") {
    // The trunk is parallel to z: angle 0 is towards e_z x e_x = e_y; normals tilt up by the taper.
    const Scene scene = make_builtin("tree:1");
    check_point(scene.vertices[4], {0, 0.15, 0});
    check_point(scene.vertices[4 + 3], {-0.15, 0, 0});
    check_point(scene.vertices[4 + 12], {0, 0.67 * 0.15, 1});
    const double taper = 0.33 * 0.15;
    check_point(scene.normals[4], glm::dvec3(0, 1, taper) / std::sqrt(1 + taper * taper));
}

TEST_CASE("spheres are cut at equal angles", "[scene][values]") {
    // The middle of a cube side at factor 3: grid lines at -15 and 15 degrees; also a corner and an edge
    // point.
    const Scene scene = make_builtin("balls:1");
    const double t = std::tan(3.14159265358979323846 / 12);
    for (const glm::dvec3& wanted :
         {glm::dvec3(t, -t, 1), {1, t, t}, {-1, -1, -1}, {1, 1, t}, {-t, -1, -1}}) {
        std::size_t found = 0;
        for (std::size_t i = 0; i < sphere; ++i)
            found += glm::length(scene.vertices[4 + i] * 2.0 - glm::normalize(wanted)) < 1e-12;
        CHECK(found == 1);
    }
}

}   // namespace rayclock::test::values_test
