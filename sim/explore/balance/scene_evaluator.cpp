// Simulates and synthesises the machines of a search, with a cache for both.
#include "sim/explore/balance/scene_evaluator.hpp"

#include <algorithm>
#include <bit>

#include "model/base/error.hpp"
#include "model/compile/compile.hpp"
#include "model/core/parameters.hpp"
#include "model/engine/check.hpp"
#include "sim/explore/sweep/evaluate_points.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/silicon/area/synthesise_units.hpp"

namespace rayclock::balance {

namespace {

chip::Use use_of(const synth::Count& count) { return {count.luts(), count.ff, count.dsp, count.bram}; }

}   // namespace

SceneEvaluator::SceneEvaluator(const Scene& scene, FrameSize size, int khz, int threads, bool fresh,
                               const Progress& progress, const PictureChoice& picture)
    : scene_(scene),
      size_(size),
      khz_(khz),
      threads_(threads),
      frames_(rtl_cache() / "sweep", fresh),
      areas_(rtl_cache() / "area", fresh),
      progress_(progress),
      picture_(picture) {}

Evaluator SceneEvaluator::evaluator() {
    return {[this](std::vector<Machine>& machines) { return fps(machines); },
            [this](std::vector<Machine>& machines) { return use(machines); }};
}

Config SceneEvaluator::with_needs(Config config) {
    const auto at = reports_.find(config.node_width);
    if (at == reports_.end()) {
        Config widest = config;
        widest.stack_depth = parameter(&Config::stack_depth).hi;
        widest.addr_bits = parameter(&Config::addr_bits).hi;
        reports_[config.node_width] = compile_scene(scene_, scene_.camera->eye, widest).report;
        return with_needs(config);
    }
    const CompileReport& report = at->second;
    config.stack_depth = int(std::bit_ceil(unsigned(std::max(1, report.stack_need))));
    config.addr_bits = std::max({parameter(&Config::addr_bits).lo, config.least_addr_bits(),
                                 int(std::bit_width(report.bytes / line_bytes - 1))});
    return config;
}

bool SceneEvaluator::fps(std::vector<Machine>& machines) {
    std::vector<sweep::Point> points;
    for (Machine& machine : machines) {
        machine.config = with_needs(machine.config);
        points.push_back({{}, machine.config, khz_, ""});
        try {
            check_config(machine.config, machine.config.name);
        } catch (const UserError& e) {
            points.back().refused = e.what();
        }
    }
    const sweep::Evaluation outcome =
        sweep::run({scene_, size_, std::move(points), threads_, false, picture_}, frames_, progress_);
    if (outcome.partial) return false;
    for (std::size_t i = 0; i < machines.size(); ++i)
        if (outcome.results[i].complete()) machines[i].fps = outcome.results[i].speed();
    return true;
}

bool SceneEvaluator::use(std::vector<Machine>& machines) {
    std::vector<area::Variant> variants;
    for (const Machine& machine : machines) variants.push_back({machine.config.name, machine.config});
    if (variants.empty()) return true;
    const area::Areas areas = area::run(std::move(variants), {}, threads_, areas_, progress_);
    if (areas.partial) return false;
    for (std::size_t i = 0; i < machines.size(); ++i) machines[i].use = use_of(area::chip_count(areas, i));
    return true;
}

}   // namespace rayclock::balance
