#pragma once
// Follows one pixel of a chip that shades from its first camera ray to its colour, and judges every step.
//
// Three kinds of judgement. *Exact*: which primitive a ray meets, where a secondary ray begins, on which side
// it leaves, whether a light or a bounce is asked for, sums and their saturation: whole numbers of 128 bits.
// *To the bit, as promised*: products that docs/shading.md rounds to nearest, from the factors that the chip
// had. *Within a proven bound*: unit vectors, powers, directions of bounces and colours against what doubles
// work out from the same hit. Each contribution to the pixel has its own range, and the pixel must lie within
// their sum.
#include <optional>
#include <string>
#include <vector>

#include "model/unit/shade/shader.hpp"
#include "sim/judge/paths/placed.hpp"
#include "sim/judge/paths/steps.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

/// What a path is judged by; shared by all threads.
struct PathRules {
    const Asked& asked;   ///< with the scene as it was compiled
    const Whitted& settings;
    const std::vector<oracle::Solid>& primitives;
    const oracle::Solids& solids;
    const PlacedWorld* placed = nullptr;   ///< of two levels, in place of the last two
};

/// What was wrong first, and where.
struct PathFault {
    std::string what;
    int ray = 0;   ///< of its pixel, from 0
};

class PathJudge final : public ShadeWatch {
public:
    explicit PathJudge(const PathRules& rules)
        : rules_(rules), config_(rules.asked.config), frame_(rules.asked.frame) {}

    void start(std::uint32_t x, std::uint32_t y);
    void sent(const Ray& ray) override;
    void answered(const Closest& hit) override;
    void passed(const PassIn& in, const PassOut& out) override;
    /// The pixel is done, and the machine gave this colour.
    void finish(const std::array<std::uint32_t, 3>& colour);

    /// Something is wrong with the pixel; the first that is said counts.
    void fail(const char* what);
    bool is_wrong() const { return !fault_.what.empty(); }
    const PathFault& fault() const { return fault_; }
    const RayCounts& rays() const { return rays_; }   ///< judged, of all pixels
    double widest() const {
        return widest_;
    }   ///< half the widest range of a pixel's colour, in units of 2^-unit_bits
    /// In which each channel of the last pixel's colour must lie.
    std::array<Range, 3> bounds() const {
        return {exact_pixel_[0].clamped(0, 1), exact_pixel_[1].clamped(0, 1), exact_pixel_[2].clamped(0, 1)};
    }

private:
    using Colour = std::array<std::uint32_t, 3>;
    using Light = std::array<Range, 3>;
    /// A ray that was asked for and is not yet under way.
    struct Expected {
        RayKind kind = RayKind::camera;
        Vec3i o{}, d{};
        std::uint32_t self = 0, inside = 0;
        bool is_partial = false, is_refracted = false;
        Home home{};
    };
    /// The bounce under way, or one that waits: what its colour counts, and how deep it is.
    struct Branch {
        Expected ray;
        std::uint32_t weight = 0;
        std::uint32_t depth = 0;
        std::uint32_t cell = 0;   ///< the panes between it and the eye, a bit each
        Range exact{1, 1};        ///< its weight from the materials, not rounded
    };
    /// Where the last bounce met a surface: as the chip has it, and the truth.
    struct BouncePoint {
        Surface surface;
        glm::dvec3 normal{0}, view{0};   ///< unit vectors
        bool is_far = false, is_lost = false;
        std::uint32_t pane = 0;               ///< its bit in a cell
        double ratio = 1;                     ///< of the refractive indices, on the ray's side over the other
        double normal_error = vector_error;   ///< of the chip's unit normal
        /// Of a product of the normal with another unit vector.
        double cosine_error() const {
            return normal_error + vector_error + normal_error * vector_error + 0.5 * unit_step;
        }
    };
    /// With two levels: the instance that was hit last, and the ray as it sees it.
    struct Visit {
        std::uint32_t place = oracle::PlacedRay::nowhere;
        oracle::SolidRay ray;
    };

    void demand(bool holds, const char* what) {
        if (!holds) fail(what);
    }
    void add(const Colour& colour, const Light& exact);
    void judge_camera(const Ray& ray);

