// rayclock fit: the smallest configuration that draws a scene within a bound, and the proof that nothing in it overflows.
#include <chrono>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/quote.hpp"
#include "sim/app/commands.hpp"
#include "sim/fit/dominant.hpp"
#include "sim/fit/report.hpp"
#include "sim/report/json.hpp"
#include "sim/report/text.hpp"

namespace rayclock {

namespace {

using namespace fit;

Goal goal_of(const Options& o) {
    Goal goal;
    goal.max_error = parse_percent("--max-error", o.max_error, false);
    goal.max_work = parse_percent("--max-work", o.max_work, true);
    goal.min_psnr = o.min_psnr;
    check_psnr(o);
    return goal;
}

/// gears:8 -> gears-8, scenes/desk.json -> desk.
std::string name_of(const std::string& scene) {
    const bool file = scene.find(':') == std::string::npos;
    std::string name = file ? std::filesystem::path(scene).stem().string() : scene;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    return name;
}

std::string goal_text(const Goal& b) {
    return fmt::format("at most {:g} % of the pixels on another primitive than the reference's{}, and {:g} % more nodes and triangles than at best", b.max_error,
                       b.min_psnr ? fmt::format(", PSNR {:g} dB", *b.min_psnr) : "", b.max_work);
}

/// One sentence: what is reached, what makes the scene large, and what would do without it.
std::string hopeless(const Options& o, const Goal& goal, const Config& base, Measure& measure, const Config& closest) {
    const Outcome& best = measure(closest);
    std::string sentence = fmt::format("{}: no width keeps the bound; N = {} and M = {} come closest, ", printable(o.scene), closest.coord_bits, closest.dir_bits);
    if (!best.refused.empty()) sentence += "and there " + best.refused;
    else sentence += fmt::format("with {:.3g} % of the pixels on another primitive{}", best.other_percent(),
                                 goal.min_psnr ? fmt::format(" and a PSNR of {:.1f} dB", best.psnr_db) : "");
    const std::optional<Dominant> part = dominant_part(measure.scene());
    if (!part) return sentence + "; its extents are even, so only a larger bound or a camera that sees less of it at once would help";
    sentence += fmt::format("; because of {} the scene is {} times as large as the rest", part->what,
                            part->ratio < 100 ? fmt::format("{:.1f}", part->ratio) : grouped(std::uint64_t(part->ratio)));
    Measure rest(part->without, measure.size(), o.threads);
    rest.tell = measure.tell;
    const std::optional<int> bits = Search(rest, base, goal).smallest_coord_bits();
    return sentence + (bits ? fmt::format(", and without that N = {} would do", *bits)
                            : std::string(", but without that no width would do either"));
}

} // namespace

int fit_command(const Options& o) {
    const auto start = std::chrono::steady_clock::now();
    catch_interrupts();
    const FrameSize size = parse_size(o.size);
    const Goal goal = goal_of(o);
    const Config base = load_config(o.config, o.set);
    if (base.test() != PrimitiveTest::exact)
        throw UserError("fit: primitive_test must be exact, not " + primitive_test_names()[std::size_t(base.primitive_test)] +
                        ": only exact decisions make the primitives depend on N and M alone");
    check_outputs(o);
    if (o.output != "-") check_writable(o.output);
    else if (o.json == "-") throw UserError("-o and --json cannot both go to standard output");
    const Progress progress = terminal_progress();
    const Scene scene = ready_scene(o, size, progress);
    Measure measure(scene, size, o.threads);
    measure.tell = [&](const Config& c, std::size_t done) {
        constexpr std::size_t expected = 40;
        if (progress) progress(fmt::format("fit, N = {}, M = {}", c.coord_bits, c.dir_bits), done, std::max(expected, done + 1));
    };
    Search search(measure, base, goal);
    std::optional<Fit> found = search.run();
    if (!found) {
        const std::string sentence = hopeless(o, goal, base, measure, search.closest());
        if (progress) progress("fit", 1, 1);
        throw std::runtime_error(sentence);
    }
    Fit& fit = *found;
    fit.config.name = printable(name_of(o.scene), 80);
    const Job job = make_job(scene, *scene.camera, size, fit.config);
    const Ranges ranges = prove_ranges(job.image, job.frame, fit.config);
    if (progress) progress("fit", 1, 1);
    if (!ranges.proven()) throw std::logic_error("a signal of the fitted machine may overflow:\n" + range_table(ranges));
    write_file(o.output, config_json_object(fit.config).dump(2) + "\n");

    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Outcome& result = fit.outcome;
    if (o.json != "-" && o.output != "-") {
        fmt::print("{}, {} triangles, {}x{}: {}\n\n", scene.name, grouped(scene.triangles.size()), size.width, size.height, goal_text(goal));
        fmt::print("{}\n{}\n", parameter_table(fit, base), needs_text(fit, base, ranges));
        fmt::print("{}\n", units_text(fit.config));
        fmt::print("{}\n", range_table(ranges));
        fmt::print("  {} of {} pixels hold another primitive ({:.3f} %), PSNR {}; {:.1f} % more nodes and triangles than with the widest fields\n", grouped(result.other),
                   grouped(result.pixels), result.other_percent(), std::isfinite(result.psnr_db) ? fmt::format("{:.1f} dB", result.psnr_db) : "infinite",
                   100 * (double(result.work) / double(fit.widest.work) - 1));
        fmt::print("  {} written after {} frames in {:.1f} s; rayclock verify {} --size {} --config {}\n", printable(o.output), measure.done(), seconds, printable(o.scene), o.size,
                   printable(o.output.find_first_of("./") == std::string::npos ? "./" + o.output : o.output));
    }
    if (!o.json.empty()) {
        const nlohmann::ordered_json json{
            {"scene", scene_json(scene)}, {"frame", {{"width", size.width}, {"height", size.height}}},
            {"bounds", {{"max_error_percent", goal.max_error}, {"min_psnr_db", goal.min_psnr ? nlohmann::ordered_json(*goal.min_psnr) : nlohmann::ordered_json(nullptr)},
                        {"max_work_percent", goal.max_work}}},
            {"config", config_json_object(fit.config)}, {"parameters", parameters_json(fit, base)}, {"error", outcome_json(result)}, {"widest", outcome_json(fit.widest)},
            {"compile", compile_json(result.compile)}, {"needs", needs_json(fit, ranges)}, {"units", units_json(fit.config)},
            {"cost", {{"fitted", cost_json(fit.cost)}, {"base", cost_json(fit.base_cost)}}}, {"ranges", ranges_json(ranges)},
            {"host", {{"seconds", seconds}, {"frames", measure.done()}}}};
        write_file(o.json, json.dump(2) + "\n");
    }
    return 0;
}

} // namespace rayclock
