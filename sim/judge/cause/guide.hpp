#pragma once
// Leads the reference tracer along a machine's path through one pixel, and says where the two disagree.
//
// The last rung of the ladder (finished.hpp). The reference has the scene as the machine has it: corners,
// spheres, planes and lights on the lattice, colours and weights with the machine's bits. Each ray is the
// machine's, after it was found to lie within a bound of the ray that the reference would have sent. Every
// decision is the reference's own: what a ray meets, on which side, which normal counts there, which lights
// count and what is in their way, which bounces leave. So a wrong *rule* of the machine is found here, also
// where the machine's own judge follows the same rule.
//
// The two may part where doubles cannot tell, or where a stated rounding decides. Then the reference follows
// the machine, and the step is counted:
//   tie      a ray moved by 2^-34 of its length, or a quantity within its stated bound, gives the machine's
//            answer
//   horizon  a bounce from a point of a plane beyond the lattice meets another plane before it comes into
//            the lattice, or lies too far away to be said (docs/origins.md, Points of a plane beyond the
//            lattice)
//   seam     two levels: the instance sees a ray that was rounded for it (seam.hpp)
// Anything else is a fault.
#include <optional>
#include <string>

#include "sim/judge/reference/reference.hpp"
#include "sim/judge/reference/steer.hpp"
#include "sim/judge/cause/camera_ray.hpp"
#include "sim/judge/cause/machine_path.hpp"
#include "sim/judge/cause/seam.hpp"

namespace rayclock {

/// What all pixels share.
struct GuideRules {
    const Asked& asked;                    ///< the frame; the scene as given
    const Scene& scene;                    ///< the scene as the machine has it, in the given scene's units
    const Reference& reference;            ///< of `scene`
    const CameraBound& camera;             ///< of the picture
    double contrast = 0;                   ///< of samples, at which a pixel ends
    const PlacedWorld* placed = nullptr;   ///< of two levels
    const Seams* seams = nullptr;
};

/// What was found on one path.
struct GuideFinding {
    std::string fault;   ///< the first, or empty
    std::uint32_t ties = 0;
    bool has_horizon = false, has_seam = false;
    bool has_lost = false;   ///< a point lies further beyond the lattice than the machine can say
};

class Guide final : public RefSteer {
public:
    /// `sample_width`: how far apart the machine's colour of a sample and the reference's may be.
    Guide(const GuideRules& rules, const MachinePath& path, double sample_width)
        : rules_(rules), path_(path), sample_width_(sample_width) {}
    /// The reference is through with the pixel: nothing of the machine's path may be left.
    void finish();
    const GuideFinding& finding() const { return finding_; }

    void begin_sample(std::uint32_t sample, RefPath& path) override;
    bool ends(std::uint32_t samples, double difference, bool own) override;
    RefClosest met(const RefPath& path, const RefClosest& own) override;
    void round_corners(RefClosest& hit, std::array<glm::dvec3, 3>& normals) override;
    glm::dvec3 square(const RefClosest& hit, const Material& material, const glm::dvec3& own) override;
    void place(RefSurface& surface) override;
    bool counts(std::size_t light, double side, double lambert) override;
    bool is_blocked(std::size_t light, const RefPath& path, double distance, bool own) override;
    bool is_total(const RefSurface& surface, double ratio, double cosine, bool own) override;
    bool goes(RefBounce& bounce) override;
    void enter(RefBounce::Interaction interaction) override;
    void leave() override { at_.pop_back(); }

private:
    /// The machine's visit that the reference is at; none where the machine sent no ray.
    const MachineVisit* visit() const {
        return at_.empty() || at_.back() < 0 ? nullptr : &path_.visits[std::size_t(at_.back())];
    }
    void fail(std::string what);
    void tie() { ++finding_.ties; }

    glm::dvec3 point(const Vec3l& p, int frac) const;   ///< of the scene's lattice, in the tracer's space
    glm::dvec3 direction(const Vec3i& d) const;         ///< unit
    double step() const;                                ///< of the lattice, in the tracer's space
    bool is_turned(const MachineVisit& at) const;
    double normal_error(const MachineVisit& at) const;
    double direction_error(const RefBounce& bounce, const MachineVisit& at) const;
    void round_normals(const MachineVisit& at, std::array<glm::dvec3, 3>& normals) const;
    /// The weights of the second and third corner at the point from which rays leave.
    std::array<double, 2> weights(const MachineVisit& at) const;
    /// The machine's hit, from which the path goes on.
    RefClosest as_machine(const RefPath& path, const MachineVisit& at);
    std::optional<RefClosest> find_tie(const RefPath& path, const RefClosest& own,
                                       std::uint32_t wanted) const;
    RefPath from_far(const RefPath& path, const MachineVisit& at);
    RefPath from_own(const RefPath& path, double distance) const;
    double sphere_error(const MachineVisit& at, std::uint32_t primitive) const;   ///< steps
    bool is_within_root(const RefPath& path, const RefClosest& own, const MachineVisit& at) const;
    bool is_beyond_horizon(const RefPath& path, const RefClosest& own, const MachineVisit& at) const;
    bool is_hidden_beyond_horizon(std::size_t light, const RefPath& path, double distance,
                                  const MachineVisit& at) const;
    bool is_blocking_tied(const RefPath& path, double distance, bool wanted) const;

    const GuideRules& rules_;
    const MachinePath& path_;
    double sample_width_;
    std::size_t visited_ = 0;   ///< of path_.visits
    GuideFinding finding_;
    std::vector<int> at_;
    std::vector<glm::dvec3> moved_;   ///< at each of them, from the reference's point to the machine's
    bool is_substituted_ = false;     ///< the last hit is the machine's, and not the reference's
};

}   // namespace rayclock
