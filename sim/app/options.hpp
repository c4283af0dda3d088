#pragma once
// Options that several commands have: the same name means the same in each. And what typed values mean.
#include <nlohmann/json.hpp>

#include "model/mem/memport.hpp"
#include "sim/app/parser.hpp"
#include "sim/run/film/film.hpp"
#include "sim/view/report/limits.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

constexpr const char* default_size = "512x384";
constexpr const char* default_clocks = "66,90,200";
constexpr std::uint64_t default_seed = 1;

Declared scene_option(Parser& parser, std::string& scene);
void size_option(Parser& parser, std::string& size);
void clock_option(Parser& parser, std::string& clocks);
void threads_option(Parser& parser, int& threads);
void config_options(Parser& parser, ConfigChoice& config);
void finished_options(Parser& parser, Finish& finish);
void view_options(Parser& parser, ViewChoice& view);
void judge_option(Parser& parser, bool& no_judge);

/// How far the picture may be from the reference's, as typed.
struct LimitsChoice {
    std::optional<std::string> max_other, max_depth_error;
    std::optional<double> min_psnr;
};
void limits_options(Parser& parser, LimitsChoice& limits);
/// Throws UserError.
Limits limits_of(const LimitsChoice& limits);
/// As they were typed, for pages that tell their command: " --min-psnr 60".
std::string typed_limits(const LimitsChoice& limits);

void fresh_option(Parser& parser, bool& fresh);
void netlist_option(Parser& parser, bool& no_netlist);

/// "512x384". Throws UserError.
FrameSize parse_size(const std::string& text);
/// "255,190": column and row of a pixel; its number, row by row from the top. Throws UserError.
std::size_t parse_pixel(const std::string& text, FrameSize size);
/// "66,90,200": MHz, each from 1 to 100,000 with at most three decimals, as kHz. Throws UserError.
std::vector<int> parse_clocks(const std::string& text);
/// "1,2,4" or "12:20:2" (from, to, step): whole numbers. `option` begins the sentence. Throws UserError.
std::vector<int> parse_values(const std::string& option, const std::string& text);
/// "1e6": a number of rays from 1 to 1e12. Throws UserError.
std::uint64_t parse_rays(const std::string& text);
/// "0.1%" or "0.1 %". Throws UserError unless it is a percentage below 100 and above 0, or 0 itself if
/// `zero`.
double parse_percent(const std::string& option, const std::string& typed, bool zero);
/// "320%". Throws UserError unless it is a percentage that is not negative.
double parse_any_percent(const std::string& option, const std::string& typed);
/// Throws UserError unless --min-psnr lies above 0 and not above 200.
void check_psnr(const std::optional<double>& psnr);

/// A frame after the other, while things move or the camera turns.
void frames_options(Parser& parser, FramesOptions& options);

struct TrafficOptions {
    std::uint64_t seed = default_seed;
    int jitter = 0, stall = 0;
};
void traffic_options(Parser& parser, TrafficOptions& options);
/// Memory and sink disturbed as asked. Throws UserError.
Traffic traffic_of(const TrafficOptions& options);

/// Where the report goes as JSON: to a file, to standard output, where it is alone, or nowhere.
struct JsonOutput {
    std::string path;

    bool wanted() const { return !path.empty(); }
    bool is_alone() const { return path == "-"; }   ///< no text beside it
    void check() const;   ///< Fails early (UserError) if the file could not be written later.
    void write(const nlohmann::ordered_json& json) const;
};
void json_option(Parser& parser, JsonOutput& json);

}   // namespace rayclock
