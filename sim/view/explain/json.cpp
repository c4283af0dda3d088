// Converts an explanation to JSON.
#include <algorithm>

#include <fmt/format.h>

#include "sim/files/image/srgb.hpp"
#include "sim/view/explain/explain.hpp"

namespace rayclock {

using nlohmann::ordered_json;

namespace {

ordered_json sums_json(const std::vector<Stay::Wait>& sums) {
    ordered_json json = ordered_json::object();
    for (const Stay::Wait& sum : sums) json[sum.cause] = sum.cycles;
    return json;
}

const char* lookup_name(CacheOutcome outcome) {
    return unit_infos[index(Unit::node_cache)].causes[std::size_t(outcome)].name;
}

ordered_json step_json(const Step& step) {
    ordered_json waits = ordered_json::object();
    for (const Stay::Wait& wait : step.waits())
        waits[wait.cause] = waits.value(wait.cause, std::uint64_t(0)) + wait.cycles;
    ordered_json units = ordered_json::object();
    for (const Stay* stay : step.stays)
        units[place_name(stay->place)] =
            units.value(place_name(stay->place), std::uint64_t(0)) + stay->cycles;
    ordered_json json{{"step", step_name(step.phase)}, {"cycle", step.first()},
                      {"cycles", step.cycles()},       {"units", units},
                      {"work", step.work()},           {"waits", waits}};
    if (const Stay* lookup = step.lookup()) {
        json["address"] = lookup->addr;
        json["cache"] = lookup_name(lookup->lookup);
    }
    if (step.visit) {
        json["boxes"] = step.visit->children;
        json["boxes_met"] = step.visit->met;
        json["tests"] = step.visit->tests.size();
        json["groups_dropped"] = step.visit->dropped;
    }
    if (step.test) json["closer"] = step.test->closer;
    if (step.test && step.test->closer) json["primitive"] = step.test->prim, json["t"] = step.test->t;
    return json;
}

ordered_json hit_json(const Hit& hit) {
    if (hit.primitive == no_primitive) return nullptr;
    return {{"primitive", hit.primitive}, {"depth", hit.depth}, {"u", hit.u}, {"v", hit.v}};
}
ordered_json rgb_json(const glm::vec3& c) { return {c.r, c.g, c.b}; }
ordered_json bytes_json(const glm::vec3& c) {
    const auto bytes = srgb_bytes(c);
    return {bytes[0], bytes[1], bytes[2]};
}

}   // namespace

std::uint32_t Explanation::number() const { return story.y * costs.width + story.x; }

std::string Explanation::subject() const {
    return is_of_stream() ? fmt::format("ray {}", number()) : fmt::format("pixel ({}, {})", story.x, story.y);
}

const char* Explanation::purpose(const RayValues& ray) const {
    if (is_of_stream()) return ends_at_any(ray.ray.kind) ? "any hit" : "closest hit";
    return purpose_names[std::size_t(ray.purpose)];
}

std::uint64_t Explanation::slower() const {
    return std::uint64_t(std::count_if(costs.pixels.begin(), costs.pixels.end(),
                                       [&](const PixelCost& p) { return p.cycles > story.cost.cycles; }));
}

ordered_json pixel_cost_json(const FrameCosts& costs, const Explanation& e) {
    const PixelCost& p = e.story.cost;
    const FrameCosts::Sums sums = costs.total();
    const double pixels = double(costs.pixels.size());
    return {{"rays", p.rays},
            {"node_visits", p.visits},
            {"primitive_tests", p.tests},
            {"cache_misses", p.misses},
            {"bytes", p.bytes},
            {"first_cycle", p.first},
            {"cycles", p.cycles},
            {"cycles_alone", e.story.alone},
            {"pixels_slower", e.slower()},
            {"mean",
             {{"rays", double(sums.rays) / pixels},
              {"node_visits", double(sums.visits) / pixels},
              {"primitive_tests", double(sums.tests) / pixels},
              {"cache_misses", double(sums.misses) / pixels},
              {"bytes", double(sums.bytes) / pixels},
              {"cycles", double(sums.cycles) / pixels}}},
            {"cycles_by_unit", sums_json(e.story.places())},
            {"cycles_by_cause", sums_json(e.story.causes())}};
}

ordered_json rays_json(const Explanation& e) {
    ordered_json rays = ordered_json::array();
    for (std::size_t i = 0; i < e.story.rays.size(); ++i) {
        const RayStory& ray = e.story.rays[i];
        const RayValues& v = ray.values;
        ordered_json steps = ordered_json::array();
        for (const Step& step : steps_of(ray)) steps.push_back(step_json(step));
        std::uint64_t tests = 0;
        for (const VisitValues& visit : v.visits) tests += visit.tests.size();
        ordered_json hit = nullptr;
        if (v.hit.found) hit = {{"primitive", v.hit.prim}, {"t", v.hit.t}, {"u", v.hit.u}, {"v", v.hit.v}};
        rays.push_back({{"ray", i},
                        {"kind", e.purpose(v)},
                        {"parent", v.parent < 0 ? ordered_json(nullptr) : ordered_json(v.parent)},
                        {"depth", v.depth},
                        {"origin", v.ray.o},
                        {"direction", v.ray.d},
                        {"first_cycle", ray.first},
                        {"cycles", ray.cycles},
                        {"node_visits", v.visits.size()},
                        {"primitive_tests", tests},
                        {"cache_misses", ray.misses + ray.merges},
                        {"hit", hit},
                        {"steps", steps}});
    }
    return rays;
}

ordered_json colour_json(const std::optional<ColourFinding>& c) {
    if (!c) return nullptr;
    ordered_json stages = ordered_json::array();
    for (const PixelStage& stage : c->stages)
        stages.push_back(
            {{"after", stage.name},
             {"primitive", stage.hit.primitive == no_primitive ? ordered_json(nullptr)
                                                               : ordered_json(stage.hit.primitive)},
             {"u", stage.hit.u},
             {"v", stage.hit.v},
             {"rgb", rgb_json(stage.colour)},
             {"srgb", bytes_json(stage.colour)}});
    return {{"machine", {{"rgb", rgb_json(c->machine)}, {"srgb", bytes_json(c->machine)}}},
            {"reference", {{"rgb", rgb_json(c->reference)}, {"srgb", bytes_json(c->reference)}}},
            {"hit", hit_json(c->hit)},
            {"reference_hit", hit_json(c->reference_hit)},
            {"other_primitive", c->is_other},
            {"cause", c->cause ? ordered_json(cause_info(*c->cause).key) : ordered_json(nullptr)},
            {"why", cause_sentence(*c)},
            {"fault", c->fault.empty() ? ordered_json(nullptr) : ordered_json(c->fault)},
            {"stages", stages}};
}

}   // namespace rayclock
