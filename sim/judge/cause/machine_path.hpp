#pragma once
// The path of one pixel as a machine took it: every ray, what it met, and what was decided there.
#include <vector>

#include "model/unit/shade/shader.hpp"

namespace rayclock {

/// What a machine made of one light at one surface.
struct MachineLight {
    bool is_asked = false;   ///< a ray was sent
    bool is_lit = false;     ///< its light is added
    Ray ray;                 ///< if one was sent
};

/// A camera ray or bounce, and the surface that it met.
struct MachineVisit {
    static constexpr int none = -1;
    Ray ray;
    Closest hit;
    Surface surface;    ///< from memory, if something was hit
    ShadeState state;   ///< after the surface has arrived, and has been turned if there are two levels
    Placement placement;
    std::vector<MachineLight> lights;
    /// A bounce was due, but passes by the lattice: no ray was sent, and it took the background.
    bool is_reflected_past = false, is_refracted_past = false;
    int parent = none, reflected = none, refracted = none;   ///< places in MachinePath::visits
};

/// Watches a Shader from the first ray of a pixel to its colour.
class MachinePath final : public ShadeWatch {
public:
    std::vector<MachineVisit> visits;
    std::vector<int> samples;   ///< places of their camera rays

    void start() { visits.clear(), samples.clear(), waiting_.clear(), at_ = MachineVisit::none; }
    void sent(const Ray& ray) override;
    void answered(const Closest& hit) override;
    void passed(const PassIn& in, const PassOut& out) override;

private:
    int add(const Ray& ray, int parent);
    bool asks_light_ = false;
    ShadeEvent last_ = ShadeEvent::arrive;
    int at_ = MachineVisit::none;
    std::vector<int> waiting_;   ///< whose refracted rays wait
};

}   // namespace rayclock
