// Writes docs/measured/comparison-with-other-chips.md: simulated frames next to published figures of SaarCOR
// and RPU.
#include "sim/study/yardstick.hpp"

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "sim/run/film/film.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/request/request.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct Published {
    const char* scene;        // our scene
    const char* stands_for;   // the published scene, and the reason for the pair
    const char* saarcor;      // frames per second at 90 MHz, 512x384
    const char* rpu;          // frames per second at 66 MHz, 512x384
};

// All published figures were read in an abstract or in the press of the time.
constexpr Published published_rows[] = {
    {"gears:8", "Conference (282 k)", "20 to 60 over all scenes", "5.5, no shadows"},
    {"rings:3", "UT2003 (52 k)", "20 to 60 over all scenes", "7.5, precomputed light"},
    {"tree:6", "Mafia, Skeleton (15, 16 k)", "", "up to 20, best case"},
    {"balls:3", "SPD Balls, spheres as triangles", "", "1.2, with shadows and refraction"},
};

struct Size {
    FrameSize pixels;
    const char* name;
};
constexpr Size sizes[] = {{{512, 384}, "512x384"}, {{1024, 768}, "1024x768"}};

std::string hits_text(const FrameResult& run, Unit cache) {
    return fmt::format("{:.1f} %", 100 * cache_account(run, cache).hit_rate());
}

/// Returns one frame of the job at this clock.
FrameResult run_of(const Job& job, int khz, int threads, const Progress& progress) {
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame, threads, progress));
    const FrameResult run = frame_result(frames[0], replay(job.config, khz, frames, {}, progress)[0]);
    if (run.partial) throw Interrupted("interrupted: no page was written");
    return run;
}

struct Machine {
    const char* config;
    std::vector<std::string> set;
    int khz;
    bool rpu = false;   ///< compared with the RPU; otherwise with SaarCOR
};
/// Both chips walked kd-trees. With this bound on references the tree of the largest scene fits their 64 MB.
const std::vector<std::string> as_published{"structure=kd", "references=5"};

std::string machine_table(const Machine& machine, int threads, const Progress& progress) {
    const Config config = load_config({machine.config, machine.set});
    const int khz = machine.khz;
    Table table({"scene", "triangles", "picture", "fps", "cycles/ray", "node hits", "triangle hits",
                 "bytes/ray", "memory MB/s (of peak)", "bound, reached", "published fps, 512x384"},
                Table::words_only);
    for (const Published& row : published_rows)
        for (const Size& size : sizes) {
            const Scene scene = ready_scene(row.scene, size.pixels, progress);
            const Job job = make_job(scene, *scene.camera, size.pixels, config, progress);
            const FrameResult run = run_of(job, khz, threads, progress);
            const Bound bound = bound_of(config, khz, run);
            const double fps = per_second(run, khz), rays = double(run.pixels),
                         rate = fps * double(bytes_read(run));
            const char* published = machine.rpu ? row.rpu : row.saarcor;
            table.add({fmt::format("{} for {}", row.scene, row.stands_for), grouped(scene.triangles.size()),
                       size.name, fmt::format("{:.1f}", fps),
                       fmt::format("{:.1f}", double(run.cycles) / rays), hits_text(run, Unit::node_cache),
                       hits_text(run, Unit::prim_cache),
                       fmt::format("{:.0f}", double(bytes_read(run)) / rays),
                       fmt::format("{:.0f} ({:.0f} %)", rate / 1e6,
                                   100 * rate / peak_bytes_per_second(config, khz)),
                       fmt::format("{}, {:.0f} %", bound.unit, bound.reached * 100),
                       size.pixels.width == 512 ? published : ""});
        }
    return table.markdown();
}

struct FinishedRow {
    const char* scene;
    const char* stands_for;
    const char* config;
    int mhz;
    int pipelines;
    const char* published;
    bool walks_kd() const { return std::string_view(config) == "rpu"; }
};
constexpr FinishedRow finished_rows[] = {
    {"balls:4", "SPD Balls, native spheres", "rpu", 66, 1, "RPU 1.2, shadows and refraction"},
    {"balls:4", "SPD Balls, native spheres", "default", 66, 1, "RPU 1.2, shadows and refraction"},
    {"balls:4", "SPD Balls, native spheres", "default", 66, 4, "RPU 1.2, shadows and refraction"},
    {"spheres", "Spheres-RT, reflective and refractive", "rpu", 66, 1, "RPU 4.5"},
    {"gears:4", "SPD Gears, clear and opaque", "rpu", 66, 1, ""},
    {"gears:4", "SPD Gears, clear and opaque", "default", 66, 4, ""},
    {"mount:6", "SPD Mountain with glass", "default", 66, 1, ""},
    {"rings:3", "SPD Rings", "default", 66, 1, ""},
    {"teapot:12", "SPD Teapot", "default", 66, 1, ""},
    {"tree:8", "SPD Tree, 7 lights", "default", 66, 1, ""},
};

