// Divides the time of one pixel into stays, and each stay into work and waits with their causes.
#include "sim/view/observe/story.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rayclock {

namespace {

std::size_t cache_index(Link request) {
    return request == Link::node_req ? 0 : request == Link::prim_req ? 1 : request == Link::texel_req ? 3 : 2;
}

/// The events of one stay: begin, optional look-up of a cache, end.
struct Part {
    std::size_t begin = 0, lookup = 0, end = 0;   ///< indices of events
    bool has_lookup = false;
};
std::vector<Part> parts_of(const std::vector<RayEvent>& events) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (events[i].type == RayEvent::Type::lookup) {
            parts.back().lookup = i;
            parts.back().has_lookup = true;
            continue;
        }
        if (!parts.empty()) parts.back().end = i;
        if (events[i].link != Link::hit) parts.push_back({i, i, i, false});
    }
    return parts;
}

/// The cycles that a cache needs without interference: up to the look-up, and from a hit to the answer.
struct CacheTimes {
    std::uint64_t before = ~0ull, after = ~0ull;
};
using AllCacheTimes = std::array<CacheTimes, ray_caches>;
void shorten(AllCacheTimes& times, const std::vector<RayEvent>& events, const std::vector<Part>& parts) {
    for (const Part& part : parts) {
        if (!part.has_lookup) continue;
        CacheTimes& t = times[cache_index(events[part.begin].link)];
        const std::uint64_t begin = events[part.begin].cycle, lookup_cycle = events[part.lookup].cycle,
                            end = events[part.end].cycle;
        t.before = std::min(t.before, lookup_cycle - begin);
        if (events[part.lookup].outcome == CacheOutcome::hit) t.after = std::min(t.after, end - lookup_cycle);
    }
}

class StoryBuilder {
public:
    StoryBuilder(const PixelEvents& mine, const PixelEvents& alone, bool streams)
        : mine_(mine),
          alone_(alone),
          streams_(streams),
          parts_(parts_of(mine.events)),
          alone_parts_(parts_of(alone.events)) {
        if (parts_.size() != alone_parts_.size())
            throw std::logic_error("a pixel does not do the same when it is alone on the chip");
        shorten(times_, mine.events, parts_);
        shorten(times_, alone.events, alone_parts_);
    }

    std::vector<std::pair<std::uint32_t, Stay>> stays() const {
        std::vector<std::pair<std::uint32_t, Stay>> all;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const RayEvent &begin = mine_.events[parts_[i].begin], &end = mine_.events[parts_[i].end];
            Stay stay;
            stay.first = begin.cycle;
            stay.cycles = end.cycle - begin.cycle;
            stay.place = place_after(begin.link, streams_);
            stay.by = begin.link;
            stay.addr = begin.addr;
            parts_[i].has_lookup ? in_cache(stay, parts_[i]) : in_unit(stay, parts_[i], alone_parts_[i]);
            all.emplace_back(begin.ray, std::move(stay));
        }
        return all;
    }

