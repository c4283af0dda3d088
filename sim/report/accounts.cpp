#include "sim/report/accounts.hpp"

#include <algorithm>

namespace rayclock {

std::vector<UnitAccount> unit_accounts(const ChannelCounts& counts, std::uint64_t cycles) {
    // Each unit is judged by the link through which its work comes in; sched, where rays begin, by the one it feeds.
    struct Row {
        const char* unit;
        Channel link;
        const char* cause;
    };
    constexpr Row rows[] = {
        {"sched", Channel::slot, "raygen"},          // its door is closed: trav takes no new rays
        {"raygen", Channel::ray, "trav"},            // nodes of older rays go first
        {"trav", Channel::step, "recirculation"},    // a culled group costs another turn
        {"node_port", Channel::node_req, "memory"},
        {"box", Channel::box_req, "list"},
        {"list", Channel::box_rsp, "none"},          // takes an answer in every cycle
        {"prim_port", Channel::prim_req, "memory"},
        {"tri", Channel::tri_req, "list"},
    };
    std::vector<UnitAccount> accounts;
    for (const Row& row : rows) {
        const ChannelCount& c = counts[index(row.link)];
        accounts.push_back({row.unit, c.moved, c.moved, cycles - c.moved - c.refused, c.refused, row.cause});
    }
    return accounts;
}

Bound bound_of(const FrameRun& run) {
    const std::uint64_t nodes = node_steps(run), tests = triangle_tests(run);
    const std::uint64_t least = std::max(nodes, tests);
    return {nodes >= tests ? "trav" : "tri", least, run.cycles ? double(least) / double(run.cycles) : 0};
}

} // namespace rayclock
