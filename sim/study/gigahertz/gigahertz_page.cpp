// Writes the page of the study of processor clocks.
#include "sim/study/gigahertz/gigahertz_page.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/files/table.hpp"

namespace rayclock::gigahertz {

namespace {

int slowest() { return clocks().front(); }
int fastest() { return clocks().back(); }
int fewest() { return pipelines().front(); }
int most() { return pipelines().back(); }
double growth() { return double(fastest()) / slowest(); }

/// Formats a number with three significant digits.
std::string fps_text(double fps) {
    return fps < 9.995   ? fmt::format("{:.2f}", fps)
           : fps < 99.95 ? fmt::format("{:.1f}", fps)
                         : grouped(std::uint64_t(std::llround(fps)));
}
std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }
std::string megarays(double rays) { return fps_text(rays / 1e6); }

/// Returns the frames per second at the fastest clock relative to the slowest, with equal pipelines.
double gain(const Figures& f, std::size_t memory, int p) {
    return f.at(memory, fastest(), p).fps / f.at(memory, slowest(), p).fps;
}

/// Returns the first clock at which a frame takes more than twice the cycles of the slowest clock; 0 if there
/// is none.
int wall(const Figures& f, std::size_t memory, int p) {
    for (const int mhz : clocks())
        if (f.at(memory, mhz, p).cycles > 2 * f.at(memory, slowest(), p).cycles) return mhz;
    return 0;
}

/// Returns the limit of a frame: the memory's part that was busy, or the chip's own bound if memory did not
/// limit it.
std::string reason(std::size_t memory, const Frame& frame) {
    const bool is_ideal = memories()[memory].dram == "ideal";
    if (is_ideal ? frame.busy >= 0.6
                 : frame.bound.unit == "memory" && frame.bound.reached > frame.busy + 0.05)
        return fmt::format("the chip's port to memory, 64 bytes a cycle, at {} of its bound",
                           percent(is_ideal ? frame.busy : frame.bound.reached));
    if (frame.busy >= 0.6)
        return fmt::format("the memory's bus, which has data in {} of the time", percent(frame.busy));
    if (frame.busy + frame.waits >= 0.6)
        return fmt::format("rows and latency: the memory has requests in {} of the time, and data in {}",
                           percent(frame.busy + frame.waits), percent(frame.busy));
    if (frame.bound.reached >= 0.6)
        return fmt::format("{}, at {} of the bound",
                           frame.bound.unit == "tri" ? "triangle tests" : "node visits",
                           percent(frame.bound.reached));
    return fmt::format("the chip's own latencies, at {} of its bound", percent(frame.bound.reached));
}

std::vector<std::string> with_clocks(std::string first) {
    std::vector<std::string> head{std::move(first)};
    for (const int mhz : clocks()) head.push_back(fmt::format("{} MHz", mhz));
    return head;
}

Table clock_table(const Figures& f, int p) {
    Table table(with_clocks("memory"));
    for (std::size_t m = 0; m < memories().size(); ++m) {
        std::vector<std::string> row{memories()[m].name};
        for (const int mhz : clocks()) row.push_back(fps_text(f.at(m, mhz, p).fps));
        table.add(row);
    }
    return table;
}

Table pipeline_table(const Figures& f) {
    std::vector<std::string> head{"memory"};
    for (const int p : pipelines()) head.push_back(fmt::format("{} pipeline{}", p, p == 1 ? "" : "s"));
    Table table(head);
    for (std::size_t m = 0; m < memories().size(); ++m) {
        std::vector<std::string> row{memories()[m].name};
        for (const int p : pipelines()) row.push_back(fps_text(f.at(m, fastest(), p).fps));
        table.add(row);
    }
    return table;
}

Table wall_table(const Figures& f, int p) {
    Table table({"memory", "times the frames", "wall, MHz", "limit at the last clock"}, Table::words_only);
    for (std::size_t m = 0; m < memories().size(); ++m) {
        const int at = wall(f, m, p);
        table.add({memories()[m].name, fmt::format("{:.1f}", gain(f, m, p)), at ? std::to_string(at) : "none",
                   reason(m, f.at(m, fastest(), p))});
    }
    return table;
}

Table cure_table(const Figures& f) {
    Table table({"memory", "as it is", "four times the rays in flight", "a shared cache of 1 MB"});
    for (std::size_t m = 0; m < memories().size(); ++m) {
        std::vector<std::string> row{memories()[m].name};
        for (int c = 0; c < remedies; ++c) row.push_back(fps_text(f.at(m, fastest(), most(), Remedy(c)).fps));
        table.add(row);
    }
    return table;
}

Table finished_table(const Figures& f) {
    std::vector<std::string> head{"memory"};
    for (const int mhz : {slowest(), fastest()})
        for (const int p : {fewest(), most()})
            head.push_back(fmt::format("{} MHz, {} pipeline{}", mhz, p, p == 1 ? "" : "s"));
    Table table(head);
    for (std::size_t m = 0; m < memories().size(); ++m) {
        std::vector<std::string> row{memories()[m].name};
        for (const int mhz : {slowest(), fastest()})
            for (const int p : {fewest(), most()}) {
                const Frame& frame = f.finished.at({m, mhz, p, Remedy::none});
                row.push_back(fmt::format("{} ({})", fps_text(frame.fps), megarays(frame.rays_per_second())));
            }
        table.add(row);
    }
    return table;
}

/// Published figures of other machines. Camera rays per second are computed from pixels and frames.
struct Published {
    const char* what;
    const char* machine;
    FrameSize size;
    double from, to;   ///< frames per second; without a size, million rays per second
    const char* note;
};
constexpr Published published[]{
    {"Enemy Territory: Quake Wars, ray traced, June 2008",
     "four quad-core Xeons of 2.93 GHz",
     {1280, 720},
     14,
     29,
     "shadow, reflected and refracted rays come on top; how many is not stated"},
    {"the same, August 2008", "four six-core Xeons X7460 of 2.66 GHz", {1280, 720}, 20, 35, "the same"},
    {"NVIDIA at SIGGRAPH 2008",
     "four Quadro graphics processors",
     {1920, 1080},
     0,
     30,
     "two million polygons, three bounces, shadows; rays a pixel not stated"},
    {"Shih et al. 2009, CUDA", "one graphics processor", {0, 0}, 30, 43, "all rays, simple shading"},
};
constexpr const Published& quake_wars = published[1];

double rays_of(const Published& p, double fps) { return fps * double(p.size.width) * p.size.height; }

Table published_table() {
    Table table({"what", "machine", "picture", "fps", "million camera rays a second", "note"},
                Table::words_only);
    for (const Published& p : published) {
        const bool pictures = p.size.width > 0;
        const auto range = [&](double from, double to) {
            return from > 0 ? fps_text(from) + " to " + fps_text(to) : "up to " + fps_text(to);
        };
        table.add(
            {p.what, p.machine, pictures ? fmt::format("{}x{}", p.size.width, p.size.height) : "not stated",
             pictures ? fmt::format("{}{:g}", p.from > 0 ? fmt::format("{:g} to ", p.from) : "up to ", p.to)
                      : "not stated",
             pictures ? range(rays_of(p, p.from) / 1e6, rays_of(p, p.to) / 1e6) : range(p.from, p.to),
             p.note});
    }
    return table;
}

Table ours_table(const Figures& f) {
    Table table(with_clocks("pipelines, memory"));
    for (const int p : {fewest(), most()})
        for (std::size_t m = 0; m < memories().size(); ++m) {
            std::vector<std::string> row{fmt::format("{}, {}", p, memories()[m].name)};
            for (const int mhz : clocks()) row.push_back(megarays(f.at(m, mhz, p).rays_per_second()));
            table.add(row);
        }
    return table;
}

/// Returns the slowest clock at which the machine traces at least `rays` camera rays per second; 0 if there
/// is none.
int clock_of(const Figures& f, std::size_t memory, int p, double rays) {
    for (const int mhz : clocks())
        if (f.at(memory, mhz, p).rays_per_second() >= rays) return mhz;
    return 0;
}

std::string name_list(const std::vector<std::string>& names) {
    if (names.empty()) return "none";
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

/// Names the clocks at which the machine exceeds the camera rays of Quake Wars.
std::string passed_text(const Figures& f) {
    const double rays = rays_of(quake_wars, quake_wars.to);
    std::string text = fmt::format(
        "Quake Wars on 24 cores traced {} camera rays a second, and other rays too. This machine traces as "
        "many camera rays ",
        grouped(std::uint64_t(rays)));
    for (const int p : {fewest(), most()}) {
        std::vector<std::string> parts;
        for (const int mhz : clocks()) {
            std::vector<std::string> names;
            for (std::size_t m = 0; m < memories().size(); ++m)
                if (clock_of(f, m, p, rays) == mhz) names.push_back(memories()[m].name);
            if (!names.empty()) parts.push_back(fmt::format("from {} MHz on {}", mhz, name_list(names)));
        }
        std::vector<std::string> never;
        for (std::size_t m = 0; m < memories().size(); ++m)
            if (clock_of(f, m, p, rays) == 0) never.push_back(memories()[m].name);
        if (!never.empty()) parts.push_back("never on " + name_list(never));
        text += fmt::format("{}with {} pipeline{} {}", p == fewest() ? "" : "; ", p, p == 1 ? "" : "s",
                            fmt::join(parts, ", "));
    }
    return text + ". ";
}

/// Returns the geometric mean of a remedy's gain over all memories except the ideal one, at the last clock
/// with the most pipelines.
double remedy_gain(const Figures& f, Remedy remedy) {
    double sum = 0;
    int count = 0;
    for (std::size_t m = 0; m < memories().size(); ++m) {
        if (memories()[m].dram == "ideal") continue;
        sum += std::log(f.at(m, fastest(), most(), remedy).fps / f.at(m, fastest(), most()).fps);
        ++count;
    }
    return std::exp(sum / count);
}

std::string answer(const Figures& f) {
    constexpr double nearly = 0.8;   // of the gain that the clock alone would give
    std::string text =
        fmt::format("If frames followed the clock, {} to {} MHz would give {:.0f} times the frames. ",
                    slowest(), fastest(), growth());
    for (const int p : {fewest(), most()}) {
        std::vector<std::string> hold, gains;
        for (std::size_t m = 0; m < memories().size(); ++m) {
            if (gain(f, m, p) >= nearly * growth())
                hold.push_back(memories()[m].name);
            else
                gains.push_back(fmt::format("{:.1f} times on {}", gain(f, m, p), memories()[m].name));
        }
        text += fmt::format(
            "With {} pipeline{} the gain on {} is at least {} of this factor. Elsewhere it is {}. ", p,
            p == 1 ? "" : "s", name_list(hold), percent(nearly), name_list(gains));
    }
    text += passed_text(f);
    return text + fmt::format(
                      "At {} MHz, {} pipelines and all memories except `ideal`, four times the rays in "
                      "flight draw {:.2f} times the frames, and a shared cache of 1 MB {:.2f} times "
                      "(geometric means). A faster clock helps until the memory's bus, rows or latency limit "
                      "the frame. Then more bandwidth or larger caches help.\n",
                      fastest(), most(), remedy_gain(f, Remedy::contexts), remedy_gain(f, Remedy::cache));
}

constexpr const char* intro = R"(# At the clocks of processors

Made by `{}`, with the model only. All figures of this machine are simulated.

The papers of SaarCOR and RPU compare chips of 66 and 90 MHz with processors at 30 times that clock, and do not
scale the results. This page simulates faster chips. **All clocks here are assumed**: no chip of this machine
was routed at any of them ([silicon.md](silicon.md) has the routed clocks). The memory keeps its own time
([memories](../guide/configurations.md#memories)), so a chip with a faster clock waits more cycles for it. "x 2" means
two channels side by side.

Configuration `{}` with 1 to 16 pipelines, {}x{} camera rays of {} ({} triangles), one frame with
cold caches. The pipelines share only one port to memory, of 64 bytes a cycle. `ideal` answers after 8 cycles
at any clock; real memories cannot.
)";

constexpr const char* wall_words = R"(
## Where the memory wall is, and why

The *memory wall* is the first clock at which a frame takes more than twice the cycles of {} MHz: beyond it a faster
clock loses most of its effect. *Times the frames* compares {} MHz with {} MHz, where the clock alone is
{:.1f} times as fast.
)";

}   // namespace

std::string page(const Figures& f, const Study& study, const std::string& command,
                 const std::string& picture) {
    std::string text = fmt::format(fmt::runtime(intro), command, study.base.name, study.size.width,
                                   study.size.height, study.scene, grouped(f.triangles));
    text += "\n## Frames per second\n";
    for (const int p : {fewest(), most()})
        text += fmt::format("\n{} pipeline{}:\n\n", p, p == 1 ? "" : "s") + clock_table(f, p).markdown();
    text += fmt::format("\n![Frames per second against the clock]({}.svg)\n", picture);
    text += fmt::format("\nAt {} MHz, by pipelines:\n\n", fastest()) + pipeline_table(f).markdown();
    text += fmt::format(fmt::runtime(wall_words), slowest(), fastest(), slowest(), growth());
    for (const int p : {fewest(), most()})
        text += fmt::format("\n{} pipeline{}:\n\n", p, p == 1 ? "" : "s") + wall_table(f, p).markdown();
    text +=
        fmt::format("\nTwo changes to the chip: fps at {} MHz with {} pipelines.\n\n", fastest(), most()) +
        cure_table(f).markdown();
    text += fmt::format(
        "\n## Finished pictures\n\n{} with shadows and up to 4 bounces, {}x{}, {:.2f} rays a pixel: fps, and "
        "in "
        "brackets million rays a second.\n\n",
        study.finished_scene, study.size.width / 2, study.size.height / 2, f.finished_rays_per_pixel);
    text += finished_table(f).markdown();
    text +=
        "\n## Comparison with published figures\n\nProcessors and graphics processors of 2008 and 2009, with "
        "other scenes. Where only frames were published, the camera rays of a second are pixels times "
        "frames.\n\n";
    text += published_table().markdown();
    text += "\nOurs, million camera rays a second, by clock:\n\n" + ours_table(f).markdown();
    text +=
        "\nSources: techreport.com 14946 (June 2008); pcgameshardware.com 673899 and tomshardware.fr (August "
        "2008); electronicdesign.com 21764335 (NVIDIA); the abstract of Shih et al. Purcell et al. 2002, the "
        "first ray tracer on a (simulated) graphics processor, is not in the table.\n";
    return text + "\n## Do frames follow the clock?\n\n" + answer(f);
}

}   // namespace rayclock::gigahertz
