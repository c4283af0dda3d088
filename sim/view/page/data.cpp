// Builds the JSON behind the page's charts: pixel maps, windows of time, links, tiles and causes.
#include "sim/view/page/data.hpp"

#include <algorithm>

#include "sim/view/page/html.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock {

using nlohmann::ordered_json;

const std::vector<PixelMap>& pixel_maps() {
    static const std::vector<PixelMap> maps{
        {"cycles", "cycles", [](const PixelCost& p) { return p.cycles; }},
        {"visits", "node visits", [](const PixelCost& p) { return p.visits; }},
        {"tests", "primitive tests", [](const PixelCost& p) { return p.tests; }},
        {"rays", "rays", [](const PixelCost& p) { return p.rays; }},
        {"misses", "cache misses", [](const PixelCost& p) { return p.misses; }},
        {"bytes", "bytes of memory", [](const PixelCost& p) { return p.bytes; }},
        {"first", "first cycle", [](const PixelCost& p) { return p.first; }},
    };
    return maps;
}

namespace {

/// Packs a map's values in 1 to 4 bytes each, as the largest requires. All lowest bytes come first, which
/// compresses better.
ordered_json map_json(const PixelMap& map, const FrameCosts& costs) {
    std::uint32_t most = 0;
    std::uint64_t sum = 0;
    for (const PixelCost& p : costs.pixels) most = std::max(most, map.value(p)), sum += map.value(p);
    const int bytes = most < 1u << 8 ? 1 : most < 1u << 16 ? 2 : most < 1u << 24 ? 3 : 4;
    std::string planes;
    planes.reserve(costs.pixels.size() * std::size_t(bytes));
    for (int b = 0; b < bytes; ++b)
        for (const PixelCost& p : costs.pixels) planes += char(map.value(p) >> 8 * b & 255);
    return {{"key", map.key}, {"name", map.name}, {"bytes", bytes},
            {"max", most},    {"sum", sum},       {"data", html::base64(html::deflated(planes))}};
}

ordered_json causes_map(const Judgement& judgement) {
    std::string codes;
    for (std::size_t i = 0; i < judgement.pixels.size(); ++i)
        codes += char(int(judgement.pixels[i]) | (judgement.other[i] ? 16 : 0));
    ordered_json names = ordered_json::array();
    for (std::size_t c = 0; c <= pixel_causes; ++c) names.push_back(cause_info(PixelCause(c)).key);
    return {{"names", names}, {"data", html::base64(html::deflated(codes))}};
}

ordered_json kind_counts(const CauseCounts& counts, Unit unit) {
    std::array<std::uint64_t, 4> kinds{};
    for (std::size_t c = 0; c < cause_count; ++c)
        kinds[std::size_t(unit_infos[index(unit)].causes[c].kind)] += counts[c];
    return {kinds[1], kinds[2], kinds[3]};
}

ordered_json window_json(const Window& w, const Config& config, int khz) {
    ordered_json units = ordered_json::object();
    for (std::size_t u = 0; u < unit_count; ++u)
        if (is_there(Unit(u), config)) units[unit_infos[u].name] = kind_counts(w.accounts.units[u], Unit(u));
    ordered_json caches = ordered_json::object();
    for (const Unit cache : cache_units) {
        if (!is_there(cache, config)) continue;
        const CauseCounts& c = w.accounts.units[index(cache)];
        caches[unit_infos[index(cache)].name] = {c[0], c[0] + c[1] + c[2]};
    }
    const double seconds = double(w.cycles) / (khz * 1e3);
    return {{"first", w.first},
            {"cycles", w.cycles},
            {"rays_under_way", double(w.contexts) / double(w.cycles)},
            {"units", units},
            {"caches", caches},
            {"reads", w.memory.reads},
            {"row_hits", w.memory.row_hits},
            {"gb_per_s", double(w.memory.reads) * 64 / seconds / 1e9}};
}

ordered_json links_json(const FrameCosts& costs, const Config& config) {
    ordered_json links = ordered_json::array();
    for (std::size_t l = 0; l < link_count; ++l)
        if (is_there(Link(l), config))
            links.push_back({{"name", link_infos[l].name},
                             {"from", link_infos[l].from},
                             {"to", link_infos[l].to},
                             {"lanes", link_infos[l].of_pipeline() ? config.pipelines : 1},
                             {"moved", costs.moved[l]},
                             {"refused", costs.refused[l]}});
    return links;
}

}   // namespace

ordered_json work_by_kind_json(const FrameCosts& costs) {
    ordered_json kinds = ordered_json::object();
    for (std::size_t k = 0; k < costs.purposes.size(); ++k) {
        const PurposeCost& p = costs.purposes[k];
        ordered_json places = ordered_json::object(), caches = ordered_json::object();
        for (std::size_t i = 0; i < ray_places; ++i)
            if (p.places[i] > 0) places[place_name(i)] = p.places[i];
        for (std::size_t c = 0; c < ray_caches; ++c)
            caches[unit_infos[index(cache_units[c])].name] = {
                {"hits", p.hits[c]}, {"misses", p.misses[c]}, {"merged", p.merges[c]}};
        kinds[purpose_names[k]] = {{"rays", p.rays},
                                   {"node_steps", p.visits},
                                   {"primitive_tests", p.tests},
                                   {"cycles", p.cycles()},
                                   {"cache_misses", p.all_misses()},
                                   {"bytes", p.bytes},
                                   {"cycles_by_unit", places},
                                   {"caches", caches}};
    }
    return kinds;
}

std::vector<std::uint32_t> slowest_pixels(const FrameCosts& costs, std::size_t most) {
    std::vector<std::uint32_t> order(costs.pixels.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    most = std::min(most, order.size());
    std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(most), order.end(),
                      [&](std::uint32_t a, std::uint32_t b) {
                          const std::uint32_t x = costs.pixels[a].cycles, y = costs.pixels[b].cycles;
                          return x != y ? x > y : a < b;
                      });
    order.resize(most);
    return order;
}

std::string cause_of(const PageInput& input, std::size_t pixel) {
    if (!input.judgement || input.judgement->pixels[pixel] == PixelCause::none) return {};
    return std::string(cause_info(input.judgement->pixels[pixel]).key) +
           (input.judgement->other[pixel] ? ", another primitive" : "");
}

ordered_json page_data(const PageInput& input) {
    const FrameCosts& costs = input.costs;
    ordered_json maps = ordered_json::array(), windows = ordered_json::array(), tiles = ordered_json::array(),
                 slowest = ordered_json::array();
    for (const PixelMap& map : pixel_maps()) maps.push_back(map_json(map, costs));
    for (const Window& w : costs.windows) windows.push_back(window_json(w, input.config, input.khz));
    for (const TileSpan& t : costs.tiles) tiles.push_back({t.x, t.y, t.pipeline, t.first, t.last});
    for (const std::uint32_t pixel : slowest_pixels(costs, 100)) slowest.push_back(pixel);
    return {{"width", costs.width},
            {"height", costs.height},
            {"cycles", costs.cycles},
            {"mhz", input.khz / 1e3},
            {"pipelines", input.config.pipelines},
            {"contexts", input.config.contexts},
            {"tile_bits", input.config.tile_bits},
            {"explain", input.explain},
            {"maps", maps},
            {"causes", input.judgement ? causes_map(*input.judgement) : ordered_json(nullptr)},
            {"slowest", slowest},
            {"links", links_json(costs, input.config)},
            {"kinds", work_by_kind_json(costs)},
            {"windows", windows},
            {"tiles", tiles}};
}

}   // namespace rayclock
