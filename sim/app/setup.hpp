#pragma once
// What the subcommands share: options, and a scene made ready for the engines.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/core/config.hpp"
#include "model/core/progress.hpp"
#include "model/mem/memport.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"
#include "model/shade/shade.hpp"

namespace rayclock {

/// Options of the command line as typed; the same name means the same in every subcommand.
struct Options {
    std::string scene;
    std::string size = "512x384";
    std::string config = "default";
    std::vector<std::string> set;
    std::string clock = "66,90,200";
    std::string engine = "model";
    std::string output;
    std::string json;
    bool no_reference = false;
    bool torture = false;
    bool no_judge = false;
    int threads = 0;
    std::uint64_t seed = 1;
    int jitter = 0;
    int stall = 0;
    int frames = 1;
    double pan = 0;
    std::vector<std::string> axes;
    std::string bits = "12:20:2";
    std::string rays = "1e6";
    std::vector<std::string> tests, families;
    std::string state;
    std::string max_error = "0.1%";
    std::string max_work = "2%";
    std::optional<double> min_psnr;   // of `fit` and `verify`
    std::optional<std::string> max_other;
    std::string plot;
    bool fresh = false;
    bool no_netlist = false;
    std::vector<std::string> scenes;
    std::optional<int> depth, aa;
    std::optional<double> threshold, contrast;
    bool jittered = false, fresnel = false;
    std::string figure_size = "256x192", engines = "reference,model,rtl";   // of `figures`
    std::string count_size = "513x513";                                     // of `counts`
    std::vector<std::string> count_scenes;
    std::vector<std::string> units;   // of `area`
};

/// "512x384". Throws UserError.
FrameSize parse_size(const std::string& text);

/// "0.1%" or "0.1 %". Throws UserError unless it is a percentage below 100 and above 0, or 0 itself if `zero`.
double parse_percent(const std::string& option, const std::string& typed, bool zero);
/// Throws UserError unless --min-psnr lies above 0 and not above 200.
void check_psnr(const Options& options);

/// "1,2,4" or "12:20:2" (from, to, step): whole numbers. `option` begins the sentence. Throws UserError.
std::vector<int> parse_values(const std::string& option, const std::string& text);

/// "66,90,200": MHz, each from 1 to 100,000 with at most three decimals, as kHz. Throws UserError.
std::vector<int> parse_clocks(const std::string& text);

/// "1e6": a number of rays from 1 to 1e12. Throws UserError.
std::uint64_t parse_rays(const std::string& text);

/// The camera of each frame: the first is the scene's, each next one is turned by `pan` degrees about its up axis. The eye
/// stays, so that all see the same lattice. Throws UserError.
std::vector<Camera> camera_path(const Options& options, const Camera& camera);

/// Memory and sink disturbed as asked. Throws UserError.
Traffic traffic_of(const Options& options);

/// load_scene(), with a warning on standard error for whatever a file holds and is not drawn as it stands there.
Scene told_scene(const std::string& spec, const Progress& progress, Primitives primitives = Primitives::triangles);

/// A scene with a camera, for a picture of this size.
Scene ready_scene(const Options& options, FrameSize size, const Progress& progress);

/// Kind of file a configuration is kept in: JSON with every parameter, or "like": NAME and some of them.
Config load_config(const std::string& name_or_file, const std::vector<std::string>& set);
/// What the text of such a file says, whether it is legal or not; `path` only names it.
Config parse_config(const std::string& path, std::string_view text);
/// The configuration with every key=value of --set; `where` begins the sentence if it is not legal then. Throws UserError.
Config with_settings(Config config, const std::vector<std::string>& set, const std::string& where);

/// Fails early if an output could not be written later.
void check_outputs(const Options& options);

} // namespace rayclock
