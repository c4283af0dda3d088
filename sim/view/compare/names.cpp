// Names of figures in pages, and the figures that are listed first.
#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/split.hpp"
#include "sim/view/compare/compare.hpp"

namespace rayclock {

namespace {

/// Parts of a name that need other words. All other parts only replace dashes with blanks.
const std::map<std::string, std::string>& words() {
    static const std::map<std::string, std::string> all{
        {"fps", "frames a second"},
        {"mrays_per_s", "million rays a second"},
        {"dram_bytes", "bytes from memory"},
        {"dram_gb_per_s", "GB/s from memory"},
        {"dram_share_of_peak", "share of the memory's peak"},
        {"bytes_per_ray", "bytes per ray"},
        {"bound_reached", "share of the roofline reached"},
        {"node_hit_rate", "hit rate of the node cache"},
        {"prim_hit_rate", "hit rate of the primitive cache"},
        {"node_steps", "node visits"},
        {"psnr_db", "PSNR, dB"},
        {"pixels_other_primitive", "pixels with another primitive"},
        {"max_abs_depth", "largest difference of depth"},
        {"primary", "camera rays"},
        {"shadow", "shadow rays"},
        {"reflection", "reflected rays"},
        {"refraction", "refracted rays"},
        {"camera", "camera rays"},
        {"count", "pieces of work"},
        {"busy", "busy cycles"},
        {"starved", "starved cycles"},
        {"busy_with", "cycles busy with"},
        {"starved_by", "cycles starved by"},
        {"stalled", "cycles stalled by"},
        {"bounds", "least cycles for"}};
    return all;
}

std::string spoken(const std::string& part) {
    if (const auto at = words().find(part); at != words().end()) return at->second;
    std::string text = part;
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

/// Returns true for a part that is followed by a unit or a resource.
bool names_what_follows(const std::string& part) {
    constexpr std::array ones{"busy_with", "starved_by", "stalled", "bounds"};
    return std::find(ones.begin(), ones.end(), part) != ones.end();
}

}   // namespace

std::string figure_name(const std::string& figure) {
    std::vector<std::string> parts = split(figure, '.');
    std::string clock;
    if (parts.size() > 2 && parts[0] == "clocks") {
        // A clock with a fraction has a point of its own in the path.
        std::size_t used = 2;
        std::string mhz = parts[1];
        if (parts.size() > 3 && parts[2].find_first_not_of("0123456789") == std::string::npos)
            mhz += "." + parts[used++];
        clock = fmt::format(" at {} MHz", mhz);
        parts.erase(parts.begin(), parts.begin() + std::ptrdiff_t(used));
    }
    std::vector<std::string> said;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool is_last = i + 1 == parts.size();
        if (!is_last && (parts[i] == "units" || parts[i] == "work" || parts[i] == "memory" ||
                         parts[i] == "work_by_kind" || parts[i] == "rays"))
            continue;
        if (!is_last && parts[i] == "frames") {
            said.push_back("frame [" + parts[i + 1] + "]");
            ++i;
        } else if (i > 0 && parts[i - 1] == "units") {
            said.push_back(parts[i]);
        } else if (!is_last && names_what_follows(parts[i])) {
            said.push_back(spoken(parts[i]) + " " + parts[i + 1]);
            ++i;
        } else {
            said.push_back(spoken(parts[i]));
        }
    }
    return fmt::format("{}{}", fmt::join(said, ": "), clock);
}

bool is_key_figure(const std::string& figure) {
    const bool of_clock = figure.starts_with("clocks.") && std::count(figure.begin(), figure.end(), '.') == 2;
    return (of_clock &&
            (figure.ends_with(".cycles") || figure.ends_with(".fps") || figure.ends_with(".dram_bytes"))) ||
           figure == "error.pixels_other_primitive" || figure == "error.psnr_db" || figure == "judge.wrong";
}

}   // namespace rayclock
