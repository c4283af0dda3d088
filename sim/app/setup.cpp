#include "sim/app/setup.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "model/core/error.hpp"
#include "model/core/quote.hpp"
#include "sim/image/image.hpp"
#include "sim/load/load.hpp"

namespace rayclock {

namespace {

template <class Number> bool parse_whole(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

} // namespace

FrameSize parse_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    FrameSize size;
    if (cross == std::string::npos || !parse_whole(std::string_view(text).substr(0, cross), size.width) ||
        !parse_whole(std::string_view(text).substr(cross + 1), size.height))
        throw UserError("--size: " + shown(text) + " is not WIDTHxHEIGHT, for example 512x384");
    check_frame_size(size);
    constexpr int most = 1 << 26;   // what fits in a few gigabytes of host memory
    if (size.width > most / size.height) throw UserError(fmt::format("--size: {} has more than {} pixels", text, most));
    return size;
}

std::vector<int> parse_clocks(const std::string& text) {
    std::vector<int> clocks;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        const std::string_view item = std::string_view(text).substr(from, comma - from);
        double mhz = 0;
        if (!parse_whole(item, mhz) || !(mhz >= 1) || mhz > 100000)
            throw UserError(fmt::format("--clock: {} is not a clock in MHz from 1 to 100000, in {}", shown(item), shown(text)));
        clocks.push_back(int(std::lround(mhz * 1000)));
        from = comma + 1;
    }
    if (clocks.size() > 64) throw UserError(fmt::format("--clock: {} clocks are more than 64", clocks.size()));
    return clocks;
}

std::vector<int> parse_values(const std::string& option, const std::string& text) {
    constexpr int most = 10000;
    std::vector<int> parts;
    const char separator = text.find(':') != std::string::npos ? ':' : ',';
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(separator, from), text.size());
        const std::string_view part = std::string_view(text).substr(from, end - from);
        parts.emplace_back();
        if (!parse_whole(part, parts.back())) throw UserError(fmt::format("{}: {} in {} is not a whole number", option, shown(part), shown(text)));
        from = end + 1;
    }
    if (separator == ',') return parts;
    const int step = parts.size() > 2 ? parts[2] : 1;
    if (parts.size() > 3 || step < 1 || parts[1] < parts[0]) throw UserError(fmt::format("{}: {} is not from:to:step with a step above 0", option, shown(text)));
    std::vector<int> values;
    for (std::int64_t value = parts[0]; value <= parts[1]; value += step) {
        if (values.size() == most) throw UserError(fmt::format("{}: {} are more than {} values", option, shown(text), most));
        values.push_back(int(value));
    }
    return values;
}

std::uint64_t parse_rays(const std::string& text) {
    try {
        std::size_t used = 0;
        const double rays = std::stod(text, &used);
        if (used == text.size() && rays >= 1 && rays <= 1e12) return std::uint64_t(rays);
    } catch (const std::exception&) {
    }
    throw UserError("--rays: " + shown(text) + " is not a number of rays from 1 to 1e12, for example 1000000 or 1e9");
}

std::vector<Camera> camera_path(const Options& options, const Camera& camera) {
    if (options.frames < 1 || options.frames > 1000) throw UserError(fmt::format("--frames must lie in 1..1000, not {}", options.frames));
    if (!(std::abs(options.pan) <= 360)) throw UserError(fmt::format("--pan must lie in -360..360 degrees, not {}", options.pan));
    std::vector<Camera> path;
    for (int i = 0; i < options.frames; ++i) {
        // Rodrigues' rotation of the view direction about the up axis.
        const double angle = options.pan * i * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
        const glm::dvec3 axis = glm::normalize(camera.up), view = camera.at - camera.eye;
        Camera turned = camera;
        if (i > 0) turned.at = camera.eye + view * c + glm::cross(axis, view) * s + axis * glm::dot(axis, view) * (1 - c);
        path.push_back(turned);
    }
    return path;
}

Traffic traffic_of(const Options& options) {
    if (options.jitter < 0 || options.jitter > 100000) throw UserError(fmt::format("--jitter must lie in 0..100000, not {}", options.jitter));
    if (options.stall < 0 || options.stall > 99) throw UserError(fmt::format("--stall must lie in 0..99 percent, not {}", options.stall));
    return {options.jitter, options.stall, options.seed};
}

Scene told_scene(const std::string& spec, const Progress& progress, Primitives primitives) {
    constexpr std::size_t most = 20;
    std::vector<std::string> notes;
    Scene scene = load_scene(spec, progress, primitives, &notes);
    for (std::size_t i = 0; i < std::min(notes.size(), most); ++i) std::fprintf(stderr, "rayclock: warning: %s\n", notes[i].c_str());
    if (notes.size() > most) std::fprintf(stderr, "rayclock: warning: %zu more warnings\n", notes.size() - most);
    return scene;
}

Scene ready_scene(const Options& options, FrameSize size, const Progress& progress) {
    Scene scene = told_scene(options.scene, progress);
    if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
    return scene;
}

void check_outputs(const Options& options) {
    if (!options.json.empty() && options.json != "-") check_writable(options.json);
}

double parse_percent(const std::string& option, const std::string& typed, bool zero) {
    std::string number = typed;
    if (!number.empty() && number.back() == '%') number.pop_back();
    else number.clear();
    if (!number.empty() && number.back() == ' ') number.pop_back();
    double value = 0;
    std::size_t used = 0;
    try {
        value = std::stod(number, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    const bool is_number = used > 0 && used == number.size() && number.find_first_not_of("0123456789.e-") == std::string::npos;
    if (!is_number) throw UserError(fmt::format("{}: '{}' is not a percentage, for example 0.1%", option, typed));
    if (!(value > 0 || (zero && value == 0)) || !(value < 100))
        throw UserError(fmt::format("{}: '{}' must lie {} 100 %", option, typed, zero ? "from 0 to below" : "above 0 and below"));
    return value;
}

void check_psnr(const Options& o) {
    if (o.min_psnr && !(*o.min_psnr > 0 && *o.min_psnr <= 200))
        throw UserError(fmt::format("--min-psnr must lie above 0 and not above 200 dB, not {}", *o.min_psnr));
}

} // namespace rayclock
