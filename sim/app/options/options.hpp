#pragma once
// Options that several commands share, with the same meaning in each. sim/app/run/typed_values.hpp parses
// what was typed.
#include <nlohmann/json.hpp>

#include "model/mem/ideal_memory.hpp"
#include "sim/app/options/parser.hpp"
#include "sim/app/run/typed_values.hpp"
#include "sim/run/film/film.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/request/request.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock {

constexpr const char* default_size = "512x384";
constexpr const char* default_clocks = "66,90,200";
constexpr std::uint64_t default_seed = 1;
/// The three forms of --pixels, for the help.
constexpr const char* pixels_forms = "X,Y,WIDTHxHEIGHT, X,Y..X,Y (both corners included), or X,Y";

DeclaredOption scene_option(Parser& parser, std::string& scene);
void size_option(Parser& parser, std::string& size);
void pixels_option(Parser& parser, std::optional<std::string>& pixels);
void clock_option(Parser& parser, std::string& clocks);
void one_clock_option(Parser& parser, std::string& clock);   ///< for a command that takes one clock
void threads_option(Parser& parser, int& threads);
void config_options(Parser& parser, ConfigChoice& config);
void finished_options(Parser& parser, Finish& finish);
DeclaredOption textures_option(Parser& parser, bool& no_textures);   ///< part of view_options()
void view_options(Parser& parser, ViewChoice& view);
void judge_option(Parser& parser, bool& no_judge);

/// The limits of errors against the reference, as typed.
struct LimitsChoice {
    std::optional<std::string> max_other, max_depth_error;
    std::optional<double> min_psnr;
};
void limits_options(Parser& parser, LimitsChoice& limits);
/// Returns the limits. Throws UserError.
Limits limits_of(const LimitsChoice& limits);
/// Returns the limits as typed, for the command in a page: " --min-psnr 60".
std::string typed_limits(const LimitsChoice& limits);

void fresh_option(Parser& parser, bool& fresh);
void netlist_option(Parser& parser, bool& no_netlist);

/// Declares options for several frames of a moving scene or a turning camera.
void frames_options(Parser& parser, FramesOptions& options);

/// Random disturbances of memory and sink.
struct DisturbanceOptions {
    std::uint64_t seed = default_seed;
    int jitter = 0, stall = 0;
};
void disturbance_options(Parser& parser, DisturbanceOptions& options);
/// Returns the requested disturbances. Throws UserError.
Disturbance disturbance_of(const DisturbanceOptions& options);

/// The destination of the JSON report: a file, standard output without other text, or none.
struct JsonOutput {
    std::string path;

    bool wanted() const { return !path.empty(); }
    bool is_alone() const { return path == "-"; }   ///< writes no text to standard output
    /// Throws UserError if the file could not be written later, so that a command can fail early.
    void check() const;
    void write(const nlohmann::ordered_json& json) const;
};
void json_option(Parser& parser, JsonOutput& json);

}   // namespace rayclock
