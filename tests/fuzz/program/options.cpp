// The command line: main() of the program, with commands that only read their options.
//
// An input has a word in each line. Whatever a command would do after it has read its options is left out, so that nothing is
// written, built or drawn.
#include <array>
#include <cstdlib>
#include <vector>

#include "model/scene/builtin.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/limits.hpp"
#include "sim/files/streams.hpp"
#include "sim/sweep/axes.hpp"
#include "tests/fuzz/program/targets.hpp"

int rayclock_main(int argc, char** argv);   // sim/app/main.cpp

namespace rayclock {

namespace {

int clock_khz(const std::string& text) { return parse_clocks(text).at(0); }

/// All options are read, whichever command has them; each refusal must be a sentence, and the last one is thrown.
int read_options(const Options& o) {
    std::string refused;
    const auto read = [&](const auto& part) {
        try {
            part();
        } catch (const UserError& error) {
            fuzz::check_sentence(refused = error.what());
        }
    };
    for (const std::string& size : {o.size, o.figure_size, o.count_size})
        read([&] {
            const FrameSize frame = parse_size(size);
            fuzz::demand(frame.width > 0 && frame.height > 0 && std::int64_t{frame.width} * frame.height <= 1 << 26, "a picture has a sensible size");
        });
    read([&] {
        for (const int khz : parse_clocks(o.clock)) fuzz::demand(khz >= 1000 && khz <= 100'000'000, "a clock is in range");
    });
    read([&] {
        const Config config = load_config(o.config, o.set);
        std::vector<sweep::Axis> axes;
        for (const std::string& axis : o.axes) axes.push_back(sweep::parse_axis(axis));
        if (!axes.empty()) sweep::make_points(axes, config, 66000, clock_khz);
    });
    read([&] { parse_values("--bits", o.bits); });
    read([&] { fuzz::demand(parse_rays(o.rays) >= 1, "there is a ray"); });
    read([&] { fuzz::demand(parse_percent("--max-error", o.max_error, false) > 0, "an error may be above 0"); });
    read([&] { parse_percent("--max-work", o.max_work, true); });
    read([&] { limits_of(o); });
    read([&] { traffic_of(o); });
    read([&] { camera_path(o, Camera{}); });
    read([&] {
        if (is_builtin(o.scene)) builtin_counts(o.scene, o.fresnel ? Primitives::native : Primitives::triangles);
    });
    if (!refused.empty()) throw UserError(refused);
    return 0;
}

} // namespace

#define COMMAND(name) int name##_command(const Options& options) { return read_options(options); }
COMMAND(render)
COMMAND(simulate)
COMMAND(verify)
COMMAND(torture)
COMMAND(sweep)
COMMAND(stress)
COMMAND(fit)
COMMAND(tradeoff)
COMMAND(yardstick)
COMMAND(figures)
COMMAND(counts)
COMMAND(area)
COMMAND(bench)
COMMAND(scenes)
COMMAND(config)
COMMAND(rtl)
COMMAND(doctor)

void show_builds() {}
const std::vector<std::string>& default_tradeoff_scenes() {
    static const std::vector<std::string> scenes{"gears:4"};
    return scenes;
}
std::vector<std::string> published_scenes() { return {"gears:4"}; }

// The streams stay as libFuzzer has them.
void guard_streams() {}
void write_output(std::string_view) {}
std::string finish_output() { return {}; }

} // namespace rayclock

namespace rayclock::fuzz {

void options(std::string_view bytes) {
    constexpr std::size_t most = 200;
    std::vector<std::string> words{"rayclock"};
    for (const char c : bytes) {
        if (c == '\n' && words.size() < most) words.emplace_back();
        else if (words.size() == 1) words.push_back(c == '\0' ? std::string{} : std::string(1, c));
        else if (c != '\0') words.back() += c;
    }
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int code = rayclock_main(static_cast<int>(words.size()), arguments.data());
    demand(code == 0 || code == 2, "options are good, or refused as a UserError");
}

} // namespace rayclock::fuzz
