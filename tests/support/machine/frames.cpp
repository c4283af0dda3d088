// Prepares scenes, runs lockstep and checks the accounts of frames.
#include "tests/support/machine/frames.hpp"

#include <catch2/catch.hpp>

#include "model/base/error.hpp"
#include "sim/load/load.hpp"

namespace rayclock::test {

Shot make_shot(const std::string& name, FrameSize size, const Config& config) {
    Scene scene = load_scene(name);
    if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
    Job job = make_job(scene, *scene.camera, size, config);
    return {std::move(scene), std::move(job)};
}

Shot make_deep_shot(const std::string& name, FrameSize size, Config config) {
    for (;; config.stack_depth *= 2) {
        try {
            return make_shot(name, size, config);
        } catch (const UserError&) {
            if (config.stack_depth >= 64) throw;
        }
    }
}

Config with(const Config& config, const Values& values) { return shaped(config, values); }

const std::vector<std::string>& quick_configs() {
    static const std::vector<std::string> names{"default", "small", "narrow", "broad"};
    return names;
}

Config quick_config(const std::string& name) {
    if (name == "narrow")
        return with(named_config("small"),
                    {{"coord_bits", 12},  {"dir_bits", 12},    {"t_frac_bits", 0}, {"recip_bits", 8},
                     {"box_bits", 4},     {"bary_bits", 4},    {"node_width", 2},  {"leaf_size", 3},
                     {"stack_depth", 64}, {"raygen_queue", 2}, {"box_queue", 2},   {"tri_queue", 2},
                     {"pipelines", 2},    {"tile_bits", 0},    {"node_line", 256}, {"node_sets", 2},
                     {"node_ways", 2},    {"node_mshrs", 2},   {"prim_line", 128}, {"prim_sets", 1},
                     {"prim_ways", 4},    {"l2_sets", 8},      {"l2_ways", 2},     {"l2_line", 256},
                     {"l2_mshrs", 4},     {"cache_queue", 2},  {"dram", 2}});
    if (name == "broad")
        return with(named_config("default"), {{"coord_bits", 20},
                                              {"dir_bits", 22},
                                              {"recip_bits", 24},
                                              {"bary_bits", 24},
                                              {"leaf_size", 6},
                                              {"contexts", 1},
                                              {"node_sets", 1},
                                              {"node_ways", 1},
                                              {"node_mshrs", 1},
                                              {"prim_sets", 1},
                                              {"prim_ways", 1},
                                              {"prim_mshrs", 1},
                                              {"cache_queue", 2},
                                              {"dram", 0},
                                              {"mem_latency", 1}});
    return named_config(name);
}

namespace {

/// Returns the word after a visit and its triangles.
const std::uint32_t* after_visit(const std::uint32_t* word) {
    if (*word++ & VisitWord::tests_flag)
        while (!(*word++ & TestWord::last_flag)) {}
    return word;
}

/// Counts refracted rays that were totally reflected: counted but not sent. The trace knows the real number
/// of rays.
std::uint64_t totally_reflected(const Trace& trace) {
    std::uint64_t rays = 0;
    for (const std::uint32_t* word : trace.rays)
        for (bool done = false; !done;) {
            while (!(*word & VisitWord::end_flag)) word = after_visit(word);
            word = after_visit(word);
            while (*word & EndWord::place_flag) ++word;
            if (*word & EndWord::record_flag) word += 2;
            done = *word & EndWord::pixel_flag;
            word += 2;
            ++rays;
        }
    return trace.counts.all() - rays;
}

/// Requires that every cycle of every unit has one cause, and that the units' work equals what the rays
/// needed.
void check_accounts(const FrameResult& run, const Config& config, const Trace& trace) {
    const std::uint64_t pixels = trace.rays.size();
    const auto code = [&](Unit u, std::size_t c) { return run.accounts.units[index(u)][c]; };
    for (std::size_t u = 0; u < unit_count; ++u) {
        INFO("unit " << unit_infos[u].name);
        std::uint64_t sum = 0;
        for (std::size_t c = 0; c < cause_count; ++c) {
            sum += run.accounts.units[u][c];
            if (unit_infos[u].causes[c].kind == CauseKind::none) CHECK(run.accounts.units[u][c] == 0);
        }
        const std::uint64_t instances = !is_there(Unit(u), config) ? 0
                                        : u < pipeline_units       ? std::uint64_t(config.pipelines)
                                                                   : 1;
        CHECK(sum == instances * run.cycles);
    }
    CHECK(code(Unit::sched, 0) == pixels);
    const std::uint64_t sent = config.has_shade() ? trace.counts.all() - totally_reflected(trace) : pixels;
    CHECK(code(Unit::raygen, 0) == sent * std::uint64_t(config.raygen_interval));
    const std::uint64_t entered = code(Unit::xform, 0) / std::uint64_t(config.xform_interval);
    CHECK(code(Unit::xform, 0) % std::uint64_t(config.xform_interval) == 0);
    CHECK((entered > 0) == config.has_instances());
    const std::uint64_t steps = run.visits - entered;   // a transformed ray continues without a step
    CHECK(code(Unit::trav, 0) >= steps);
    // A turn is work, or holds a step up.
    CHECK(code(Unit::trav, 0) + code(Unit::trav, 2) == steps + trace.dropped_groups);
    const std::uint64_t nodes = config.is_list() ? 0 : run.visits;   // pages are not nodes
    CHECK(code(Unit::box, 0) % std::uint64_t(config.box_interval()) == 0);
    std::uint64_t decided = 0;
    for (const NodeUnit& u : node_units)
        decided += code(u.unit, 0) / (u.unit == Unit::box ? std::uint64_t(config.box_interval()) : 1);
    CHECK(decided == nodes - entered);
    CHECK(code(Unit::tri, 0) == config.tri_interval * run.triangle_tests);
    CHECK(code(Unit::shade, 0) % std::uint64_t(config.shade_interval) == 0);   // whole passes
    CHECK(code(Unit::node_cache, 0) + code(Unit::node_cache, 1) + code(Unit::node_cache, 2) == nodes);
    CHECK(code(Unit::prim_cache, 0) + code(Unit::prim_cache, 1) + code(Unit::prim_cache, 2) ==
          run.triangle_tests);
    for (const Unit cache :
         {Unit::node_cache, Unit::prim_cache, Unit::surf_cache, Unit::stream, Unit::tex_cache})
        CHECK(code(cache, 3) == code(cache, 1) + code(cache, 2));
    const std::uint64_t words = code(Unit::node_cache, 1) * std::uint64_t(config.node_line / line_bytes) +
                                code(Unit::prim_cache, 1) * std::uint64_t(config.prim_line / line_bytes) +
                                code(Unit::surf_cache, 1) * std::uint64_t(config.surf_line / line_bytes) +
                                code(Unit::stream, 1) * std::uint64_t(config.stream_line / line_bytes) +
                                code(Unit::tex_cache, 1) * std::uint64_t(config.tex_line / line_bytes);
    // A textured hit reads two lines: its record and its texels.
    CHECK(code(Unit::tex_cache, 0) + code(Unit::tex_cache, 1) + code(Unit::tex_cache, 2) ==
          code(Unit::tex, 0));
    CHECK(code(Unit::tex, 0) % 2 == 0);
    CHECK(code(Unit::memport, 0) == words);
    if (config.l2_sets > 0) CHECK(code(Unit::l2, 0) + code(Unit::l2, 1) + code(Unit::l2, 2) == words);
    const std::uint64_t requested =
        config.l2_sets > 0 ? code(Unit::l2, 1) * std::uint64_t(config.l2_line / line_bytes) : words;
    CHECK(run.memory.reads == requested + run.memory.scanned);
    CHECK(run.box_tests >= (config.is_bvh() ? steps : 0));
    CHECK(run.box_tests <= run.visits * std::uint64_t(config.node_width));
}

}   // namespace

LockstepResult check_lockstep(const Job& job, Disturbance disturbance, int seed) {
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame));
    return check_lockstep(job, frames, disturbance, seed);
}

