#pragma once
#include <optional>
#include <string>

#include "model/scene/camera.hpp"

namespace rayclock {

/// Where a scene is to be looked at from, as far as it was typed; the rest is the scene's own camera, or the
/// one that fits its meshes.
struct ViewChoice {
    std::optional<std::string> eye, at;    ///< "x,y,z"
    std::optional<double> fov, orbit;      ///< degrees
    bool ground = false;                   ///< lay_ground()
    std::optional<std::string> material;   ///< give_material()

    bool is_asked() const { return eye || at || fov || orbit; }
};

/// The camera as chosen. `orbit` turns the eye about the point that it looks at, around the up axis and
/// against the clock as seen from above, after all else is set. Throws UserError if nothing can be seen so.
Camera chosen_camera(const Camera& camera, const ViewChoice& view, FrameSize size);

}   // namespace rayclock
