#pragma once
// The machine's path through one pixel: every ray, its hit, and the decisions there.
#include <array>
#include <optional>
#include <vector>

#include "model/unit/shade/shader.hpp"

namespace rayclock {

/// A machine's decisions about one light at one surface.
struct MachineLight {
    bool was_sent = false;   ///< a ray was sent
    bool is_lit = false;     ///< its light is added
    Ray ray;                 ///< the last ray, if one was sent
};

/// The texture of a hit, as the machine read it.
struct MachineTexture {
    std::uint32_t level = 0;
    bool is_hole = false;
    std::uint32_t u = 0, v = 0;             ///< as in TexReq
    std::array<std::uint32_t, 3> below{};   ///< the albedo before the texture
};

/// A camera ray or bounce, and the surface that it met.
struct MachineVisit {
    static constexpr int none = -1;
    Ray ray;
    Closest hit;
    Surface surface;   ///< from memory, if something was hit
    /// After the pass *arrive*, and with two levels after the pass *transform*; its albedo includes the
    /// texture.
    ShadeState state;
    std::optional<MachineTexture> texture;
    Placement placement;
    std::vector<MachineLight> lights;
    /// A bounce was due but misses the lattice. No ray was sent, and it added the background.
    bool is_reflected_past = false, is_refracted_past = false;
    int parent = none, reflected = none, refracted = none, onward = none;   ///< indices in
                                                                            ///< MachinePath::visits
};

/// Watches a Shader from the first ray of a pixel to its colour.
class MachinePath final : public ShadeWatch {
public:
    std::vector<MachineVisit> visits;
    std::vector<int> samples;   ///< indices of their camera rays in `visits`

    void start() { visits.clear(), samples.clear(), waiting_.clear(), at_ = MachineVisit::none; }
    void sent(const Ray& ray) override;
    void answered(const Closest& hit) override;
    void passed(const PassIn& in, const PassOut& out) override;
    void filtered(const TexReq& hit, const TexRecord& record, const TexelPlace& place,
                  const TexRsp& answer) override;

private:
    int add(const Ray& ray, int parent);
    bool asks_light_ = false, asks_cutout_ = false;
    ShadeEvent last_ = ShadeEvent::arrive;
    int at_ = MachineVisit::none;
    std::vector<int> waiting_;   ///< visits whose refracted rays wait
};

}   // namespace rayclock
