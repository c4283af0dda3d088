// Builds the page of one pixel from its explanation.
#include "sim/view/explain/explain_page.hpp"

#include <fmt/format.h>

#include "sim/files/table.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/page/html.hpp"

namespace rayclock {

using nlohmann::ordered_json;

namespace {

/// Returns a visit with the costs of its own step and of the steps of its primitives.
ordered_json visit_json(const VisitValues& visit, const std::vector<const Step*>& steps) {
    std::uint64_t cycles = 0, work = 0;
    ordered_json waits = ordered_json::object();
    const char* cache = "";
    for (const Step* step : steps) {
        cycles += step->cycles();
        work += step->work();
        for (const Stay::Wait& wait : step->waits())
            waits[wait.cause] = waits.value(wait.cause, std::uint64_t(0)) + wait.cycles;
        if (const Stay* lookup = step->lookup(); lookup && step->visit)
            cache = unit_infos[index(Unit::node_cache)].causes[std::size_t(lookup->lookup)].name;
    }
    std::size_t closer = 0;
    for (const TestValues& test : visit.tests) closer += test.closer;
    return {{"line", visit.line},
            {"parent", visit.parent},
            {"boxes", visit.children},
            {"met", visit.met},
            {"tests", visit.tests.size()},
            {"closer", closer},
            {"dropped", visit.dropped},
            {"cycle", steps.empty() ? ordered_json(nullptr) : ordered_json(steps.front()->first())},
            {"cycles", cycles},
            {"work", work},
            {"cache", cache},
            {"waits", waits}};
}

ordered_json visits_json(const RayStory& ray) {
    const std::vector<Step> steps = steps_of(ray);
    std::vector<std::vector<const Step*>> of(ray.values.visits.size());
    std::size_t at = of.size();
    for (const Step& step : steps) {
        if (step.visit) at = std::size_t(step.visit - ray.values.visits.data());
        if (at < of.size() && (step.visit || step.test)) of[at].push_back(&step);
    }
    ordered_json visits = ordered_json::array();
    for (std::size_t v = 0; v < of.size(); ++v) visits.push_back(visit_json(ray.values.visits[v], of[v]));
    return visits;
}

std::string steps_as_html(const RayStory& ray) {
    std::vector<std::vector<std::string>> rows;
    for (const Step& step : steps_of(ray)) {
        std::string waits;
        for (const Stay::Wait& wait : step.waits())
            waits += fmt::format("{}{} {}", waits.empty() ? "" : ", ", wait.cause, wait.cycles);
        const Stay* lookup = step.lookup();
        rows.push_back({grouped(step.first()), step_name(step.phase),
                        lookup ? std::to_string(lookup->addr) : "", waits, grouped(step.cycles()),
                        grouped(step.work())});
    }
    return html::table("", {"cycle", "step", "address", "waited for", "cycles", "work"}, rows, 4);
}

}   // namespace

std::string explanation_page(const ordered_json& json, const std::string& text, const Explanation& e,
                             const std::vector<std::pair<std::string, std::string>>& origin) {
    ordered_json rays = ordered_json::array();
    std::string tables;
    for (std::size_t i = 0; i < e.story.rays.size(); ++i) {
        const RayStory& ray = e.story.rays[i];
        const char* purpose = e.purpose(ray.values);
        rays.push_back({{"purpose", purpose}, {"visits", visits_json(ray)}});
        if (i >= 20) continue;   // the text has all rays
        tables +=
            fmt::format("<details{}><summary>ray {}, {}</summary><div class=\"scroll\">{}</div></details>\n",
                        i ? "" : " open", i, purpose, steps_as_html(ray));
    }
    const PixelStory& s = e.story;
    std::vector<std::vector<std::string>> lines;
    for (const auto& [key, value] : origin) lines.push_back({key, value});
    FramedPage page;
    page.title = fmt::format(
        "{} of {} on {}",
        e.is_of_stream() ? fmt::format("Ray {}", e.number()) : fmt::format("Pixel {}, {}", s.x, s.y),
        json.at("scene").at("name").get<std::string>(), e.config.name);
    page.header = fmt::format("<p>{:g} MHz, made by rayclock.</p>", e.khz / 1e3) +
                  html::figures({{"cycles", grouped(s.cost.cycles)},
                                 {"cycles alone on the chip", grouped(s.alone)},
                                 {e.is_of_stream() ? "rays of the stream took longer"
                                                   : "pixels of the frame took longer",
                                  grouped(e.slower())},
                                 {"rays", grouped(s.cost.rays)},
                                 {"node visits", grouped(s.cost.visits)},
                                 {"primitive tests", grouped(s.cost.tests)}});
    page.body = html::section("path", "The way of each ray through the tree",
                              "<p class=\"controls\"><label>ray <select id=\"ray\"></select></label></p><p>A "
                              "circle is a visit of "
                              "a node, in the order of its number, below the node from which it was reached. "
                              "The larger it is, the more "
                              "cycles it took; its ring is orange where the node had to come from memory. A "
                              "green one found the hit, or a "
                              "closer one.</p>" +
                                  html::chart("tree", "the ray's path through the tree") +
                                  html::chart("steps", "cycles of every visit, and what they were for")) +
                html::section("steps", "Every step", tables) +
                html::section("words", "The same in words", "<pre>" + html::escaped(text) + "</pre>") +
                html::section("origin", "Origin", html::table("", {"what", "value"}, lines, 2));
    page.data = html::data_element("explanation", json) + html::data_element("data", {{"rays", rays}});
    page.scripts = page_explain;
    page.trees = true;
    page.far = html::far_sentence(json);
    return framed(page);
}

}   // namespace rayclock
