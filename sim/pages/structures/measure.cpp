#include "sim/pages/structures/measure.hpp"

#include <ctime>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/load/load.hpp"
#include "sim/request/request.hpp"
#include "sim/rtl/stopping.hpp"

namespace rayclock::structures {

namespace {

constexpr int depth = 4;

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

Kind kind_of(const char* name, Config config, Structure structure, Straddlers straddlers) {
    config.structure = int(structure);
    config.straddlers = int(straddlers);
    return {name, config};
}

double busy_share(const Config& config, const FrameRun& run) {
    for (const UnitAccount& account : unit_accounts(config, run))
        if (account.unit == "tri") return double(account.busy) / double(run.cycles) / account.instances;
    return 0;
}

Frame frame_of(const Config& config, const std::vector<FrameTrace>& frames) {
    Frame frame;
    frame.run = frame_run(frames[0], replay(config, default_khz, frames)[0]);
    if (frame.run.partial) throw UserError("interrupted: no page was written");
    frame.bound = bound_of(config, default_khz, frame.run);
    frame.tri_busy = busy_share(config, frame.run);
    return frame;
}

std::vector<FrameTrace> recorded(const Job& job, const Study& study) {
    std::vector<FrameTrace> frames;
    frames.push_back(record_frame(job, job.frame, study.threads, stopping({})));
    return frames;
}

void measure_camera(const Scene& scene, const Kind& kind, const Study& study, Cell& cell) {
    const double begin = processor_seconds();
    const Job job = make_job(scene, *scene.camera, study.size, kind.config, stopping({}));
    cell.build = processor_seconds() - begin;
    cell.report = job.image.report;
    const std::vector<FrameTrace> frames = recorded(job, study);
    cell.camera = frame_of(job.config, frames);
    for (const int sets : cache_sets()) {
        Config config = job.config;
        config.node_sets = config.prim_sets = sets;
        cell.cached.push_back(frame_of(config, frames).cycles_per_ray());
    }
}

Frame finished_frame(const Scene& scene, const Kind& kind, const Study& study) {
    const FrameSize half{study.size.width / 2, study.size.height / 2};
    const Whitted settings{.depth = depth};
    const Job job = make_job(scene, *scene.camera, half, fitted_config(scene, settings, kind.config),
                             stopping({}), settings);
    return frame_of(job.config, recorded(job, study));
}

}   // namespace

std::vector<Kind> trees(const Config& base) {
    return {kind_of("bvh", base, Structure::bvh, Straddlers::leaves),
            kind_of("spheres", base, Structure::spheres, Straddlers::leaves),
            kind_of("kd", base, Structure::kd, Straddlers::leaves),
            kind_of("octree", base, Structure::octree, Straddlers::leaves),
            kind_of("bsp", base, Structure::bsp, Straddlers::leaves)};
}
Kind list(const Config& base) { return kind_of("none", base, Structure::none, Straddlers::leaves); }
Kind inner_octree(const Config& base) {
    return kind_of("octree, inner", base, Structure::octree, Straddlers::inner);
}

const std::vector<int>& cache_sets() {
    static const std::vector<int> sets{8, 64, 512};
    return sets;
}

SceneCells measure(const std::string& name, const std::vector<Kind>& kinds, const Study& study, bool finished,
                   const Progress& progress) {
    const Scene scene = ready_scene(name, study.size, stopping({}));
    std::optional<Scene> native;
    if (finished) {
        native = load_scene(name, stopping({}), Primitives::native);
        native->camera = scene.camera;
    }
    SceneCells result{name, scene.triangles.size(), {}};
    for (const Kind& kind : kinds) {
        if (progress) progress(fmt::format("{}, {}", name, kind.name), result.cells.size(), kinds.size());
        Cell cell;
        cell.structure = kind.name;
        try {
            measure_camera(scene, kind, study, cell);
            if (finished) cell.finished = finished_frame(*native, kind, study);
        } catch (const UserError& error) {
            if (interrupted()) throw;
            cell.refused = error.what();
        }
        result.cells.push_back(std::move(cell));
    }
    return result;
}

}   // namespace rayclock::structures
