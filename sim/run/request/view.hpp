#pragma once
// The options of the camera.
#include <optional>
#include <string>

#include "model/scene/camera.hpp"

namespace rayclock {

/// A rectangle of pixels; (x, y) is its upper left pixel.
struct PixelRect {
    int x = 0, y = 0;
    FrameSize size;
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// The user's view options. Missing ones keep the scene's own camera, or the one that fits its meshes.
struct ViewChoice {
    std::optional<std::string> eye, at;    ///< "x,y,z"
    std::optional<double> fov, orbit;      ///< degrees
    bool ground = false;                   ///< lay_ground()
    std::optional<std::string> material;   ///< give_material()
    bool no_textures = false;              ///< draw pictures on surfaces in their average colours
    std::optional<PictureWindow> window;   ///< draw only this part of the picture

    bool is_given() const { return eye || at || fov || orbit; }
};

/// Returns the chosen camera. `orbit` applies last: it turns the eye about the point that it looks at, around
/// the up axis, anticlockwise as seen from above. Throws UserError if the result is not a valid view.
Camera chosen_camera(const Camera& camera, const ViewChoice& view, FrameSize size);

}   // namespace rayclock
