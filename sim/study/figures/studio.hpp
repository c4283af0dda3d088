#pragma once
// Finished pictures of one scene by the three tracers, for comparison on a page.
#include <optional>
#include <string>
#include <vector>

#include "sim/files/process/stopping.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/request/tracer.hpp"

namespace rayclock::figures {

/// Returns a tracer's name on the page.
constexpr const char* title_of(Tracer tracer) {
    return tracer == Tracer::reference ? "reference" : tracer == Tracer::model ? "model" : "RTL";
}

/// Settings that all figures of a page share.
struct Studio {
    FrameSize size{256, 192};
    int threads = 0;
    std::vector<Tracer> tracers{Tracer::reference, Tracer::model, Tracer::rtl};
    Progress progress;

    bool has(Tracer tracer) const;
};

/// One picture and its costs.
struct Shot {
    Picture picture;
    RayCounts rays;
    std::optional<FrameResult> run;   ///< only for machines
};

/// A scene with one machine for all settings up to `most`. The machine has the units, stack and registers
/// that `most` needs, so only the settings differ between pictures.
class Stage {
public:
    Stage(const Studio& studio, const std::string& scene, const Whitted& most, FrameSize size);
    Stage(const Studio& studio, const std::string& scene, const Whitted& most)
        : Stage(studio, scene, most, studio.size) {}

    Shot take(Tracer tracer, const Whitted& settings);
    const Scene& scene() const { return scene_; }
    const Job& job() const { return job_; }

private:
    Studio studio_;
    Scene scene_;
    Job job_;
    Reference reference_;
};

}   // namespace rayclock::figures