private:
    static void wait(Stay& stay, std::uint64_t& left, std::uint64_t cycles, std::string cause) {
        cycles = std::min(cycles, left);
        if (cycles == 0) return;
        left -= cycles;
        stay.waits.push_back({std::move(cause), cycles});
    }
    /// Returns the refused cycles of the link that ends a stay.
    std::uint64_t refused(std::size_t from, std::size_t to, Link link) const {
        return mine_.waits[to].refused[index(link)] - mine_.waits[from].refused[index(link)];
    }

    void in_unit(Stay& stay, const Part& part, const Part& alone) const {
        const std::uint64_t least = alone_.events[alone.end].cycle - alone_.events[alone.begin].cycle;
        stay.work = std::min(least, stay.cycles);
        std::uint64_t left = stay.cycles - stay.work;
        const Link out = mine_.events[part.end].link;
        if (!is_node_unit(Unit(stay.place)) && stay.place != index(Unit::tri))
            wait(stay, left, refused(part.begin, part.end, out),
                 fmt::format("{} accepts nothing", link_infos[index(out)].to));
        wait(stay, left, left, fmt::format("{}: other rays go first", place_name(stay.place)));
    }

    void in_cache(Stay& stay, const Part& part) const {
        const std::size_t cache = cache_index(stay.by);
        const std::string name = place_name(stay.place);
        const CacheTimes& times = times_[cache];
        const std::uint64_t begin = mine_.events[part.begin].cycle,
                            lookup_cycle = mine_.events[part.lookup].cycle,
                            end = mine_.events[part.end].cycle;
        stay.is_lookup = true;
        stay.lookup = mine_.events[part.lookup].outcome;
        const auto outcome = [&](CacheOutcome d) {
            const auto& before = mine_.waits[part.begin].outcomes[cache];
            const auto& after = mine_.waits[part.lookup].outcomes[cache];
            return after[std::size_t(d)] - before[std::size_t(d)];
        };
        std::uint64_t left = lookup_cycle - begin - times.before;
        stay.work = times.before;
        wait(stay, left, outcome(CacheOutcome::mshrs), name + ": too many lines are on their way");
        wait(stay, left, outcome(CacheOutcome::conflict), name + ": all ways of a set wait for lines");
        wait(stay, left, outcome(CacheOutcome::drain), name + ": rays that waited for a line are answered");
        wait(stay, left, outcome(CacheOutcome::answers), name + ": answers are not taken");
        wait(stay, left, left, name + ": other rays are looked up first");
        const std::uint64_t least = times.after == ~0ull ? 0 : times.after;
        const std::uint64_t rest = end - lookup_cycle;
        stay.work += std::min(least, rest);
        left = rest - std::min(least, rest);
        if (stay.lookup == CacheOutcome::hit)
            wait(stay, left, left, name + ": its answer waits behind others");
        else
            wait(stay, left, left, "the memory");
    }

    const PixelEvents &mine_, &alone_;
    bool streams_;
    std::vector<Part> parts_, alone_parts_;
    AllCacheTimes times_;
};

std::vector<Stay::Wait> sorted(std::vector<Stay::Wait> sums) {
    std::stable_sort(sums.begin(), sums.end(),
                     [](const Stay::Wait& a, const Stay::Wait& b) { return a.cycles > b.cycles; });
    return sums;
}
void add(std::vector<Stay::Wait>& sums, const std::string& cause, std::uint64_t cycles) {
    if (cycles == 0) return;
    for (Stay::Wait& sum : sums)
        if (sum.cause == cause) {
            sum.cycles += cycles;
            return;
        }
    sums.push_back({cause, cycles});
}

}   // namespace

std::vector<Stay::Wait> PixelStory::places() const {
    std::vector<Stay::Wait> sums;
    for (const RayStory& ray : rays)
        for (const Stay& stay : ray.stays) add(sums, place_name(stay.place), stay.cycles);
    return sorted(std::move(sums));
}

std::vector<Stay::Wait> PixelStory::causes() const {
    std::vector<Stay::Wait> sums;
    for (const RayStory& ray : rays)
        for (const Stay& stay : ray.stays) {
            add(sums, "work", stay.work);
            for (const Stay::Wait& wait : stay.waits) add(sums, wait.cause, wait.cycles);
        }
    return sorted(std::move(sums));
}

PixelStory make_story(const Job& job, const RecordedFrame& frame, const FrameCosts& costs,
                      const PixelEvents& in_frame, const PixelEvents& alone) {
    PixelStory story;
    const RayEvent &begin = in_frame.events.front(), &end = in_frame.events.back();
    story.x = begin.pixel % costs.width;
    story.y = begin.pixel / costs.width;
    story.pipeline = begin.pipeline;
    story.context = begin.context;
    story.cost = costs.pixels[begin.pixel];
    story.alone = alone.events.back().cycle - alone.events.front().cycle;
    for (RayValues& values : rays_of_pixel(job.image, frame.frame, job.config, story.x, story.y))
        story.rays.push_back({std::move(values), 0, 0, {}, 0, 0});
    for (auto& [ray, stay] : StoryBuilder(in_frame, alone, job.config.is_stream()).stays()) {
        RayStory& told = story.rays.at(ray);
        if (told.stays.empty()) told.first = stay.first;
        told.cycles = stay.first + stay.cycles - told.first;
        told.misses += stay.is_lookup && stay.lookup == CacheOutcome::miss;
        told.merges += stay.is_lookup && stay.lookup == CacheOutcome::merge;
        told.stays.push_back(std::move(stay));
    }
    if (end.cycle - begin.cycle != story.cost.cycles)
        throw std::logic_error("a pixel's steps do not sum to its cycles");
    return story;
}

}   // namespace rayclock
