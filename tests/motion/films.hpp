#pragma once
// Films for the tests, and the chips of two levels that render them.
#include "model/compile/surfaces.hpp"
#include "sim/run/film/film.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test {

inline Config two(const std::string& name, int interval, const Values& more = {}) {
    Values values{{"levels", 2}, {"xform_interval", interval}};
    values.insert(values.end(), more.begin(), more.end());
    return with(quick_config(name), values);
}

/// Returns formats and paths, each with its own RTL, equal to those of two levels in other tests.
inline std::vector<Config> chips() {
    return {two("default", 2),
            two("small", 4),
            two("small", 1, {{"timing", 1}, {"raygen_queue", 32}, {"box_queue", 32}, {"tri_queue", 64}}),
            two("narrow", 4),
            two("broad", 2),
            two("small", 2, {{"structure", int(Structure::kd)}, {"mesh_structure", 1}})};   // over boxes
}

/// Returns a request of two levels with finished pictures, and a surf_cache that is larger than the other
/// caches.
inline Request finished_request(const std::string& spec) {
    Request request;
    request.scene = load_scene(spec);
    request.settings.depth = 2;
    request.config = fitted_config(request.scene, request.settings, two("small", 2));
    request.finished = true;
    return request;
}

inline FramesOptions frames_of(int frames, double fps, const std::string& uploads = "between") {
    FramesOptions o;
    o.frames = frames;
    o.fps = fps;
    o.uploads = uploads;
    return o;
}

inline Film film_of(const std::string& spec, const Config& config, FrameSize size,
                    const FramesOptions& options) {
    Request request;
    request.config = config;

    request.scene = load_scene(spec);
    if (!request.scene.camera)
        request.scene.camera = fit_camera(request.scene, double(size.width) / size.height);
    return Film(std::move(request), options, false, size);
}

struct Recorded {
    std::vector<RecordedFrame> traces;
    Job job;
};
inline Recorded recorded(Film& film) {
    Recorded r;
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        r.traces.push_back(film.record(1, {}));
    }
    r.job = film.job();
    return r;
}

inline bool same(const std::vector<Closest>& a, const std::vector<Closest>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].found != b[i].found || a[i].prim != b[i].prim || a[i].t != b[i].t || a[i].u != b[i].u ||
            a[i].v != b[i].v)
            return false;
    return true;
}

}   // namespace rayclock::test
