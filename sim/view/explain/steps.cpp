// Groups the stays of a ray into steps.
#include "sim/view/explain/explain.hpp"

namespace rayclock {

namespace {

Step::Phase phase_of(const Stay& stay) {
    switch (Unit(stay.place)) {
        case Unit::stream:
        case Unit::raygen: return Step::Phase::raygen;
        case Unit::trav:
        case Unit::node_cache:
        case Unit::xform: return Step::Phase::visit;
        case Unit::list:
        case Unit::prim_cache:
        case Unit::tri: return Step::Phase::test;
        default: return is_node_unit(Unit(stay.place)) ? Step::Phase::visit : Step::Phase::shade;
    }
}

bool has(const Step& step, Unit unit) {
    for (const Stay* stay : step.stays)
        if (stay->place == index(unit)) return true;
    return false;
}

/// Returns true if a node unit or xform has received the line that the step reads.
bool decides(const Step& step) {
    for (const Stay* stay : step.stays)
        if (takes_lines(Unit(stay->place))) return true;
    return false;
}

/// Returns true if a stay begins a new step. That is a stay of another kind, a node after a node, or a
/// primitive after a primitive. The end of a list, which list reports without another primitive, begins none.
bool begins(const Step& step, const Stay& stay, const Stay* next) {
    if (step.phase != phase_of(stay)) return true;
    if (stay.place == index(Unit::trav) && decides(step)) {
        const bool answered = is_node_answer(stay.by);
        return !answered || !next || next->by != Link::leaves;
    }
    return stay.place == index(Unit::list) && has(step, Unit::tri) && next && next->by == Link::prim_req;
}

/// Returns true for a page of a list, which trav visits without a request.
bool leads_to_leaves(const RayStory& ray, const Step& step) {
    const Stay* next = step.stays.back() + 1;
    return next < ray.stays.data() + ray.stays.size() && next->by == Link::leaves;
}

}   // namespace

std::uint64_t Step::cycles() const {
    std::uint64_t sum = 0;
    for (const Stay* stay : stays) sum += stay->cycles;
    return sum;
}
std::uint64_t Step::work() const {
    std::uint64_t sum = 0;
    for (const Stay* stay : stays) sum += stay->work;
    return sum;
}
std::vector<Stay::Wait> Step::waits() const {
    std::vector<Stay::Wait> all;
    for (const Stay* stay : stays) all.insert(all.end(), stay->waits.begin(), stay->waits.end());
    return all;
}
const Stay* Step::lookup() const {
    for (const Stay* stay : stays)
        if (stay->is_lookup) return stay;
    return nullptr;
}

const char* step_name(Step::Phase phase) {
    constexpr const char* names[] = {"raygen", "visit", "test", "end", "shade"};
    return names[std::size_t(phase)];
}

std::vector<Step> steps_of(const RayStory& ray) {
    std::vector<Step> steps;
    for (std::size_t i = 0; i < ray.stays.size(); ++i) {
        const Stay& stay = ray.stays[i];
        const Stay* next = i + 1 < ray.stays.size() ? &ray.stays[i + 1] : nullptr;
        if (steps.empty() || begins(steps.back(), stay, next))
            steps.push_back({phase_of(stay), {}, nullptr, nullptr});
        steps.back().stays.push_back(&stay);
    }
    auto visit = ray.values.visits.begin();
    const VisitValues* last = nullptr;
    std::size_t test = 0;
    for (Step& step : steps) {
        if (step.phase == Step::Phase::visit && !has(step, Unit::node_cache) && !leads_to_leaves(ray, step))
            step.phase = Step::Phase::end;
        if (step.phase == Step::Phase::visit && visit != ray.values.visits.end()) {
            step.visit = last = &*visit++;
            test = 0;
        }
        if (step.phase == Step::Phase::test && last && test < last->tests.size())
            step.test = &last->tests[test++];
    }
    return steps;
}

}   // namespace rayclock
