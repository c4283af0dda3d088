#pragma once
// Pictures of textured scenes, judged against the oracle and the reference, and replayed on the machine.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "model/engine/check.hpp"
#include "model/machine/machine.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock::test {

/// Returns a chip for finished pictures of a scene.
inline Config fitted_chip(const Scene& scene, const Whitted& settings, int levels, TexelFormat texels,
                          Structure structure = Structure::bvh) {
    Config c = named_config("default");
    c.structure = structure;
    c.levels = levels, c.texels = texels, c.stack_depth = 64;
    c = fitted_config(scene, settings, c);
    check_config(c, "test");
    return c;
}

/// Judges a picture of the model, and replays it. Requires that the judge accepts every ray and colour, and
/// that every pixel that differs from the reference has a cause. A third of the pixels must send a ray to a
/// light. Returns the trace.
inline Trace check_picture(const Scene& scene, FrameSize size, const Whitted& settings,
                           const Config& config) {
    REQUIRE(config.has_textures());
    const Job job = make_job(scene, *scene.camera, size, config, {}, settings);
    RecordedFrame made = record_frame(job, job.frame);
    const WhittedFrame reference = Reference(scene).whitted(*scene.camera, size, settings);
    const MachineOutput given{made.trace.hits, made.trace.colours, made.trace.signatures};
    const Judgement j =
        judge_finished({scene, *scene.camera, made.frame, job.image.lattice, job.config}, job.image, settings,
                       {reference, picture_from_colours(size, made.trace.colours), given},
                       scaled(job, job.frame, made.trace.hits));
    for (const PictureFault& f : j.faults) FAIL_CHECK("pixel (" << f.x << ", " << f.y << "): " << f.what);
    CHECK(j.wrong == 0);
    CHECK(j.bugs() == 0);
    CHECK(j.colours == std::uint64_t(size.width * size.height));
    CHECK(j.rays.shadow > std::uint64_t(size.width * size.height / 3));
    std::vector<RecordedFrame> frames;
    frames.push_back(std::move(made));
    Machine machine(job.config, job.khz, {});
    prepare_frame(machine, 0, std::span(std::as_const(frames)));
    machine.start(frames[0].frame, frames[0].trace);
    std::uint64_t cycles = 0;
    while (!machine.done() && ++cycles < 4'000'000) machine.step();
    CHECK(machine.done());
    return std::move(frames[0].trace);
}

}   // namespace rayclock::test