LockstepResult check_lockstep(const Job& job, const std::vector<RecordedFrame>& frames,
                              Disturbance disturbance, int seed) {
    INFO("configuration " << job.config.name << ", jitter " << disturbance.jitter << ", stall "
                          << disturbance.stall_percent << ", seed " << disturbance.seed << ", RTL seed "
                          << seed);
    LockstepResult result = run_lockstep(job, frames, disturbance, {}, seed);
    if (result.first) {
        const Divergence& d = *result.first;
        UNSCOPED_INFO("first divergence: cycle " << d.cycle << " unit " << d.unit << " link " << d.link
                                                 << " ray " << d.ray << " pixel " << d.x << "," << d.y
                                                 << " expected " << d.expected << " got " << d.got);
    }
    const std::uint64_t pixels = frames.back().trace.rays.size();
    CHECK(result.agrees());
    CHECK(result.value_mismatches == 0);
    CHECK(result.account_mismatches == 0);
    CHECK(result.cycle_gap == 0);
    CHECK(result.events_compared >= 4 * pixels);
    CHECK(result.model.digest == result.rtl.digest);
    CHECK(result.model.hits.hits == result.rtl.hits.hits);
    CHECK(result.model.accounts == result.rtl.accounts);
    CHECK(result.model.memory == result.rtl.memory);
    for (const FrameResult* run : {&result.model, &result.rtl}) {
        CHECK(run->pixels == pixels);
        check_accounts(*run, job.config, frames.back().trace);
    }
    return result;
}

}   // namespace rayclock::test
