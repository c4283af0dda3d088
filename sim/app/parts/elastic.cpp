// Reads --elastic, --unit and --unit-only, and runs a unit alone.
#include "sim/app/parts/elastic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/machine/units.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/elastic/unit_alone.hpp"
#include "sim/run/rtl/sources.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

/// True if the first word of the list is a unit or "all".
bool is_list_of_units(const std::string& text) {
    const std::string word = text.substr(0, text.find(','));
    return word == "all" ||
           std::ranges::any_of(unit_infos, [&](const UnitInfo& unit) { return word == unit.name; });
}

}   // namespace

void elastic_options(Parser& parser, ElasticChoice& choice) {
    parser
        .option("--elastic", choice.units,
                "compare values ray by ray, not cycles: for units whose timing differs from the model's. "
                "UNIT,... names these units, default all; don't-care outputs of other units are compared")
        .or_alone("all");
    parser
        .option("--unit", choice.files,
                "NAME=FILE: build the RTL with this file in place of rc_NAME.sv, for example "
                "tri=my_tri.sv; may be repeated")
        .one_each();
    parser.option(
        "--unit-only", choice.alone,
        "run one unit alone on the requests of the frame, with random valid and ready: tri, xform, or "
        "a node unit");
}

void take_elastic(ElasticChoice& choice, std::string& scene) {
    if (choice.units && scene.empty() && !is_list_of_units(*choice.units)) {
        scene = *choice.units;
        choice.units = "all";
    }
    for (const std::string& text : choice.files) {
        const std::size_t equals = text.find('=');
        if (equals == 0 || equals == text.npos || equals + 1 == text.size())
            throw UserError(
                fmt::format("--unit {}: must be NAME=FILE, for example tri=my_tri.sv", shown(text)));
        replace_module(text.substr(0, equals), text.substr(equals + 1));
    }
}

void refuse_with_unit_only(const char* odd) {
    if (odd) throw UserError(fmt::format("{} has no meaning with --unit-only, which runs one unit", odd));
}

int verify_unit_alone(const ElasticChoice& choice, Film& film, int threads, int seed,
                      const JsonOutput& json) {
    const Progress stop = stopping(terminal_progress());
    film.next();
    const RecordedFrame frame = film.record(threads, stop);
    const Job& job = film.job();
    const Scene& scene = film.request().scene;
    const UnitAlone r = run_unit_alone(job, frame, *choice.alone, seed);
    if (!json.is_alone()) {
        fmt::print("{} alone, on the requests of {}\n", *choice.alone, printable(scene.name));
        fmt::print("  {} answers compared in {} cycles, {} are wrong or missing ({} answers per second)\n",
                   grouped(r.answers), grouped(r.cycles), grouped(r.value_mismatches),
                   grouped(std::uint64_t(double(r.answers) / std::max(r.seconds, 1e-3))));
        if (r.first) fmt::print("{}", divergence_lines(*r.first));
        fmt::print("  {} in {:.1f} s\n",
                   r.interrupted ? "PARTIAL: interrupted"
                   : r.agrees()  ? "VERIFIED"
                                 : "FAILED",
                   r.seconds);
    }
    json.write({{"scene", scene_json(scene)},
                {"config", config_json_object(job.config)},
                {"partial", r.interrupted},
                {"unit", *choice.alone},
                {"events_compared", r.answers},
                {"value_mismatches", r.value_mismatches},
                {"first_divergence", divergence_json(r.first)},
                {"cycles", r.cycles},
                {"pixels", nullptr},
                {"cycle_gap", nullptr},
                {"reference", nullptr},
                {"golden", nullptr},
                {"judge", nullptr},
                {"host", {{"seconds", r.seconds}}}});
    return r.agrees() ? 0 : 1;
}

LockstepResult as_lockstep(const ElasticResult& e) {
    LockstepResult r;
    r.runs = e.runs;
    r.model = e.model;
    r.rtl = e.rtl;
    r.events_compared = e.events_compared;
    r.value_mismatches = e.value_mismatches;
    r.first = e.first;
    return r;
}

std::uint64_t cycle_gap_of(const ElasticResult& e) {
    std::uint64_t gap = 0;
    for (std::size_t f = 0; f < e.rtl_runs.size(); ++f) {
        const std::uint64_t model = e.runs[f].cycles, rtl = e.rtl_runs[f].cycles;
        gap += model > rtl ? model - rtl : rtl - model;
    }
    return gap;
}

}   // namespace rayclock
