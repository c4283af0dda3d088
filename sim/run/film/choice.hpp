#pragma once
// The frames that many configurations draw of one scene.
#include "sim/run/film/film.hpp"

namespace rayclock {

/// Returns true if the scene has motion of its own.
bool moves(const Scene& scene);
/// Returns the options without those that have no effect in this scene; a note on standard error names them.
/// Throws UserError if an option is wrong.
FramesOptions settled_frames(const FramesOptions& asked, const Scene& scene);

/// The drawing that all tried configurations make of a scene: the finished picture or the hits of camera
/// rays, for one frame or a film.
struct PictureChoice {
    bool finished = false;    ///< a chip that shades always draws the finished picture
    Whitted settings{};       ///< of the finished picture
    FramesOptions frames{};   ///< the result of settled_frames()
    ViewChoice view{};        ///< the options that chose the scene's camera
};

/// Returns the frames for one configuration. Throws UserError if it cannot draw them.
Film film_of(const Scene& scene, FrameSize size, const PictureChoice& choice, const Config& config,
             const Progress& progress, bool for_chip = true);

}   // namespace rayclock
