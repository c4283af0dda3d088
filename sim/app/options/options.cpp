// Declares the options that several commands share.
#include "sim/app/options/options.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/image/image.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

DeclaredOption scene_option(Parser& parser, std::string& scene) {
    return parser.option("SCENE", scene,
                         "a built-in name with an optional size (gears:8), or a file (.obj .ply .stl .off "
                         ".3ds .dae .glb .gltf, "
                         "these also .gz, .json)");
}

void size_option(Parser& parser, std::string& size) {
    parser.option("--size", size, "size of the picture, WIDTHxHEIGHT").with_default();
}

void pixels_option(Parser& parser, std::optional<std::string>& pixels) {
    parser.option("--pixels", pixels,
                  (std::string("draw only this part of the picture, ") + pixels_forms +
                   "; the rays are those of the whole picture, the caches are cold")
                      .c_str());
}

void clock_option(Parser& parser, std::string& clocks) {
    parser
        .option("--clock", clocks,
                "clocks in MHz, separated by commas; fmax: the clock that rayclock chip routed")
        .with_default();
}

void one_clock_option(Parser& parser, std::string& clock) {
    parser.option("--clock", clock, "the clock in MHz; fmax: the clock that rayclock chip routed")
        .with_default();
}

void threads_option(Parser& parser, int& threads) {
    parser.option("--threads", threads, "number of threads; 0: one for each core").within(0, 1024);
}

void config_options(Parser& parser, ConfigChoice& config) {
    parser
        .option("--config", config.name,
                "hardware configuration: default, small, wide, saarcor, rpu, ulx3s, ulx3s-shaded, "
                "ulx3s-board, or a JSON file")
        .with_default();
    parser.option("--set", config.set,
                  "key=value: change one parameter of the configuration; may be repeated");
}

void finished_options(Parser& parser, Finish& o) {
    constexpr const char* group = "Finished picture (shadows, reflection, refraction, made by the chip)";
    parser
        .option("--depth", o.depth,
                "most bounces of a camera ray, 0..15; 5 if only other options of this group are given")
        .under(group);
    parser
        .option("--threshold", o.threshold,
                "smallest weight of a reflected or refracted ray that is traced, 0..1; 0: all are traced")
        .under(group);
    parser.option("--aa", o.aa, "N x N samples in a pixel, 1..8").under(group);
    parser
        .flag("--jittered", o.jittered,
              "move each sample at random within its cell; the seed selects the pattern")
        .under(group);
    parser
        .option(
            "--contrast", o.contrast,
            "after four samples of a pixel, take the others only if a colour differs by more than this, 0..1")
        .under(group);
    parser
        .flag("--fresnel", o.fresnel,
              "weigh reflection and refraction by Schlick's approximation of Fresnel's term")
        .under(group);
}

DeclaredOption textures_option(Parser& parser, bool& no_textures) {
    return parser.flag(
        "--no-textures", no_textures,
        "draw no pictures on surfaces but their average colours, or in OBJ files the material's");
}

void view_options(Parser& parser, ViewChoice& o) {
    constexpr const char* group = "View (without these: the scene's own camera, or one that shows all of it)";
    parser.option("--eye", o.eye, "position of the camera: x,y,z").under(group);
    parser.option("--at", o.at, "the point in the middle of the picture: x,y,z").under(group);
    parser.option("--fov", o.fov, "angle between the picture's upper and lower edge, degrees").under(group);
    parser.option("--orbit", o.orbit, "turn the camera about the point of --at, around the up axis, degrees")
        .under(group);
    parser
        .option("--material", o.material,
                "NAME|key=value,...: material of surfaces without one in their file: a material of the scene "
                "spheres (mirror, glass, gold, blue, chalk), or keys of a JSON material (mirror=0.5)")
        .under(group);
    parser.flag("--ground", o.ground, "lay a grey square under the scene, four times as wide as the scene")
        .under(group);
    textures_option(parser, o.no_textures).under(group);
}

void judge_option(Parser& parser, bool& no_judge) {
    parser.flag("--no-judge", no_judge,
                "leave out the exact judge of all rays and colours, and the causes of pixels that differ");
}

