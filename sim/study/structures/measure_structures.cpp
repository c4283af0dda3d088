// Compiles, renders and judges scenes with each structure.
#include "sim/study/structures/measure_structures.hpp"

#include <algorithm>
#include <ctime>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/compile/surfaces.hpp"
#include "model/engine/engines.hpp"
#include "model/trace/hits.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/load/load.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock::structures {

namespace {

constexpr int depth = 4;

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

NamedStructure named_structure(const std::string& name, Config config, Structure structure,
                               Straddlers straddlers) {
    config.structure = structure;
    config.straddlers = straddlers;
    while (config.box_queue <= node_latency(config)) config.box_queue *= 2;   // for one node per cycle
    return {name, config};
}

double busy_share(const Config& config, const FrameResult& run) {
    for (const UnitAccount& account : unit_accounts(config, run))
        if (account.unit == "tri") return double(account.busy) / double(run.cycles) / account.instances;
    return 0;
}

Frame frame_of(const Config& config, const std::vector<RecordedFrame>& frames) {
    Frame frame;
    frame.run = frame_result(frames[0], replay(config, default_khz, frames)[0]);
    if (frame.run.partial) throw Interrupted("interrupted: no page was written");
    frame.bound = bound_of(config, default_khz, frame.run);
    frame.tri_busy = busy_share(config, frame.run);
    return frame;
}

std::vector<RecordedFrame> recorded(const Job& job, const Study& study) {
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame, study.threads, stopping({})));
    return frames;
}

/// The reference's picture, with which all structures of a scene are compared.
struct Drawn {
    HitFrame hits;
    Picture picture;
};
Drawn reference_of(const Scene& scene, FrameSize size, const Whitted& settings, bool shades, int threads) {
    const Reference tracer(scene);
    if (shades) {
        WhittedFrame frame = tracer.whitted(*scene.camera, size, settings, threads, stopping({}));
        Picture picture = picture_from_reference(frame);
        return {std::move(frame.hits), std::move(picture)};
    }
    HitFrame hits = tracer.frame(*scene.camera, size, threads, stopping({}));
    Picture picture = shade(scene, hits);
    return {std::move(hits), std::move(picture)};
}

FrameError error_of(const Scene& scene, const Job& job, const RecordedFrame& made, const Drawn& reference) {
    const HitFrame hits = hits_of(job, made);
    const Picture picture =
        job.config.shading ? picture_from_colours(job.size, made.trace.colours) : shade(scene, hits);
    return frame_error(hits, picture, reference.hits, reference.picture);
}

/// `settings` are those of a shading chip, because only such a chip meets true spheres.
void measure_camera(const Scene& scene, const Config& chip, const Whitted& settings, const Study& study,
                    const Drawn& reference, Cell& cell) {
    const double begin = processor_seconds();
    const Job job = make_job(scene, *scene.camera, study.size, chip, stopping({}), settings);
    cell.build = processor_seconds() - begin;
    cell.report = job.image.report;
    const std::vector<RecordedFrame> frames = recorded(job, study);
    cell.camera = frame_of(job.config, frames);
    cell.camera.error = error_of(scene, job, frames[0], reference);
    for (const Surroundings& around : surroundings()) {
        Config config = job.config;
        config.node_sets = config.prim_sets = around.sets;
        config.dram = choice_named<DramName>(around.dram);
        config.own_dram = nullptr;
        cell.elsewhere.push_back(frame_of(config, frames).cycles_per_ray());
    }
}

constexpr Whitted finished_settings{.depth = depth};
FrameSize half_of(FrameSize size) { return {size.width / 2, size.height / 2}; }

Frame finished_frame(const Scene& scene, const NamedStructure& structure, const Study& study,
                     const Drawn& reference) {
    const Job job =
        make_job(scene, *scene.camera, half_of(study.size),
                 fitted_config(scene, finished_settings, structure.config), stopping({}), finished_settings);
    const std::vector<RecordedFrame> frames = recorded(job, study);
    Frame frame = frame_of(job.config, frames);
    frame.error = error_of(scene, job, frames[0], reference);
    return frame;
}

}   // namespace

bool Study::is_round(const std::string& scene) const {
    return std::find(round.begin(), round.end(), scene) != round.end();
}

std::vector<NamedStructure> trees(const Config& base) {
    std::vector<NamedStructure> all;
    for (const Structure structure : tree_structures()) {
        all.push_back(named_structure(name_of(structure), base, structure, Straddlers::leaves));
        if (!all.back().config.is_bvh()) continue;
        all.push_back(all.back());
        all.back().name = "bvh, splits";
        all.back().config.splits = Splits::on;
    }
    return all;
}
NamedStructure list(const Config& base) {
    return named_structure("none", base, Structure::none, Straddlers::leaves);
}
NamedStructure inner_octree(const Config& base) {
    return named_structure("octree, inner", base, Structure::octree, Straddlers::inner);
}

const std::vector<Surroundings>& surroundings() {
    static const std::vector<Surroundings> all{{"sdr", 8},  {"sdr", 64},  {"sdr", 512},
                                               {"ddr3", 8}, {"ddr3", 64}, {"ddr3", 512}};
    return all;
}

SceneCells measure(const std::string& name, const std::vector<NamedStructure>& candidates, const Study& study,
                   bool finished, const Progress& progress) {
    const bool is_round = study.is_round(name);
    Scene scene, native;
    if (finished || is_round) native = load_noted_scene(name, stopping({}), Primitives::native);
    if (is_round) {
        scene = native;
        scene.lights.clear();   // so that only camera rays are traced
    } else {
        scene = load_noted_scene(name, stopping({}));
    }
    if (!scene.camera) scene.camera = fit_camera(scene, double(study.size.width) / study.size.height);
    native.camera = scene.camera;
    const Whitted no_bounces{.depth = 0};
    const Drawn reference = reference_of(scene, study.size, no_bounces, is_round, study.threads);
    Drawn finished_reference;
    if (finished)
        finished_reference =
            reference_of(native, half_of(study.size), finished_settings, true, study.threads);
    SceneCells result{
        name, is_round, scene.triangles.size() + scene.spheres.size() + scene.planes.size(), {}};
    for (const NamedStructure& structure : candidates) {
        if (progress)
            progress(fmt::format("{}, {}", name, structure.name), result.cells.size(), candidates.size());
        Cell cell;
        cell.structure = structure.name;
        try {
            const Config chip =
                is_round ? fitted_config(scene, no_bounces, structure.config) : structure.config;
            measure_camera(scene, chip, no_bounces, study, reference, cell);
            if (finished) cell.finished = finished_frame(native, structure, study, finished_reference);
        } catch (const UserError& error) {
            if (interrupted()) throw;
            cell.refused = error.what();
        }
        result.cells.push_back(std::move(cell));
    }
    return result;
}

}   // namespace rayclock::structures
