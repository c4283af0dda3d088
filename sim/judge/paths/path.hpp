#pragma once
// Follows one pixel of a chip that shades from its first camera ray to its colour, and judges every step.
//
// There are three kinds of judgement. *Exact*: which primitive a ray meets, where a secondary ray begins, on
// which side it leaves, whether a light or a bounce is requested, sums and their saturation. These are
// integers of 128 bits. *Rounded as documented*: products that docs/machine/shading.md rounds to nearest,
// computed from the chip's own factors. *Within a proven bound*: unit vectors, powers, directions of bounces
// and colours, compared with doubles that follow from the same hit. Each contribution to the pixel has its
// own range, and the pixel must lie within the sum of these ranges.
#include <optional>
#include <string>
#include <vector>

#include "model/unit/shade/shader.hpp"
#include "sim/judge/paths/answer.hpp"
#include "sim/judge/paths/placed.hpp"
#include "sim/judge/paths/arithmetic.hpp"
#include "sim/judge/paths/texture.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

/// The inputs that all threads share to judge a path.
struct PathRules {
    const FrameInputs& inputs;   ///< with the compiled scene
    const Whitted& settings;
    const std::vector<oracle::Solid>& primitives;
    const oracle::Solids& solids;
    const PlacedWorld* placed = nullptr;   ///< with two levels; replaces `primitives` and `solids`
};

/// The first fault of a pixel, and its ray.
struct PathFault {
    std::string what;
    int ray = 0;   ///< number within the pixel, from 0
};

class PathJudge final : public ShadeWatch, private Cutouts {
public:
    explicit PathJudge(const PathRules& rules)
        : rules_(rules), config_(rules.inputs.config), frame_(rules.inputs.frame) {}

    void start(std::uint32_t x, std::uint32_t y);
    void sent(const Ray& ray) override;
    void answered(const Closest& hit) override;
    void passed(const PassIn& in, const PassOut& out) override;
    void filtered(const TexReq& hit, const TexRecord& record, const TexelPlace& place,
                  const TexRsp& answer) override;
    /// Judges the colour that the machine gave to the finished pixel.
    void finish(const std::array<std::uint32_t, 3>& colour);