void limits_options(Parser& parser, LimitsChoice& o) {
    constexpr const char* group = "Limits (a picture beyond one of them is FAR FROM THE REFERENCE)";
    constexpr Limits usual;
    static const std::string other = fmt::format(
        "largest share of pixels that hold another primitive than the reference's; {:g}% if not given",
        usual.max_other);
    static const std::string psnr = fmt::format(
        "smallest PSNR of the picture against the reference's, in dB; {:g} if not given", usual.min_psnr);
    static const std::string depth = fmt::format(
        "largest depth error of a pixel with the right primitive, as a share of the reference's depth; "
        "{:g}% if not given",
        usual.max_depth_error);
    parser.option("--max-other", o.max_other, other.c_str()).under(group);
    parser.option("--min-psnr", o.min_psnr, psnr.c_str()).under(group);
    parser.option("--max-depth-error", o.max_depth_error, depth.c_str()).under(group);
}

Limits limits_of(const LimitsChoice& o) {
    check_psnr(o.min_psnr);
    Limits limits;
    if (o.max_other) limits.max_other = parse_percent("--max-other", *o.max_other, true);
    if (o.min_psnr) limits.min_psnr = *o.min_psnr;
    if (o.max_depth_error)
        limits.max_depth_error = parse_any_percent("--max-depth-error", *o.max_depth_error);
    return limits;
}

std::string typed_limits(const LimitsChoice& o) {
    std::string text;
    if (o.max_other) text += " --max-other " + *o.max_other;
    if (o.min_psnr) text += fmt::format(" --min-psnr {:g}", *o.min_psnr);
    if (o.max_depth_error) text += " --max-depth-error " + *o.max_depth_error;
    return text;
}

void fresh_option(Parser& parser, bool& fresh) {
    parser.flag("--fresh", fresh, "compute everything again, without cached results of earlier runs");
}

void netlist_option(Parser& parser, bool& no_netlist) {
    parser.flag(
        "--no-netlist", no_netlist,
        "do not count multipliers and flip-flops (Yosys needs about ten seconds for each configuration)");
}

void frames_options(Parser& parser, FramesOptions& o) {
    parser
        .option("--frames", o.frames,
                "frames drawn one after the other on one machine: the caches are warm from the second on")
        .with_default();
    parser.option("--pan", o.pan, "degrees that the camera turns from frame to frame");
    parser.option("--fps", o.fps,
                  "frames per second of the scene's time, for a scene that moves; 25 if not given");
    parser.option("--time", o.time,
                  "scene time of the first frame in seconds; or A:B, from A up to B (B excluded)");
    parser
        .option(
            "--uploads", o.uploads,
            "when the host writes the moved parts: between frames (between), or during the previous frame "
            "into a second buffer (double)")
        .with_default();
    parser
        .option("--rebuild", o.rebuild,
                "rebuild the tree of a deforming mesh when refitting raises its surface-area cost above this "
                "multiple of the cost when built; 0: rebuild in every frame")
        .with_default();
}

void disturbance_options(Parser& parser, DisturbanceOptions& o) {
    parser.option("--seed", o.seed, "seed of random delays and stalls, and of the RTL's registers at start")
        .within(1, 1 << 30);
    parser.option("--jitter", o.jitter, "random extra latency of the memory, up to this many cycles");
    parser.option("--stall", o.stall, "percentage of cycles in which memory and output do not accept");
}

Disturbance disturbance_of(const DisturbanceOptions& o) {
    if (o.jitter < 0 || o.jitter > 100000)
        throw UserError(fmt::format("--jitter must lie in 0..100000, not {}", o.jitter));
    if (o.stall < 0 || o.stall > 99)
        throw UserError(fmt::format("--stall must lie in 0..99 percent, not {}", o.stall));
    return {o.jitter, o.stall, o.seed};
}

void json_option(Parser& parser, JsonOutput& json) {
    parser.option("--json", json.path, "report as JSON to a file, - for standard output");
}

void JsonOutput::check() const {
    if (wanted() && !is_alone()) check_writable(path);
}

void JsonOutput::write(const nlohmann::ordered_json& json) const {
    if (wanted()) write_file(path, json.dump(2) + "\n");
}

}   // namespace rayclock
