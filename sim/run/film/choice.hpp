#pragma once
// What is drawn of one scene with many configurations.
#include "sim/run/film/film.hpp"

namespace rayclock {

/// Whether anything of a scene moves by itself.
bool moves(const Scene& scene);
/// What was asked for, without what has no effect in this scene; a note on standard error tells of that.
/// Throws UserError.
FramesOptions settled_frames(const FramesOptions& asked, const Scene& scene);

/// What is drawn of a scene with every configuration that is tried: the finished picture, or what camera rays
/// hit; of one frame, or of a film.
struct PictureChoice {
    bool finished = false;    ///< a chip that shades draws the finished picture in any case
    Whitted settings{};       ///< of it
    FramesOptions frames{};   ///< as settled_frames() made them
    ViewChoice view{};        ///< from which the scene's camera came
};

/// The frames as a configuration draws them. Throws UserError if it cannot.
Film film_of(const Scene& scene, FrameSize size, const PictureChoice& choice, const Config& config,
             const Progress& progress, bool for_chip = true);

}   // namespace rayclock
