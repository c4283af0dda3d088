#pragma once
// Judges the RTL's requests for memory lines and their answers, by id.
#include <array>
#include <optional>
#include <set>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "sim/run/elastic/findings.hpp"

namespace rayclock {

/// Checks every request for a line on its way from a cache to memory, and every answer. An id has one request
/// in flight. Each answer belongs to a request and carries the line at the requested address. A cache may
/// request any lines of the image, in any order and any number of times. The arbiter passes each request on
/// once, and makes none of its own.
class LineJudge {
public:
    LineJudge(const Config& config, const RtlMachine& rtl, Findings& findings);

    /// Begins a frame. `image` must outlive it. `forget`: the chip was reset, so nothing is in flight.
    void start(const MemoryImage& image, bool forget);
    /// Judges the transfers of a cycle, after RtlMachine::settle().
    void cycle(std::uint64_t now);
    /// Describes a missing answer, if a request waits for one. Chooses the links nearest to memory, and there
    /// the oldest request. Does not count requests that wait for memory itself.
    std::optional<Divergence> missing(std::uint64_t now) const;

private:
    struct Request {
        std::uint32_t addr = 0;
        std::uint64_t since = 0;
    };
    /// Links of a request and its answer, and the requests in flight by pipeline and id.
    struct Pair {
        Link req, rsp;
        std::vector<std::vector<std::optional<Request>>> waits;
    };
    bool answer(std::uint64_t now, Pair& pair, int pipeline, bool is_last);
    void ask(std::uint64_t now, Pair& pair, int pipeline);
    Divergence at(std::uint64_t now, int pipeline, Link c, std::uint32_t id) const;

    const Config& config_;
    const RtlMachine& rtl_;
    Findings& findings_;
    const MemoryImage* image_ = nullptr;
    Link passed_on_;            // the arbiter's output
    std::vector<Pair> pairs_;   // from memory outwards to the caches
    // Lines that caches of pipelines requested, and that no arbiter has passed on.
    std::multiset<std::uint32_t> asked_;
};

}   // namespace rayclock
