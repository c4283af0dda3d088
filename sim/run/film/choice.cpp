// Fitting the options to the scene, and making its film.
#include "sim/run/film/choice.hpp"

#include "sim/run/request/levels.hpp"

namespace rayclock {

bool moves(const Scene& scene) { return scene.placed && !scene.placed->motion.empty(); }

FramesOptions settled_frames(const FramesOptions& asked, const Scene& scene) {
    const FrameTimes times = frame_times(asked, moves(scene));
    FramesOptions settled = asked;
    if (!moves(scene)) {
        settled.frames = int(times.times.size());
        settled.time.clear();
        settled.fps.reset();
    }
    if (times.times.size() == 1) settled.pan = 0;
    return settled;
}

Film film_of(const Scene& scene, FrameSize size, const PictureChoice& choice, const Config& config,
             const Progress& progress, bool for_chip) {
    check_levels(scene, config, choice.finished, choice.view.ground);
    return Film({config, scene, choice.finished || config.shading, choice.settings}, choice.frames,
                choice.view.is_given(), size, progress, for_chip);
}

}   // namespace rayclock