    void arrive(const PassIn& in, const PassOut& out);
    void judge_place(const PassIn& in, const ShadeState& s);
    void judge_flat_place(const PassIn& in, const ShadeState& s, Vec3l& toward);
    void judge_sphere_place(const PassIn& in, const ShadeState& s);
    void judge_vectors(const PassIn& in, const ShadeState& s, const Vec3l& toward);
    Colour expected_albedo(const Surface& surface) const;
    std::optional<Vec3i> start_of(const ShadeState& s, const Vec3i& d) const;
    struct Start {
        Vec3i o{};
        bool is_beyond = false;   ///< of the lattice: it asks planes alone
    };
    std::optional<Start> bounce_start_of(const ShadeState& s, const Vec3i& d, bool through) const;
    void demand_lights(const ShadeState& s);
    void turn(const PassIn& in, const PassOut& out);
    Vec3i point_at(const PassIn& in) const;
    Home home_of(const ShadeState& s, const Vec3i& d) const;
    Home home_from(const ShadeState& s, const Vec3i& light) const;
    /// What was hit lies in an instance that turns rays. Where none is turned, all is as in one level.
    bool is_turned() const {
        return visit_.place != oracle::PlacedRay::nowhere && !rules_.placed->is_same(visit_.place);
    }
    const Vec3i& way_of(const Expected& ray) const { return is_turned() ? ray.home.d : ray.d; }
    void ambient(const ShadeState& s);
    void background(std::uint32_t weight, const Range& exact);

    void light(const PassIn& in, const PassOut& out);
    void judge_light_parts(const ShadeState& s, const LightParts& parts, const Vec3l& way);
    static Range power_range(const Range& base, std::uint32_t shine);
    void judge_share(const ShadeState& s, const LightParts& parts, const glm::dvec3& way);

    void refract(const PassIn& in, const PassOut& out);
    void reflect(const PassIn& in, const PassOut& out);
    /// Part of a weight: as promised, unit_bits of fraction, and exactly.
    struct Share {
        Int128 promised = 0;
        Range exact;
    };
    /// Snell's law for the surface that was hit: what each part may be.
    struct ExactBend {
        Range cosine_squared, ratio, along;
    };
    Share schlick(const ShadeState& s) const;
    ExactBend exact_bend() const;
    void judge_total(bool total);
    void judge_reflected(const Vec3i& d);
    void judge_refracted(const Vec3i& d);
    /// Of a bounce: as promised, and exactly.
    struct Weight {
        std::uint32_t promised = 0;
        Range exact;
    };
    Weight weight_of(const Share& share) const;
    bool follows(const Weight& weight);
    std::int32_t direction_component(Int128 unit) const;
    Branch bounce(const ShadeState& s, const Weight& weight, const Start& start, const Vec3i& d,
                  bool through) const;

    void pop(const PassIn& in, const PassOut& out);
    void end_sample(const PassOut& out);
    ShadeEvent after_lights(const ShadeState& s) const;
    void expect_spawn(const PassOut& out, const Expected& ray);

    const PathRules& rules_;
    const Config& config_;
    const Frame& frame_;
    PathFault fault_;
    RayCounts rays_;
    double widest_ = 0;

    std::uint32_t x_ = 0, y_ = 0;
    int ray_number_ = 0;
    bool fresh_ = true;      ///< no pass has been made yet
    ShadeState last_;        ///< after the last pass
    Ray bounce_ray_, ray_;   ///< the last camera ray or bounce; the last of all
    Closest answer_;
    Expected expected_;
    Branch branch_;
    BouncePoint place_;
    Visit visit_;
    std::vector<Branch> waiting_;
    bool lit_if_free_ = false,
         lit_ = false;   ///< the last light's share is added if its ray is free, or for certain
    Light share_;        ///< of that light, not rounded
    Colour colour_{};    ///< of the sample, as the chip sums it
    Light exact_{};      ///< the same, not rounded and not yet saturated
    Colour sum_{}, least_{}, most_{};
    Light exact_sum_{};
    std::uint32_t sample_ = 0;
    Colour pixel_{};
    Light exact_pixel_{};
};

}   // namespace rayclock
