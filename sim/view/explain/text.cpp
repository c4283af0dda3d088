// Formats an explanation as text tables.
#include <fmt/format.h>

#include "sim/files/image/srgb.hpp"
#include "sim/files/table.hpp"
#include "sim/view/explain/explain.hpp"

namespace rayclock {

namespace {

std::string share(std::uint64_t part, std::uint64_t all) {
    return all ? fmt::format("{:.1f} %", 100.0 * double(part) / double(all)) : "";
}

std::string cost_table(const Explanation& e) {
    const FrameCosts::Sums sums = e.costs.total();
    const double pixels = double(e.costs.pixels.size());
    Table table({"cost", e.is_of_stream() ? "ray" : "pixel",
                 e.is_of_stream() ? "mean of the stream" : "mean of the frame", "times the mean"});
    const auto row = [&](const char* name, std::uint64_t mine, std::uint64_t all) {
        const double mean = double(all) / pixels;
        table.add({name, grouped(mine), fmt::format("{:.1f}", mean),
                   mean > 0 ? fmt::format("{:.2f}", double(mine) / mean) : ""});
    };
    const PixelCost& p = e.story.cost;
    row("cycles", p.cycles, sums.cycles);
    if (!e.is_of_stream()) row("rays", p.rays, sums.rays);
    row("node visits", p.visits, sums.visits);
    row("primitive tests", p.tests, sums.tests);
    row("cache misses", p.misses, sums.misses);
    row("bytes of memory", p.bytes, sums.bytes);
    return table.text();
}

std::string sums_table(const char* head, const std::vector<Stay::Wait>& sums, std::uint64_t all) {
    Table table({head, "cycles", "share"});
    for (const Stay::Wait& sum : sums) table.add({sum.cause, grouped(sum.cycles), share(sum.cycles, all)});
    return table.text();
}

std::string hit_text(const RayValues& ray) {
    if (ends_at_any(ray.ray.kind)) return ray.hit.found ? fmt::format("blocked by {}", ray.hit.prim) : "free";
    return ray.hit.found ? fmt::format("primitive {} at t={}", ray.hit.prim, ray.hit.t) : "nothing";
}

std::string rays_table(const Explanation& e) {
    Table table({"ray", "hit", "cycle", "cycles", "visits", "tests", "misses"}, 2);
    for (std::size_t i = 0; i < e.story.rays.size(); ++i) {
        const RayStory& ray = e.story.rays[i];
        std::uint64_t tests = 0;
        for (const VisitValues& visit : ray.values.visits) tests += visit.tests.size();
        const int indent = 2 * (ray.values.depth + (ray.values.purpose == RayPurpose::shadow));
        table.add({std::string(std::size_t(indent), ' ') +
                       fmt::format("{} {}", e.is_of_stream() ? e.number() : i, e.purpose(ray.values)),
                   hit_text(ray.values), grouped(ray.first), grouped(ray.cycles),
                   grouped(ray.values.visits.size()), grouped(tests), grouped(ray.misses + ray.merges)});
    }
    return table.text();
}

std::string outcome(const Step& step) {
    if (step.visit)
        return fmt::format("{} of {} boxes met, {} to test{}", step.visit->met, step.visit->children,
                           step.visit->tests.size(),
                           step.visit->dropped ? fmt::format(", {} dropped", step.visit->dropped) : "");
    if (step.test) return step.test->closer ? fmt::format("closer: t={}", step.test->t) : "not closer";
    return step.phase == Step::Phase::end ? "the stack is empty, or the way blocked" : "";
}

std::string steps_as_text(const RayStory& ray) {
    Table table({"cycle", "step", "address", "cache", "outcome", "waited for", "cycles", "work"}, 6);
    for (const Step& step : steps_of(ray)) {
        const Stay* lookup = step.lookup();
        std::string waits;
        for (const Stay::Wait& wait : step.waits())
            waits += fmt::format("{}{} {}", waits.empty() ? "" : ", ", wait.cause, wait.cycles);
        constexpr const char* outcomes[] = {"hit", "miss", "merge"};
        table.add({grouped(step.first()), step_name(step.phase),
                   lookup ? fmt::format("{}", lookup->addr) : "",
                   lookup ? outcomes[std::size_t(lookup->lookup)] : "", outcome(step), waits,
                   grouped(step.cycles()), grouped(step.work())});
    }
    return table.text(4);
}

std::string rgb(const glm::vec3& c) {
    const auto b = srgb_bytes(c);
    return fmt::format("({}, {}, {})", b[0], b[1], b[2]);
}
std::string named(const Hit& hit) {
    return hit.primitive == no_primitive ? "nothing" : fmt::format("primitive {}", hit.primitive);
}

std::string colour_lines(const ColourFinding& c) {
    std::string text = fmt::format("  colour: {} of 255, {}; the reference's is {}, {}\n", rgb(c.machine),
                                   named(c.hit), rgb(c.reference), named(c.reference_hit));
    if (const std::string why = cause_sentence(c); !why.empty()) text += "  why: " + why + "\n";
    if (c.stages.empty() || !c.cause || *c.cause == PixelCause::none) return text;
    Table table({"after", "primitive", "u", "v", "colour"});
    for (const PixelStage& stage : c.stages)
        table.add({stage.name, named(stage.hit), fmt::format("{:.6f}", stage.hit.u),
                   fmt::format("{:.6f}", stage.hit.v),
                   fmt::format("{:.5f} {:.5f} {:.5f}", stage.colour.r, stage.colour.g, stage.colour.b)});
    return text + table.text();
}

}   // namespace

std::string cause_sentence(const ColourFinding& c) {
    if (!c.cause) return {};
    switch (*c.cause) {
        case PixelCause::none: return "it does not differ: same primitive, same 8-bit colour";
        case PixelCause::snapping:
            return "vertices lie on lattice points, and not where the scene has them (snapping)";
        case PixelCause::ray_quantisation:
            return "the ray's direction, or where a secondary ray begins, is rounded to whole numbers "
                   "(ray_quantisation)";
        case PixelCause::seam:
            return "two instances meet here, and each rounds the ray for itself: no single line gives what "
                   "was hit (seam)";
        case PixelCause::t_rounding: return "t, u and v are rounded to the machine's formats (t_rounding)";
        case PixelCause::primitive_test:
            return "the cheaper primitive test gave another answer than the exact one (primitive_test)";
        case PixelCause::shading:
            return "all rays met what they must; the chip's colour arithmetic rounds, within its proven "
                   "bounds (shading)";
        case PixelCause::texture:
            return "all rays met what they must; a texture's coordinates, level or texels are rounded "
                   "(texture)";
        case PixelCause::horizon:
            return "a ray from a point of a plane beyond the lattice meets another plane there, and the chip "
                   "does not look for it (horizon)";
        case PixelCause::bug: break;
    }
    return "something is wrong (bug)" + (c.fault.empty() ? std::string() : ": " + c.fault);
}

std::string explanation_text(const Explanation& e, bool steps) {
    const PixelStory& s = e.story;
    const std::uint64_t cycles = s.cost.cycles;
    std::string text = fmt::format(
        "  {}: {} cycles, from cycle {} to {} of {}, in pipeline {}, context {}\n"
        "  {} of {} {} took longer; alone on the chip, with warm caches, it takes {} cycles\n\n",
        e.subject(), grouped(cycles), grouped(s.cost.first), grouped(s.cost.first + cycles),
        grouped(e.costs.cycles), s.pipeline, s.context, grouped(e.slower()), grouped(e.costs.pixels.size()),
        e.is_of_stream() ? "rays" : "pixels", grouped(s.alone));
    text += cost_table(e) + "\n" + sums_table("where it was", s.places(), cycles) + "\n" +
            sums_table("what the cycles were for", s.causes(), cycles) + "\n" + rays_table(e);
    if (steps)
        for (std::size_t i = 0; i < s.rays.size(); ++i)
            text += fmt::format("\n  ray {}, {}\n{}", e.is_of_stream() ? e.number() : i,
                                e.purpose(s.rays[i].values), steps_as_text(s.rays[i]));
    if (e.colour) text += "\n" + colour_lines(*e.colour);
    return text;
}

}   // namespace rayclock