    /// Records a fault of the pixel. Only the first counts.
    void fail(const char* what);
    bool is_wrong() const { return !fault_.what.empty(); }
    const PathFault& fault() const { return fault_; }
    const RayCounts& rays() const { return rays_; }   ///< judged rays of all pixels
    /// Returns half the widest range of a pixel's colour, in units of 2^-unit_bits.
    double widest() const { return widest_; }
    /// Returns the range of each channel of the last pixel's colour.
    std::array<Range, 3> bounds() const {
        return {exact_pixel_[0].clamped(0, 1), exact_pixel_[1].clamped(0, 1), exact_pixel_[2].clamped(0, 1)};
    }

private:
    using Colour = std::array<std::uint32_t, 3>;
    using Light = std::array<Range, 3>;
    /// A ray that the path must send next.
    struct Expected {
        RayKind kind = RayKind::camera;
        Vec3i o{}, d{};
        std::uint32_t self = 0, is_inside = 0;
        bool is_partial = false, is_refracted = false;
        Home home{};
        std::uint32_t holes = 0;   ///< of a shadow ray: number of cut-outs that it ignores
    };
    /// The current bounce, or a waiting one: the weight of its colour, and its depth.
    struct Branch {
        Expected ray;
        std::uint32_t weight = 0;
        std::uint32_t depth = 0;
        std::uint32_t cell = 0;   ///< one bit for each pane between it and the eye
        std::uint32_t path = 0;   ///< with textures: length of the path to its origin
        Range exact{1, 1};        ///< its weight from the materials, unrounded
    };
    /// The surface that the last bounce met: the values of the chip, and the exact ones.
    struct BouncePoint {
        Surface surface;
        glm::dvec3 normal{0}, view{0};   ///< unit vectors
        bool is_far = false, is_lost = false;
        std::uint32_t pane = 0;   ///< the surface's bit in a cell
        std::optional<TexturedSurface> texture;
        double ratio = 1;                     ///< refractive index on the ray's side over that on the other
        double normal_error = vector_error;   ///< error bound of the chip's unit normal
        /// Returns the error bound of the normal's product with another unit vector.
        double cosine_error() const {
            return normal_error + vector_error + normal_error * vector_error + 0.5 * unit_step;
        }
    };
    /// With two levels: the instance that was hit last, and the ray in its space.
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
        bool is_beyond = false;   ///< the origin lies beyond the lattice; the ray meets planes only
    };
    std::optional<Start> bounce_start_of(const ShadeState& s, const Vec3i& d, bool through) const;
    void demand_lights(const ShadeState& s);
    void transform(const PassIn& in, const PassOut& out);
    void demand_scale(const TexReq& hit, std::uint32_t place);
    void demand_texture(const ShadeState& s, const PassOut& out);
    void texture(const PassIn& in, const PassOut& out);
    std::optional<TexturedSurface> textured(std::uint32_t primitive) const;
    bool has_holes(std::uint32_t primitive) const override;
    bool is_passed(std::uint32_t primitive) const override;
    void cutout(const PassIn& in, const PassOut& out);
    void event(const PassIn& in, const PassOut& out);
    Vec3i point_at(const PassIn& in) const;
    Home home_of(const ShadeState& s, const Vec3i& d) const;
    Home home_from(const ShadeState& s, const Vec3i& light) const;
    /// True if the hit lies in an instance whose map is not the identity.
    bool is_turned() const {
        return visit_.place != oracle::PlacedRay::nowhere && !rules_.placed->is_same(visit_.place);
    }
    const Vec3i& way_of(const Expected& ray) const { return is_turned() ? ray.home.d : ray.d; }
    void ambient(const ShadeState& s);
    void background(std::uint32_t weight, const Range& exact);

    void light(const PassIn& in, const PassOut& out, std::uint32_t number);
    void judge_light_parts(const ShadeState& s, const LightParts& parts, const Vec3l& way);
    static Range power_range(const Range& base, std::uint32_t shine);
    void judge_share(const ShadeState& s, const LightParts& parts, const glm::dvec3& way);

    void refract(const PassIn& in, const PassOut& out);
    void reflect(const PassIn& in, const PassOut& out);
    /// A factor of a weight: the chip's rounded value with unit_bits of fraction, and the exact range.
    struct Share {
        Int128 promised = 0;
        Range exact;
    };
    /// The ranges of Snell's law at the surface that was hit.
    struct ExactBend {
        Range cosine_squared, ratio, along;
    };
    Share schlick(const ShadeState& s) const;
    ExactBend exact_bend() const;
    void judge_total(bool total);
    void judge_reflected(const Vec3i& d);
    void judge_refracted(const Vec3i& d);
    /// A bounce's weight: the chip's rounded value, and the exact range.
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
    bool fresh_ = true;      ///< the path has made no pass yet
    ShadeState last_;        ///< the state after the last pass
    Ray bounce_ray_, ray_;   ///< the last camera ray or bounce; the last ray of any kind
    Closest answer_;
    Expected expected_;
    Branch branch_;
    BouncePoint place_;
    Visit visit_;
    std::vector<Branch> waiting_;
    bool lit_if_free_ = false,
         lit_ = false;   ///< the last light's share is added if its shadow ray is free, or in any case
    Light share_;        ///< that light's share, unrounded
    Colour colour_{};    ///< the sample's colour as the chip sums it
    Light exact_{};      ///< the same, unrounded and before saturation
    Colour sum_{}, least_{}, most_{};
    Light exact_sum_{};
    std::uint32_t sample_ = 0;
    std::uint32_t path_ = 0;                   ///< with textures: length of the path so far
    std::uint32_t holes_ = 0;                  ///< of textures, which the ray has passed
    std::optional<TexRsp> texel_;              ///< the last answer of tex
    std::optional<TexturedSurface> cutout_;    ///< that the last shadow ray has met
    std::vector<std::uint32_t> light_holes_;   ///< cut-outs through whose holes the light has passed
    Colour pixel_{};
    Light exact_pixel_{};
};

}   // namespace rayclock
