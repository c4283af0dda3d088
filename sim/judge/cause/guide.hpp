#pragma once
// Guides the reference tracer along a machine's path through one pixel, and reports where the two disagree.
//
// This is the last stage (finished.hpp). The reference has the machine's scene: corners,
// spheres, planes and lights on the lattice, colours and weights with the machine's bits. It follows the
// machine's rays, after checking that each lies within a bound of the ray that the reference would have sent.
// The reference makes every decision by its own rules: which primitive a ray meets and on which side, which
// normal counts there, which lights count and what blocks them, which bounces leave. So it finds a wrong
// *rule* of the machine, even if the machine's judge follows the same rule.
//
// The two may differ where doubles or a stated rounding leave a decision open. Then the reference follows the
// machine, and the step is counted:
//   tie      a ray moved by 2^-34 of its length, or a quantity within its stated bound, gives the machine's
//            answer
//   horizon  a bounce from a point of a plane beyond the lattice meets another plane before it comes into
//            the lattice, or the point is too far away for the machine's numbers (docs/proofs/origins.md,
//            Points of a plane beyond the lattice)
//   seam     two levels: the instance sees a ray that was rounded for it (seam.hpp)
// Anything else is a fault.
#include <optional>
#include <string>

#include "sim/judge/cause/camera_ray.hpp"
#include "sim/judge/cause/machine_path.hpp"
#include "sim/judge/cause/seam.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/reference/steer.hpp"

namespace rayclock {

/// The data that all pixels share.
struct GuideRules {
    const FrameInputs& inputs;             ///< the frame; the scene as given
    const Scene& scene;                    ///< the machine's scene, in the given scene's units
    const Reference& reference;            ///< traces `scene`
    const CameraBound& camera;             ///< the bound of the picture's camera rays
    double spread = 0;                     ///< sample_spread() of the picture
    double contrast = 0;                   ///< of samples, below which sampling ends
    const PlacedWorld* placed = nullptr;   ///< null with one level
    const SeamFinder* seams = nullptr;
};

/// The result for one path.
struct GuideFinding {
    std::string fault;   ///< the first fault, or empty
    std::uint32_t ties = 0;
    bool has_horizon = false, has_seam = false;
    bool has_texture = false;   ///< a texture's coordinates, level or texels are rounded
    bool has_lost = false;      ///< a point lies too far beyond the lattice for the machine's numbers
};

class Guide final : public RefSteer {
public:
    /// `sample_width`: the largest allowed difference between the machine's and the reference's colour of a
    /// sample.
    Guide(const GuideRules& rules, const MachinePath& path, double sample_width)
        : rules_(rules), path_(path), sample_width_(sample_width) {}
    /// Ends the pixel. All of the machine's path must have been followed.
    void finish();
    const GuideFinding& finding() const { return finding_; }

    void begin_sample(std::uint32_t sample, RefPath& path) override;
    bool ends_sampling(std::uint32_t samples, double difference, bool own) override;
    RefClosest choose_hit(const RefPath& path, const RefClosest& own) override;
    void round_corners(RefClosest& hit, std::array<glm::dvec3, 3>& normals, bool is_open) override;
    glm::dvec3 plane_colour(const RefClosest& hit, const Material& material, const glm::dvec3& own) override;
    void texel(const RefClosest& hit, const RefSurface& surface, RefTexel& own) override;
    void move_ray_origin(RefSurface& surface) override;
    bool light_counts(std::size_t light, double side, double lambert) override;
    bool is_blocked(std::size_t light, const RefPath& path, double distance, bool own) override;
    bool is_total(const RefSurface& surface, double ratio, double cosine, bool own) override;
    bool accept_bounce(RefBounce& bounce) override;
    void enter(RefBounce::Interaction interaction) override;
    void leave() override { at_.pop_back(); }

private:
    /// Returns the machine's visit at the reference's current position; null if the machine sent no ray.
    const MachineVisit* visit() const {
        return at_.empty() || at_.back() < 0 ? nullptr : &path_.visits[std::size_t(at_.back())];
    }
    void fail(std::string what);
    void tie() { ++finding_.ties; }

    /// Converts from the scene's lattice to the tracer's space.
    glm::dvec3 point(const Vec3l& p, int frac) const;
    glm::dvec3 direction(const Vec3i& d) const;   ///< unit
    double step() const;                          ///< lattice step in the tracer's space
    bool is_turned(const MachineVisit& at) const;
    double normal_error(const MachineVisit& at) const;
    double direction_error(const RefBounce& bounce, const MachineVisit& at) const;
    void round_normals(const MachineVisit& at, std::array<glm::dvec3, 3>& normals);
    bool points_outwards(const MachineVisit& at) const;
    // Textures: guide_texture.cpp.
    struct TexturePlace;
    TexturePlace place_on_triangle(const MachineVisit& at, const RefClosest& hit, const RefTexel& own) const;
    TexturePlace place_on_sphere(const MachineVisit& at, const RefClosest& hit) const;
    TexturePlace place_on_plane(const MachineVisit& at, const RefClosest& hit, const Texture& texture) const;
    TexturePlace texture_place(const MachineVisit& at, const RefClosest& hit, const Texture& texture,
                               const RefTexel& own) const;
    double extra_distance(const MachineVisit& at, const RefClosest& hit) const;
    void judge_level(int level, const TexturePlace& place, const Texture& texture, const RefTexel& own);

    /// Returns the weights of the second and third corner at the point from which rays leave.
    std::array<double, 2> weights(const MachineVisit& at) const;
    /// Returns the machine's hit, from which the path continues.
    RefClosest as_machine(const RefPath& path, const MachineVisit& at);
    std::optional<RefClosest> find_tie(const RefPath& path, const RefClosest& own,
                                       std::uint32_t wanted) const;
    RefPath from_far(const RefPath& path, const MachineVisit& at);
    RefPath from_own(const RefPath& path, double distance) const;
    double flat_error(const MachineVisit& at, const glm::dvec3& normal) const;
    double sphere_error(const MachineVisit& at, std::uint32_t primitive) const;   ///< steps
    bool is_within_root(const RefPath& path, const RefClosest& own, const MachineVisit& at) const;
    bool is_beyond_horizon(const RefPath& path, const RefClosest& own, const MachineVisit& at) const;
    bool is_hidden_beyond_horizon(std::size_t light, const RefPath& path, double distance,
                                  const MachineVisit& at) const;
    bool is_blocking_tied(const RefPath& path, double distance, bool wanted) const;

    const GuideRules& rules_;
    const MachinePath& path_;
    double sample_width_;
    std::size_t visited_ = 0;   ///< number of path_.visits that were followed
    GuideFinding finding_;
    std::vector<int> at_;
    std::vector<glm::dvec3> moved_;   ///< for each of at_: from the reference's point to the machine's
    bool is_substituted_ = false;     ///< the last hit is the machine's, not the reference's
};

}   // namespace rayclock
