// Writes a timeline in the format Kanata 0004.
#include <map>

#include <fmt/format.h>

#include "sim/view/timeline/timeline.hpp"

namespace rayclock {

namespace {

/// The commands of each cycle, because the format requires them in order of time.
using Commands = std::map<std::uint64_t, std::string>;

void add_ray(Commands& at, const Timeline& timeline, std::size_t id, const TimelineRay& ray) {
    const auto width = std::uint32_t(timeline.width());
    const std::uint64_t first = ray.stays.front().first, last = ray.stays.back().last;
    at[first] += fmt::format(
        "I\t{0}\t{1}\t{2}\nL\t{0}\t0\tpixel {3},{4} ray {5} {6}\nL\t{0}\t1\tpipeline {7}, "
        "context {8}\n",
        id, ray.pixel, ray.pipeline * timeline.config().contexts + int(ray.context), ray.pixel % width,
        ray.pixel / width, ray.ray, purpose_names[std::size_t(ray.purpose)], ray.pipeline, ray.context);
    if (ray.sender >= 0) at[first] += fmt::format("W\t{}\t{}\t0\n", id, ray.sender);
    for (const TimelineStay& stay : ray.stays) {
        const char* name = place_name(stay.place);
        at[stay.first] += fmt::format("S\t{}\t0\t{}\n", id, name);
        if (stay.lookup) {
            constexpr const char* outcomes[] = {"hit", "miss", "merge"};
            at[stay.first] += fmt::format("L\t{}\t1\t; {} {}: {}\n", id, name, stay.addr,
                                          outcomes[std::size_t(*stay.lookup)]);
        }
        if (stay.wait_first < stay.last) {
            at[stay.wait_first] += fmt::format("S\t{}\t1\tfor_{}\n", id, stay.waits_for);
            at[stay.last] += fmt::format("E\t{}\t1\tfor_{}\n", id, stay.waits_for);
        }
        at[stay.last] += fmt::format("E\t{}\t0\t{}\n", id, name);
    }
    at[last] += fmt::format("R\t{0}\t{0}\t0\n", id);
}

}   // namespace

std::string kanata(const Timeline& timeline) {
    Commands at;
    for (std::size_t id = 0; id < timeline.rays.size(); ++id) add_ray(at, timeline, id, timeline.rays[id]);
    std::uint64_t now = at.empty() ? 0 : at.begin()->first;
    std::string text = fmt::format("Kanata\t0004\nC=\t{}\n", now);
    for (const auto& [cycle, commands] : at) {
        if (cycle > now) text += fmt::format("C\t{}\n", cycle - now);
        now = cycle;
        text += commands;
    }
    return text;
}

}   // namespace rayclock
