#pragma once
// Options that several commands share, with the same meaning in each, and parsers for typed values.
#include <nlohmann/json.hpp>

#include "model/mem/memport.hpp"
#include "sim/app/options/parser.hpp"
#include "sim/run/film/film.hpp"
#include "sim/view/report/limits.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

constexpr const char* default_size = "512x384";
constexpr const char* default_clocks = "66,90,200";
constexpr std::uint64_t default_seed = 1;

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

/// Parses "512x384". Throws UserError.
FrameSize parse_size(const std::string& text);
/// Parses "255,190", column and row of a pixel, to its index, row by row from the top. Throws UserError.
std::size_t parse_pixel(const std::string& text, FrameSize size);
/// Parses --pixels of a picture: COLUMN,ROW,WIDTHxHEIGHT, or COLUMN,ROW..COLUMN,ROW (both corners inside), or
/// COLUMN,ROW. Throws UserError.
PixelRect parse_pixels(const std::string& text, FrameSize whole);
/// Parses --size, and --pixels, which chooses a part of that picture. Returns the size of the picture to
/// draw, and sets the view's window if it is a part.
FrameSize parse_part(const std::string& size, const std::optional<std::string>& pixels, ViewChoice& view);
/// Cycles of a frame, without `last`.
struct CycleRange {
    std::uint64_t first = 0, last = 0;
};
/// Parses --cycles, FIRST:LAST. Throws UserError unless it holds a cycle.
CycleRange parse_cycles(const std::string& text);
/// Parses "66,90,200" MHz to kHz. Each value is from 1 to 100,000 with at most three decimals. Throws
/// UserError.
std::vector<int> parse_clocks(const std::string& text);
/// Parses whole numbers: "1,2,4" or "12:20:2" (from, to, step). Throws UserError whose sentence begins with
/// `option`.
std::vector<int> parse_values(const std::string& option, const std::string& text);
/// Parses a number of rays such as "1e6", from 1 to 1e12. Throws UserError.
std::uint64_t parse_rays(const std::string& text);
/// Parses "0.1%" or "0.1 %". Throws UserError unless the percentage is above 0 and below 100; `zero` also
/// allows 0.
double parse_percent(const std::string& option, const std::string& typed, bool zero);
/// Parses "320%". Throws UserError unless it is a percentage of at least 0.
double parse_any_percent(const std::string& option, const std::string& typed);
/// Parses "0:16", the number of the first line of memory and the number of lines, for --lines. Throws
/// UserError unless there is at least one.
std::pair<std::uint64_t, std::uint64_t> parse_lines(const std::string& text);
/// Throws UserError unless --min-psnr is above 0 and at most 200.
void check_psnr(const std::optional<double>& psnr);

/// Declares options for several frames of a moving scene or a turning camera.
void frames_options(Parser& parser, FramesOptions& options);

/// Random disturbances of memory and sink.
struct TrafficOptions {
    std::uint64_t seed = default_seed;
    int jitter = 0, stall = 0;
};
void traffic_options(Parser& parser, TrafficOptions& options);
/// Returns the requested disturbances. Throws UserError.
Traffic traffic_of(const TrafficOptions& options);

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