/// Returns the table of finished pictures: shadows of all lights and up to 4 bounces, counted as Haines
/// counts rays.
std::string finished_table(int threads, const Progress& progress) {
    Table table({"scene", "configuration, MHz, pipelines", "fps", "Mrays/s", "rays/pixel", "cycles/ray",
                 "node, primitive, surface hits", "bytes/ray", "bound, reached", "shade busy",
                 "published fps, 512x384"},
                Table::words_only);
    for (const FinishedRow& row : finished_rows) {
        const FrameSize size{512, 384};
        ConfigChoice choice{row.config, {fmt::format("pipelines={}", row.pipelines), "stack_depth=64"}};
        if (row.walks_kd()) choice.set.insert(choice.set.end(), as_published.begin(), as_published.end());
        Finish finish;
        finish.depth = 4;
        const Request request = request_of(row.scene, choice, finish, 1, size, progress);
        const Job job =
            make_job(request.scene, *request.scene.camera, size, request.config, progress, request.settings);
        const FrameResult run = run_of(job, 1000 * row.mhz, threads, progress);
        const Bound bound = bound_of(job.config, 1000 * row.mhz, run);
        const double fps = per_second(run, 1000 * row.mhz), rays = rays_of(run);
        const auto hits = [&](Unit cache) { return 100 * cache_account(run, cache).hit_rate(); };
        const double busy = double(run.accounts.units[index(Unit::shade)][0]) /
                            double(run.cycles * std::uint64_t(row.pipelines));
        table.add({fmt::format("{}: {}", row.scene, row.stands_for),
                   fmt::format("{}, {}, {}", row.config, row.mhz, row.pipelines), fmt::format("{:.1f}", fps),
                   fmt::format("{:.1f}", fps * rays / 1e6), fmt::format("{:.2f}", rays / double(run.pixels)),
                   fmt::format("{:.1f}", double(run.cycles) / rays),
                   fmt::format("{:.1f}, {:.1f}, {:.1f} %", hits(Unit::node_cache), hits(Unit::prim_cache),
                               hits(Unit::surf_cache)),
                   fmt::format("{:.1f}", double(bytes_read(run)) / rays),
                   fmt::format("{}, {:.0f} %", bound.unit, bound.reached * 100),
                   fmt::format("{:.0f} %", 100 * busy), row.published});
    }
    return table.markdown();
}

struct VortexRow {
    const char* config;
    std::vector<std::string> set;
    const char* includes;
};

/// Returns the table of the cube that Vortex draws. It has the same mesh, camera and size.
std::string vortex_table(int threads, const Progress& progress) {
    const VortexRow rows[] = {{"default", {}, "camera rays; colours are computed outside the chip"},
                              {"ulx3s", {}, "camera rays; colours are computed outside the chip"},
                              {"default", {"shading=1"}, "camera rays, a shadow ray for each hit, colours"}};
    const FrameSize size{32, 24};
    Table table({"machine", "cycles", "cycles/pixel", "includes"}, Table::words_only);
    for (const VortexRow& row : rows) {
        Finish finish;
        if (!row.set.empty()) finish.depth = 0;
        const Request request = request_of("cube", {row.config, row.set}, finish, 1, size, progress);
        const Job job =
            make_job(request.scene, *request.scene.camera, size, request.config, progress, request.settings);
        const FrameResult run = run_of(job, 100'000, threads, progress);
        table.add({fmt::format("`{}`{}", row.config, row.set.empty() ? "" : ", `" + row.set[0] + "`"),
                   grouped(run.cycles), fmt::format("{:.1f}", double(run.cycles) / double(run.pixels)),
                   row.includes});
    }
    constexpr std::uint64_t pixels = 32 * 24;
    for (const auto& [threads_of_core, cycles] : {std::pair{16, 51'652u}, {4, 156'410u}})
        table.add({fmt::format("Vortex, {} threads", threads_of_core), grouped(cycles),
                   fmt::format("{:.1f}", double(cycles) / pixels),
                   "start of the program, camera rays and colours in software, no shadow rays"});
    return table.markdown();
}

constexpr const char* intro = R"(# Comparison with SaarCOR, RPU and Vortex

Made by `rayclock study yardstick -o docs/measured/comparison-with-other-chips.md`. All figures of
this machine are simulated.

**The scenes differ**, except in the section on Vortex. The scenes of SaarCOR and RPU cannot be shipped. This
page replaces them by procedural scenes with about the same number of triangles, each with its own camera. The
published figures include the effects that the papers name (shadows, textures, several lights). This page's
figures are for **primary rays with shading outside the chip**, except in the table of finished pictures. So this page shows the range of such a machine, not which machine
is faster.

**The machines differ.** Both chips computed in 24-bit floating point with packets of four rays. This machine
computes in fixed point, ray by ray. The class is the same: one node and
one triangle a cycle, and the clock, rays in flight, cache sizes and memory speed of the chip
([configurations](../guide/configurations.md)). The tree is a kd-tree with one plane a node (`structure=kd` with
`node_width=2`). With `references=5` the image of gears:8 fits 64 MB. A second table has the same machine with a tree of boxes, two children
a node, which the program's `saarcor` and `rpu` walk by default.
)";

