// Integral geometry (Crofton): lines are distributed uniformly in place and direction and meet a convex body.
// The share that meets a smaller convex body inside it is the ratio of their surfaces. So the mean number of
// visits in a tree follows without rays, as a sum over its nodes' cells.
#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <numbers>

#include "model/compile/compile.hpp"
#include "model/core/layout.hpp"
#include "model/trace/decoder.hpp"
#include "tests/support/geometry/lines.hpp"

namespace rayclock::test::integral_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Region {
    std::array<double, 3> lo{-ball_radius, -ball_radius, -ball_radius},
        hi{ball_radius, ball_radius, ball_radius};
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
    /// Returns its surface relative to the ball's.
    double share() const {
        const double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        if (x < 0 || y < 0 || z < 0) return 0;
        return 2 * (x * y + y * z + z * x) / (4 * std::numbers::pi * ball_radius * ball_radius);
    }
};

class Tree {
public:
    Tree(const std::vector<PrimData>& prims, const Config& config)
        : config_(config), image_(compile_triangles(prims, config, "the case")), decoder_(image_, config) {}

    /// Returns the expected visits of a line below a node whose cell is `region`.
    double expected(std::uint32_t line, const Region& region) const {
        double sum = 0;
        if (config_.is_walked(Structure::kd)) {
            const WideTreelet& t = decoder_.node<kd::Engine>(line);
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
        for (std::uint32_t child = 0; child < inner_of(decoder_.node<bvh::Engine>(line)); ++child) {
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
    /// Returns the visits of an unlimited ray.
    int visits(std::uint32_t line, const BoxRay& ray) const {
        std::array<std::uint32_t, max_width> t_near;
        const bool planes = config_.is_walked(Structure::kd);
        const WideNode& node =
            planes ? decoder_.node<kd::Engine>(line).exits : decoder_.node<bvh::Engine>(line);
        const std::uint32_t hits =
            planes ? treelet_exits(ray, decoder_.node<kd::Engine>(line), config_, t_near.data())
                   : box_children(ray, node, config_, t_near.data());
        int sum = 0;
        for (std::uint32_t child = 0; child < inner_of(node); ++child)
            if (hits >> child & 1) sum += 1 + visits(node.base + child, ray);
        return sum;
    }

    /// Returns the sum of the surfaces of globes. Globes are not nested like boxes, so each counts
    /// separately.
    double globes(std::uint32_t line) const {
        const WideGlobes& node = decoder_.node<spheres::Engine>(line);
        double sum = 0;
        for (std::uint32_t child = 0; child < inner_of(node.children); ++child) {
            const double r = std::ldexp(node.radius[child], int(node.exp)) / ball_radius;
            sum += r * r + globes(node.children.base + child);
        }
        return sum;
    }
    /// Returns how many of them a ray meets.
    int met(std::uint32_t line, const GlobeRay& ray) const {
        std::array<std::uint32_t, max_width> t_near;
        const WideGlobes& node = decoder_.node<spheres::Engine>(line);
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

void check_visits(const Config& config, int lines) {
    INFO(name_of(config.structure) << ", straddlers " << name_of(config.straddlers));
    const Tree tree(triangles(400, 26000, 4000), config);
    Lines drawn(config);
    const bool globes = config.is_walked(Structure::spheres);
    Mean visits;
    for (int i = 0; i < lines; ++i)
        visits.add(globes ? tree.met(0, globe_ray(drawn.next(), config))
                          : tree.visits(0, box_ray(drawn.next())));
    const double expected = globes ? tree.globes(0) : tree.expected(0, {});
    CHECK(expected > 1);
    visits.check(expected, expected);
}

void check_all(int lines) {
    Config config;
    for (const Structure structure : {Structure::bvh, Structure::spheres, Structure::kd, Structure::octree}) {
        config.structure = structure;
        for (const int width : {8, 2}) {
            config.node_width = width;
            config.stack_depth = 64;
            check_visits(config, lines);
        }
    }
    config.structure = Structure::octree;
    config.straddlers = Straddlers::inner;
    check_visits(config, lines);
}

}   // namespace

TEST_CASE("lines visit as many nodes as integral geometry says", "[structures][integral]") {
    check_all(10000);
}

TEST_CASE("a million lines visit as many nodes as integral geometry says", "[structures][integral][slow]") {
    check_all(1000000);
}

}   // namespace rayclock::test::integral_test
