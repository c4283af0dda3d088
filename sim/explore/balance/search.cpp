// Climbs from the smallest machine along the values of its parameters.
#include "sim/explore/balance/search.hpp"

#include <algorithm>
#include <set>

namespace rayclock::balance {

const std::vector<ParameterValues>& parameter_values() {
    // Excludes parameters that formats and the scene fix (stack_depth), and those that cost no hardware
    // (tile_bits).
    static const std::vector<ParameterValues> all{{"node_width", &Config::node_width, {2, 4, 8}},
                                                  {"contexts", &Config::contexts, {16, 32, 64, 128}},
                                                  {"box_queue", &Config::box_queue, {16, 32, 64}},
                                                  {"tri_queue", &Config::tri_queue, {16, 32, 64, 128}},
                                                  {"tri_interval", &Config::tri_interval, {4, 2, 1}},
                                                  {"node_sets", &Config::node_sets, {32, 64, 128, 256, 512}},
                                                  {"node_mshrs", &Config::node_mshrs, {4, 8, 16}},
                                                  {"prim_sets", &Config::prim_sets, {32, 64, 128, 256, 512}},
                                                  {"prim_mshrs", &Config::prim_mshrs, {4, 8, 16}}};
    return all;
}

bool fits(const chip::Use& use, const chip::Use& room) {
    return std::all_of(
        chip::resources().begin(), chip::resources().end(),
        [&](const chip::Resource& resource) { return use.*resource.member <= room.*resource.member; });
}

namespace {

using Members = std::vector<int>;

/// Returns the values of all parameters, which identify a machine.
Members members(const Config& config) {
    Members all;
    for (const ParameterValues& p : parameter_values()) all.push_back(config.*p.member);
    return all;
}

/// Returns the step by `by` places in the parameter's values; nothing beyond their ends.
std::optional<Step> step_of(const Config& config, const ParameterValues& p, int by) {
    const auto at = std::find(p.values.begin(), p.values.end(), config.*p.member);
    const std::ptrdiff_t to = at - p.values.begin() + by;
    if (at == p.values.end() || to < 0 || to >= std::ptrdiff_t(p.values.size())) return std::nullopt;
    return Step{&p, *at, p.values[std::size_t(to)]};
}

class Search {
public:
    Search(const chip::Use& room, const Evaluator& evaluator) : room_(room), evaluator_(evaluator) {}

    std::optional<SearchResult> run(const Config& base) {
        Machine first{{}, base, {}, {}};
        for (const ParameterValues& p : parameter_values()) first.config.*p.member = p.values.front();
        std::vector<Machine> one{first};
        if (!ask(one) || !evaluator_.use(one)) return std::nullopt;
        at_ = found_.first = one[0];
        if (!at_.fps || !at_.use || !fits(*at_.use, room_)) return found_;
        do climb();
        while (!stopped_ && trim());   // freed resources may allow another step up
        if (stopped_ || !look_ahead()) return std::nullopt;
        return found_;
    }

private:
    void climb() {
        while (!stopped_ && (take_first(ups()) || (!stopped_ && take_first(pairs())) ||
                             (!stopped_ && take_first(exchanges())))) {}
    }
    Machine moved(std::vector<Step> steps) const {
        Machine machine{std::move(steps), at_.config, {}, {}};
        for (const Step& step : machine.steps) machine.config.*step.parameter->member = step.to;
        return machine;
    }
    std::vector<Step> steps(int by) const {
        std::vector<Step> all;
        for (const ParameterValues& p : parameter_values())
            if (const auto step = step_of(at_.config, p, by)) all.push_back(*step);
        return all;
    }
    std::vector<Machine> ups() const {
        std::vector<Machine> all;
        for (const Step& step : steps(1)) all.push_back(moved({step}));
        return all;
    }
    std::vector<Machine> pairs() const {
        std::vector<Machine> all;
        const std::vector<Step> up = steps(1);
        for (std::size_t a = 0; a < up.size(); ++a)
            for (std::size_t b = a + 1; b < up.size(); ++b) all.push_back(moved({up[a], up[b]}));
        return all;
    }
    std::vector<Machine> exchanges() const {
        std::vector<Machine> all;
        for (const Step& down : steps(-1))
            for (const Step& up : steps(1))
                if (up.parameter != down.parameter) all.push_back(moved({down, up}));
        return all;
    }

