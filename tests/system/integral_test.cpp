// Integral geometry: of lines that are distributed evenly in place and direction, and that meet a convex
// body, the share that meets a smaller convex body in it is the ratio of their surfaces (Crofton). So the
// mean number of visits in a tree is known without a ray: the sum over its nodes' cells.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>

#include "model/core/layout.hpp"
#include "model/raygen/raygen.hpp"
#include "model/trace/decoder.hpp"
#include "tests/support/cases/draw.hpp"
#include "tests/system/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr double radius = 60000;   // of a ball around all that there is; what meets it is a line

struct Region {
    std::array<double, 3> lo{-radius, -radius, -radius}, hi{radius, radius, radius};
    Region cut(std::size_t axis, double at, bool upper) const {
        Region part = *this;
        (upper ? part.lo : part.hi)[axis] = upper ? std::max(lo[axis], at) : std::min(hi[axis], at);
        return part;
    }
    Region within(const Vec3i& from, const Vec3i& to) const {
        Region part = *this;
        for (std::size_t k = 0; k < 3; ++k)
            part = part.cut(k, double(from[k]), true).cut(k, double(to[k]), false);
        return part;
    }
    /// Its surface as a share of the ball's.
    double share() const {
        const double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        if (x < 0 || y < 0 || z < 0) return 0;
        return 2 * (x * y + y * z + z * x) / (4 * std::numbers::pi * radius * radius);
    }
};

class Tree {
public:
    Tree(const std::vector<PrimData>& prims, const Config& config)
        : config_(config), image_(compile_triangles(prims, config, "the case")), decoder_(image_, config) {}

    /// Visits that a line may expect below a node whose cell is `region`.
    double expected(std::uint32_t line, const Region& region) const {
        double sum = 0;
        if (config_.has_treelets()) {
            const WideTreelet& t = decoder_.treelet(line);
            const Region cell = t.open ? region : region.within(t.lo, t.hi);
            for (std::uint32_t child = 0; child < inner_of(t.exits); ++child) {
                Region part = cell;
                std::size_t plane = 0;
                for (int half = config_.node_width / 2; half > 0; half /= 2) {
                    const bool upper = t.exit[child] & half;
                    if (t.axis[plane] != no_axis) part = part.cut(t.axis[plane], t.at[plane], upper);
                    plane = 2 * plane + 1 + upper;
                }
                sum += part.share() + expected(t.exits.base + child, part);
            }
            return sum;
        }
        const auto node = unpack<Node>(image_.line(line), config_);
        for (std::uint32_t child = 0; child < inner_of(decoder_.node(line)); ++child) {
            Vec3i lo{}, hi{};
            for (std::size_t k = 0; k < 3; ++k) {
                lo[k] = node.org[k] + int(node.lo[3 * child + k] << node.exp[k]);
                hi[k] = node.org[k] + int(node.hi[3 * child + k] << node.exp[k]);
            }
            const Region part = region.within(lo, hi);
            sum += part.share() + expected(node.base + child, part);
        }
        return sum;
    }
    /// Visits of a ray that nothing ends.
    int visits(std::uint32_t line, const BoxRay& ray) const {
        std::array<std::uint32_t, max_width> t_near;
        const bool planes = config_.has_treelets();
        const WideNode& node = planes ? decoder_.treelet(line).exits : decoder_.node(line);
        const std::uint32_t hits = planes ? treelet_exits(ray, decoder_.treelet(line), config_, t_near.data())
                                          : box_children(ray, node, config_, t_near.data());
        int sum = 0;
        for (std::uint32_t child = 0; child < inner_of(node); ++child)
            if (hits >> child & 1) sum += 1 + visits(node.base + child, ray);
        return sum;
    }