constexpr const char* sources = R"(
## Sources of the published figures

- SaarCOR prototype: Schmittler, Woop, Wagner, Paul, Slusallek, *Realtime Ray Tracing of Dynamic Scenes
  on an FPGA Chip*, Graphics Hardware 2004: 90 MHz on one FPGA, 20 to 60 frames per second over its
  scenes with textures, several lights and several levels of reflection. The abstract was read. The size
  512x384 is recalled from press reports.
- RPU prototype: Woop, Schmittler, Slusallek, *RPU: A Programmable Ray Processing Unit for Realtime Ray
  Tracing*, SIGGRAPH 2005: 66 MHz on one FPGA, 512x384, up to 20 frames per second; Conference without
  shadows 5.5, UT2003 with precomputed light 7.5, SPD Balls with shadows and refraction 1.2. A scholarly
  archive's copy was read.
- D-RPU prototype: Woop, Marmitt, Slusallek, *B-KD Trees for Hardware Accelerated Ray Tracing of Dynamic
  Scenes*, Graphics Hardware 2006: up to 35 frames per second at 66 MHz on one FPGA, dynamic scenes
  included. The abstract was read.
- Vortex: `ci/baselines/perf/raytracing.json` and `tests/raytracing/rt_raycast` of the repository
  vortexgpgpu/vortex, read in 2026.
)";

}   // namespace

std::string yardstick_page(const RoutedBoard& board, int threads, const Progress& progress) {
    std::string page = intro;
    if (board.khz > 0)
        page += fmt::format(
                    "\n## `ulx3s` at {:.1f} MHz, a routed clock\n\nThis is the only clock of this page that "
                    "was routed ({}, [silicon.md](silicon.md)); the others are those of the published chips, "
                    "or assumed. Four children a node, a test every second cycle, the board's SDRAM. The "
                    "published column shows SaarCOR.\n\n",
                    board.khz / 1e3, board.device) +
                machine_table({"ulx3s", {}, board.khz}, threads, progress);
    for (const bool rpu : {false, true}) {
        const char* name = rpu ? "rpu" : "saarcor";
        const int khz = rpu ? 66000 : 90000;
        page += fmt::format("\n## `{}` at {} MHz\n\n", name, khz / 1000) +
                machine_table({name, as_published, khz, rpu}, threads, progress) + "\nWith boxes:\n\n" +
                machine_table({name, {}, khz, rpu}, threads, progress);
    }
    page +=
        "\n## For comparison: `default` at 66 MHz\n\nEight children a node, 16 KB of each cache, DDR3. The "
        "published column shows SaarCOR at 90 MHz.\n\n";
    page += machine_table({"default", {}, 66000}, threads, progress);
    page +=
        "\n## Finished pictures\n\nThe chip computes the colours: shadow rays to every light, reflection and "
        "refraction by the scene's materials, four bounces (Haines' depth 5), one sample a pixel, 512x384. "
        "Spheres are native; other round objects are triangles. `rpu` walks a kd-tree here too.\n\n";
    page += finished_table(threads, progress);
    page +=
        "\n## The same scene: Vortex's cube\n\nThe test `rt_raycast` of Vortex draws a cube of 12 triangles "
        "in "
        "32x24 pixels. The built-in scene `cube` has this mesh and this camera. Our cycles begin with empty "
        "caches at the start of the frame, at 100 MHz, and end with the last pixel. Writing the scene into "
        "memory is not included on either side. Vortex is a general processor with a unit for rays, so these "
        "figures compare systems, not units.\n\n";
    page += vortex_table(threads, progress);
    page += fmt::format(
        "\n## Scenes that move\n\nTwo levels ([motion.md](../machine/motion.md)), boxes in both, camera "
        "rays, 512x384; means of {} frames after the first, {:g} in a second of the scene's time. For every "
        "frame the host rebuilds the scene's tree and writes it into the chip's memory; fps includes these "
        "writes. In SaarCOR a unit transforms each ray into an object's space, as in this machine; "
        "the D-RPU refitted trees of moving vertices. The papers have no figures for these scenes.\n\n",
        moving_frames, usual_fps);
    page += moving_table(threads, progress);
    const auto cycles_per_pixel = [](double mhz, double fps) { return 1e6 * mhz / fps / (512 * 384); };
    return page + sources +
           fmt::format(
               "- Computed from these: at 20 to 60 frames per second SaarCOR spends {:.1f} to {:.1f} cycles "
               "on a "
               "pixel; at 5.5 the RPU\n  spends {:.0f} on Conference.\n",
               cycles_per_pixel(90, 20), cycles_per_pixel(90, 60), cycles_per_pixel(66, 5.5));
}

}   // namespace rayclock
