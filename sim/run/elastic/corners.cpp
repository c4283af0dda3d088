// Moves recorded requests to corners.
#include "sim/run/elastic/corners.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/engine/engines.hpp"
#include "model/machine/links.hpp"
#include "model/unit/tri/sheared.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

namespace {

/// Returns the largest signed number of this many bits.
std::int32_t most_of(int bits) { return std::int32_t((std::int64_t(1) << (bits - 1)) - 1); }

/// Moves operands. Every fourth one moves.
class Mover {
public:
    explicit Mover(std::mt19937_64& random) : random_(random) {}

    bool chance() { return random_() % 4 == 0; }
    std::uint32_t below(std::uint32_t n) { return std::uint32_t(random_() % n); }

    /// Moves a signed number of this many bits to an end, next to one, near zero, or to one of `others`.
    template <class... Other> void move(std::int32_t& value, int bits, Other... others) {
        if (!chance()) return;
        const std::int32_t most = most_of(bits);
        const std::int32_t corners[] = {0, 1, -1, most, -most - 1, most - 1, -most, others...};
        const std::int32_t corner = corners[below(std::uint32_t(std::size(corners)))];
        if (corner <= most && corner >= -most - 1) value = corner;
    }
    /// Moves an unsigned number.
    void move(std::uint32_t& value, int bits) {
        if (!chance()) return;
        const std::uint32_t most = (1u << bits) - 1, corners[] = {0, 1, most, most - 1, 1u << (bits - 1)};
        value = corners[below(std::uint32_t(std::size(corners)))];
    }
    /// Moves both ends of a range, and keeps their order.
    template <class T> void move_range(T& low, T& high, int bits) {
        move(low, bits), move(high, bits);
        if (chance()) high = low;
        if (high < low) std::swap(low, high);
    }

private:
    std::mt19937_64& random_;
};

void to_corner(TriReq& request, const Config& config, Mover& mover) {
    PrimData& t = request.triangle;
    const auto move = [&](Vec3i& v, int bits) {
        for (std::size_t k = 0; k < 3; ++k) mover.move(v[k], bits, v[(k + 1) % 3], t.a[k], t.b[k]);
    };
    for (Vec3i* v : {&request.o, &t.a, &t.b, &t.c}) move(*v, config.coord_bits);
    move(request.d, config.dir_bits);
    if (config.is_sheared()) request.shear = shear_of(request.d, config);
}

void move_node(Node& node, const Config& config, Mover& mover) {
    for (std::size_t k = 0; k < 3; ++k) {
        mover.move(node.org[k], config.coord_bits);
        if (mover.chance())
            node.exp[k] = mover.below(2) * std::uint32_t(config.coord_bits - config.box_bits + 1);
        for (std::size_t child = 0; child < std::size_t(config.node_width); ++child)
            mover.move_range(node.lo[3 * child + k], node.hi[3 * child + k], config.box_bits);
    }
}

void move_node(GlobeNode& node, const Config& config, Mover& mover) {
    if (mover.chance()) node.exp = mover.below(2) * std::uint32_t(config.coord_bits - globe_bits + 1);
    for (std::int32_t& org : node.org) mover.move(org, config.coord_bits);
    for (std::size_t child = 0; child < std::size_t(config.node_width); ++child) {
        mover.move(node.radius[child], globe_bits);
        for (std::size_t k = 0; k < 3; ++k) mover.move(node.centre[3 * child + k], globe_bits);
    }
}

/// Moves the parts of a node of planes that all engines share.
template <class Planes> void move_box(Planes& node, const Config& config, Mover& mover) {
    if (mover.chance()) node.open ^= 1;
    for (std::size_t k = 0; k < 3; ++k) mover.move_range(node.lo[k], node.hi[k], config.coord_bits);
}

void move_node(Slant& node, const Config& config, Mover& mover) {
    move_box(node, config, mover);
    const std::int32_t steepest = most_of(normal_step_bits);
    for (std::size_t i = 0; i < std::size_t(config.planes_of_node()); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            std::int32_t& part = node.normal[3 * i + k];
            mover.move(part, normal_step_bits);
            part = std::max(part, -steepest);
        }
        mover.move(node.at[i], config.offset_of_plane_bits());
    }
}

template <class Planes> void move_node(Planes& node, const Config& config, Mover& mover) {
    move_box(node, config, mover);
    for (std::size_t i = 0; i < std::size_t(config.planes_of_node()); ++i) {
        if (mover.chance()) node.axis[i] = mover.below(3);
        if constexpr (requires { node.at; })
            mover.move(node.at[i], config.coord_bits);
        else
            mover.move(node.lower_to[i], config.coord_bits),
                mover.move(node.upper_from[i], config.coord_bits);
    }
}

/// Returns a ray of any kind that a unit for nodes gets, from the recorded origin or a corner.
Ray ray_from(Vec3i o, const Config& config, Mover& mover) {
    const auto kind = RayKind(config.shading ? mover.below(3) : 0);
    const int frac = config.origin_frac();
    const int bits = kind == RayKind::shadow ? config.ray_dir_bits() : config.dir_bits;
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k) {
        std::int32_t whole = o[k] >> frac;
        mover.move(whole, config.coord_bits);
        const std::int32_t part = kind == RayKind::bounce ? std::int32_t(mover.below(1u << frac)) : 0;
        o[k] = whole * (1 << frac) + part;
        d[k] = std::int32_t(mover.below(1u << bits)) - most_of(bits) - 1;
        mover.move(d[k], bits);
        if (mover.chance()) d[k] >>= mover.below(std::uint32_t(bits));   // any length
    }
    if (d == Vec3i{}) d[0] = -1;
    return make_ray(o, d, config, kind);
}

template <class Request, class Answer> void write(const Request& request, const Answer& answered,
                                                  const Config& config, Words& words, Words& answer) {
    words = pack(request, config);
    answer = pack(answered, config);
}

}   // namespace

bool has_corners(Unit unit, const Config& config) {
    if (config.has_instances()) return false;
    return is_node_unit(unit) || (unit == Unit::tri && !config.shading);
}

void to_corner(Unit unit, Words& words, Words& answer, const Config& config, std::mt19937_64& random) {
    Mover mover(random);
    if (unit == Unit::tri) {
        TriReq request = unpack<TriReq>(words.data(), config);
        to_corner(request, config, mover);
        return write(request, tri(request, config), config, words, answer);
    }
    for_each_engine([&]<class E>(E) {
        if (node_unit(E::structure).unit != unit) return;
        const auto recorded = unpack<typename E::Request>(words.data(), config);
        auto node = recorded.node;
        move_node(node, config, mover);
        const Ray ray = ray_from(recorded.o, config, mover);
        const auto request = E::request(recorded.ray, E::form(ray, box_ray(ray), config), node);
        write(request, E::answer(request, config), config, words, answer);
    });
}

}   // namespace rayclock