    /// Of globes, which are not within each other as boxes are, each by itself: their surfaces.
    double globes(std::uint32_t line) const {
        const WideGlobes& node = decoder_.globes(line);
        double sum = 0;
        for (std::uint32_t child = 0; child < inner_of(node.children); ++child) {
            const double r = std::ldexp(node.radius[child], int(node.exp)) / radius;
            sum += r * r + globes(node.children.base + child);
        }
        return sum;
    }
    /// How many of them a ray meets.
    int met(std::uint32_t line, const GlobeRay& ray) const {
        std::array<std::uint32_t, max_width> t_near;
        const WideGlobes& node = decoder_.globes(line);
        const std::uint32_t hits = globe_children(ray, node, config_, t_near.data());
        int sum = std::popcount(hits & node.children.inner_mask);
        for (std::uint32_t child = 0; child < inner_of(node.children); ++child)
            sum += met(node.children.base + child, ray);
        return sum;
    }

private:
    static std::uint32_t inner_of(const WideNode& node) {
        return std::uint32_t(std::popcount(node.inner_mask));
    }

    Config config_;
    MemoryImage image_;
    Decoder decoder_;
};

std::vector<PrimData> triangles(std::uint32_t count) {
    Draw draw{9};
    std::vector<PrimData> prims;
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec3i middle{}, corner[3];
        for (int& x : middle) x = draw.between(-26000, 26000);
        for (Vec3i& c : corner)
            for (std::size_t k = 0; k < 3; ++k) c[k] = middle[k] + draw.between(-4000, 4000);
        prims.push_back({corner[0], corner[1], corner[2], i, 0});
    }
    return prims;
}

/// Lines through the ball: a direction, and a point of the disc at right angles to it.
class Lines {
public:
    explicit Lines(const Config& config) : config_(config) {}
    Ray next_ray() {
        const auto d = unit();
        auto side = unit();   // made at right angles
        const double along = d[0] * side[0] + d[1] * side[1] + d[2] * side[2];
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k) side[k] -= along * d[k], length += side[k] * side[k];
        const double off = radius * std::sqrt(even_(rng_)) / std::sqrt(length);
        Vec3i o{}, direction{};
        for (std::size_t k = 0; k < 3; ++k) {
            o[k] = int(std::lround(off * side[k] - radius * d[k]));
            direction[k] = int(std::lround(d[k] * ((1 << (config_.dir_bits - 1)) - 1)));
        }
        return make_ray(o, direction, config_);
    }
    BoxRay next() { return box_ray(next_ray()); }

private:
    std::array<double, 3> unit() {
        const double z = 2 * even_(rng_) - 1, turn = 2 * std::numbers::pi * even_(rng_),
                     r = std::sqrt(1 - z * z);
        return {r * std::cos(turn), r * std::sin(turn), z};
    }
    Config config_;
    std::mt19937_64 rng_{5};
    std::uniform_real_distribution<double> even_{0, 1};
};

/// The mean lies within four standard errors, and above by no more than what conservatism may cost, 2 %.
void check_visits(const Config& config, int lines) {
    INFO(structure_names()[std::size_t(config.structure)] << ", straddlers " << config.straddlers);
    const Tree tree(triangles(400), config);
    Lines drawn(config);
    const bool globes = config.has_globes();
    double sum = 0, squares = 0;
    for (int i = 0; i < lines; ++i) {
        const double n =
            globes ? tree.met(0, globe_ray(drawn.next_ray(), config)) : tree.visits(0, drawn.next());
        sum += n, squares += n * n;
    }
    const double mean = sum / lines, error = std::sqrt((squares / lines - mean * mean) / lines),
                 expected = globes ? tree.globes(0) : tree.expected(0, {});
    CAPTURE(mean, error, expected, mean / expected);
    CHECK(expected > 1);
    CHECK(mean >= expected - 4 * error);
    CHECK(mean <= expected * 1.02 + 4 * error);
}

void check_all(int lines) {
    Config config;
    for (const Structure structure : {Structure::bvh, Structure::spheres, Structure::kd, Structure::octree}) {
        config.structure = int(structure);
        for (const int width : {8, 2}) {
            config.node_width = width;
            config.stack_depth = 64;
            check_visits(config, lines);
        }
    }
    config.structure = int(Structure::octree);
    config.straddlers = int(Straddlers::inner);
    check_visits(config, lines);
}

}   // namespace

TEST_CASE("lines visit as many nodes as integral geometry says", "[structures][integral]") {
    check_all(10000);
}

TEST_CASE("a million lines visit as many nodes as integral geometry says", "[structures][integral][slow]") {
    check_all(1000000);
}