    bool ask(std::vector<Machine>& machines) {
        found_.machines += machines.size();
        return evaluator_.fps(machines);
    }
    double gain(const Machine& machine) const { return machine.fps ? *machine.fps / *at_.fps - 1 : -1; }

    /// Moves to the machine with the largest gain per step among those that fit. Returns false if there is
    /// none. A machine that did not fit before is not measured again.
    bool take_first(std::vector<Machine> machines) {
        if (!ask(machines)) return stop();
        std::erase_if(machines, [&](const Machine& m) {
            return gain(m) < least_gain || too_large_.contains(members(m.config));
        });
        std::stable_sort(machines.begin(), machines.end(), [&](const Machine& a, const Machine& b) {
            return gain(a) * double(b.steps.size()) > gain(b) * double(a.steps.size());
        });
        for (const Machine& machine : machines) {
            std::vector<Machine> one{machine};
            if (!evaluator_.use(one)) return stop();
            if (!one[0].use || !fits(*one[0].use, room_)) {
                too_large_.insert(members(machine.config));
                continue;
            }
            at_ = one[0];
            found_.path.push_back(at_);
            return true;
        }
        return false;
    }
    bool stop() {
        stopped_ = true;
        return false;
    }

    /// Steps down where no speed is lost. Returns true if at least one step was possible.
    bool trim() {
        bool trimmed = false;
        while (true) {
            std::vector<Machine> machines;
            for (const Step& step : steps(-1)) machines.push_back(moved({step}));
            if (!ask(machines)) return stop();
            std::erase_if(machines, [&](const Machine& m) { return gain(m) < 0; });
            if (machines.empty()) return trimmed;
            machines.resize(1);
            if (!evaluator_.use(machines)) return stop();
            if (!machines[0].use || !fits(*machines[0].use, room_)) return trimmed;
            at_ = machines[0];
            found_.path.push_back(at_);
            trimmed = true;
        }
    }

    /// Records the gain and the cost of each further step. Returns false if interrupted.
    bool look_ahead() {
        found_.next = ups();
        if (!ask(found_.next)) return false;
        std::erase_if(found_.next, [&](const Machine& m) { return gain(m) < least_gain; });
        return evaluator_.use(found_.next);
    }

    const chip::Use& room_;
    const Evaluator& evaluator_;
    Machine at_;
    SearchResult found_;
    std::set<Members> too_large_;
    bool stopped_ = false;
};

/// Returns true if `a` fits and is faster than `b`.
bool better(const Machine& a, const Machine& b, const chip::Use& room) {
    const auto value = [&](const Machine& m) { return m.fps && m.use && fits(*m.use, room) ? *m.fps : -1; };
    return value(a) > value(b);
}

}   // namespace

std::optional<SearchResult> search(const Config& base, const chip::Use& room, const Evaluator& evaluator) {
    std::optional<SearchResult> best;
    std::vector<Machine> others;
    std::size_t machines = 0;
    for (const int count : pipeline_counts) {
        Config config = base;
        config.pipelines = count;
        std::optional<SearchResult> found = Search(room, evaluator).run(config);
        if (!found) return std::nullopt;
        machines += found->machines;
        const bool first_fits = found->first.use && fits(*found->first.use, room);
        if (!best || better(found->best(), best->best(), room)) std::swap(best, found);
        if (found) others.push_back(found->best());
        if (!first_fits) break;   // then no larger number of pipelines fits
    }
    best->others = std::move(others);
    best->machines = machines;
    return best;
}

}   // namespace rayclock::balance
