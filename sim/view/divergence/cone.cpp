// Finds the signals that explain a wrong value, backwards from the output.
#include "sim/view/divergence/cone.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "sim/run/lockstep/driver.hpp"
#include "sim/run/rtl/sources.hpp"
#include "sim/view/divergence/fields.hpp"
#include "sim/view/divergence/rtl_text.hpp"
#include "sim/view/divergence/waveform.hpp"
#include "sim/view/wave/fst.hpp"

namespace rayclock {

namespace {

/// The unit's signals in every cycle that was written.
class Signals {
public:
    Signals(const std::string& rtl_wave, const std::string& unit, int pipeline) {
        for (const InsideSignal& inside : signals_inside(rtl_wave, unit, pipeline)) {
            numbers_.emplace(without_range(inside.name), inside.number);
            changes_[inside.number];
        }
        FstVisitor visitor;
        visitor.change = [&](std::uint64_t time, std::uint32_t number, std::string_view digits) {
            const auto found = changes_.find(number);
            if (found == changes_.end()) return;
            const std::uint64_t cycle = cycle_of(time);
            auto& all = found->second;
            if (!all.empty() && all.back().cycle == cycle)
                all.back().digits = digits;
            else
                all.push_back({cycle, std::string(digits)});
        };
        read_fst(rtl_wave, visitor);
    }

    /// The path of a signal of an instance, "u_hitdiv.", in whichever generate block of it; of an array that
    /// of an element. One that holds the value comes first.
    std::optional<std::string> find(const std::string& instance, const std::string& name,
                                    const std::function<bool(const std::string& path)>& holds) const {
        std::optional<std::string> first;
        for (auto it = numbers_.lower_bound(instance);
             it != numbers_.end() && it->first.starts_with(instance); ++it) {
            const std::string rest = it->first.substr(instance.size());
            const std::size_t dot = rest.rfind('.');
            const std::string own = rest.substr(dot == std::string::npos ? 0 : dot + 1);
            if (own.substr(0, own.find('[')) != name) continue;
            if (dot != std::string::npos && !only_blocks(rest.substr(0, dot))) continue;
            if (holds(it->first)) return it->first;
            if (!first) first = it->first;
        }
        return first;
    }

    /// Its digits in a cycle; empty if they are not known.
    std::string at(const std::string& path, std::uint64_t cycle) const {
        const ValueChange* change = before(path, cycle);
        return change ? change->digits : "";
    }
    /// The cycle before it got the value that it has; none if it has had the value from the first cycle on.
    std::optional<std::uint64_t> before_value(const std::string& path, std::uint64_t cycle) const {
        const ValueChange* change = before(path, cycle);
        const std::uint64_t since = change ? change->cycle : cycle;
        return since > 0 ? std::make_optional(since - 1) : std::nullopt;
    }

    /// Returns the instance's name with its generate blocks, as signals' names have it: "gen_exact.u_edges."
    /// for "u_edges".
    std::optional<std::string> instance(const std::string& parent, const std::string& name) const {
        for (auto it = numbers_.lower_bound(parent); it != numbers_.end() && it->first.starts_with(parent);
             ++it) {
            const std::string rest = it->first.substr(parent.size());
            const std::size_t at = rest.starts_with(name + ".") ? 0 : rest.find("." + name + ".");
            if (at == std::string::npos) continue;
            const std::string blocks = rest.substr(0, at);
            if (!blocks.empty() && !only_blocks(blocks)) continue;
            return parent + (blocks.empty() ? "" : blocks + ".") + name + ".";
        }
        return {};
    }

private:
    struct ValueChange {
        std::uint64_t cycle;
        std::string digits;
    };
    /// "mem_q[3]" of "mem_q[3][7:0]": an element's number stays.
    static std::string without_range(const std::string& name) {
        const std::size_t bracket = name.rfind('[');
        const bool has_range = bracket != std::string::npos && name.find(':', bracket) != std::string::npos;
        return has_range ? name.substr(0, bracket) : name;
    }
    static bool only_blocks(const std::string& scopes) {
        return scopes.starts_with("gen_") && scopes.find(".u_") == std::string::npos;
    }
    const ValueChange* before(const std::string& path, std::uint64_t cycle) const {
        const auto& all = changes_.at(numbers_.at(path));
        const auto after =
            std::upper_bound(all.begin(), all.end(), cycle,
                             [](std::uint64_t c, const ValueChange& change) { return c < change.cycle; });
        return after == all.begin() ? nullptr : &*(after - 1);
    }

    std::map<std::string, std::uint32_t> numbers_;   // by path
    std::map<std::uint32_t, std::vector<ValueChange>> changes_;
};

class ConeWalk {
public:
    ConeWalk(const Divergence& divergence, const Config& config, const Capture& capture,
             const std::string& rtl_wave, const std::vector<RtlText>& sources)
        : divergence_(divergence),
          unit_(divergence.unit.substr(0, divergence.unit.find('['))),
          ports_(output_names(divergence, config)),
          signals_(rtl_wave, unit_, divergence.pipeline) {
        for (const RtlText& source : sources) {
            ModuleText module = read_module(source.name, source.text);
            if (!module.name.empty()) modules_.emplace(module.name, std::move(module));
        }
        wanted_ = wrong_digits(config, capture);
    }

    std::vector<ConeStep> run() {
        const auto unit = modules_.find("rc_" + unit_);
        if (wanted_.empty() || unit == modules_.end()) return {};
        ConeNode node{{{"", unit->second.name}}, "", divergence_.cycle};
        for (const std::string& port : ports_)
            if (signals_.find("", port, [](const std::string&) { return true; })) {
                node.name = port;
                break;
            }
        constexpr std::size_t most = 64;
        while (!node.name.empty() && steps_.size() < most && step(node)) {}
        return std::move(steps_);
    }

private:
    struct Level {
        std::string instance, module;   ///< "u_hitdiv.", "rc_hitdiv"
    };
    struct ConeNode {
        std::vector<Level> levels;
        std::string name;   ///< of the signal
        std::uint64_t cycle;
    };

    /// The digits of the field that differs, or of the offer, as the RTL has them.
    std::string wrong_digits(const Config& config, const Capture& capture) const {
        if (!divergence_.on || divergence_.cycle < capture.first ||
            divergence_.cycle - capture.first >= capture.cycles.size())
            return {};
        const auto& links = capture.cycles[divergence_.cycle - capture.first];
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (capture.links[i].link != *divergence_.on) continue;
            if (index(*divergence_.on) < pipeline_links && capture.links[i].pipeline != divergence_.pipeline)
                continue;
            if (divergence_.field.empty()) return links[i].rtl_valid ? "1" : "0";
            std::string name = divergence_.field;   // "o[1]" is the field o_1
            if (const std::size_t bracket = name.find('['); bracket != std::string::npos)
                name = name.substr(0, bracket) + "_" + name.substr(bracket + 1, name.size() - bracket - 2);
            for (const PayloadField& field : payload_fields(*divergence_.on, config))
                if (field.name == name && !links[i].rtl.empty())
                    return digits_of(links[i].rtl, field.at, field.width);
        }
        return {};
    }

    bool holds(const std::string& path, std::uint64_t cycle) const {
        const std::string digits = signals_.at(path, cycle);
        constexpr std::size_t telling = 4;   // a shorter value is in any wide signal
        return wanted_.size() < telling ? digits == wanted_ : digits.find(wanted_) != std::string::npos;
    }
    std::optional<std::string> path_of(const ConeNode& node, const std::string& name,
                                       std::uint64_t cycle) const {
        return signals_.find(node.levels.back().instance, name,
                             [&](const std::string& path) { return holds(path, cycle); });
    }

    /// One driver back; false if the value is made here.
    bool step(ConeNode& node) {
        const ModuleText& module = modules_.at(node.levels.back().module);
        if (!seen_.insert({node.levels.back().instance + node.name, node.cycle}).second) return false;
        std::vector<const SignalDriver*> drivers;
        for (const SignalDriver& driver : module.drivers)
            if (std::find(driver.targets.begin(), driver.targets.end(), node.name) != driver.targets.end())
                drivers.push_back(&driver);
        if (drivers.empty()) return go_out(node);
        for (const SignalDriver* driver : drivers)
            if (driver->construct == SignalDriver::Construct::instance && go_in(node, module, *driver))
                return true;
        const SignalDriver* best = nullptr;
        std::string next;
        std::uint64_t cycle = node.cycle;
        for (const SignalDriver* driver : drivers) {
            if (driver->construct == SignalDriver::Construct::instance) continue;
            if (!best) best = driver;
            std::optional<std::uint64_t> then = node.cycle;
            if (driver->construct == SignalDriver::Construct::registered)
                if (const auto path = path_of(node, node.name, node.cycle))
                    then = signals_.before_value(*path, node.cycle);
            if (!then) continue;
            std::vector<std::string> candidates;
            for (const std::string& source : driver->sources)
                if (const auto path = path_of(node, source, *then); path && holds(*path, *then))
                    candidates.push_back(source);
            // Of a flag that several others make, any may be the wrong one.
            if (candidates.empty() || (wanted_.size() == 1 && candidates.size() > 1)) continue;
            best = driver, next = candidates.front(), cycle = *then;
            break;
        }
        if (!best) return false;
        note(node, module, best->line, best->construct == SignalDriver::Construct::registered);
        if (next.empty()) {
            for (const SignalDriver* driver : drivers)
                if (driver != best && driver->construct != SignalDriver::Construct::instance)
                    steps_.back().others.push_back(source_of(module, driver->line));
            return false;
        }
        node.name = next, node.cycle = cycle;
        return true;
    }

    static SourceLine source_of(const ModuleText& module, std::size_t line) {
        const std::string& text = module.lines[line - 1];
        const std::size_t first = text.find_first_not_of(' ');
        return {module.file, line, first == std::string::npos ? "" : text.substr(first)};
    }
    void note(const ConeNode& node, const ModuleText& module, std::size_t line, bool is_register) {
        steps_.push_back(
            {source_of(module, line), {}, node.levels.back().instance + node.name, node.cycle, is_register});
    }

    /// Into the instance whose output it is. A cell that only keeps values gives it from the input that had
    /// it before.
    bool go_in(ConeNode& node, const ModuleText& module, const SignalDriver& driver) {
        const auto child = modules_.find(driver.module);
        const auto instance = signals_.instance(node.levels.back().instance, driver.instance);
        note(node, module, driver.line, false);
        if (child == modules_.end() || !instance) return false;
        if (child->second.file.starts_with("cells/")) return go_through(node, module, driver);
        node.levels.push_back({*instance, child->second.name});
        node.name = driver.port;
        return true;
    }

    bool go_through(ConeNode& node, const ModuleText& module, const SignalDriver& driver) {
        constexpr std::uint64_t longest = 1000;   // cycles
        std::optional<std::uint64_t> latest;
        std::string from;
        for (const InputConnection& input : module.inputs) {
            if (input.instance != driver.instance || input.port.find("data") == std::string::npos) continue;
            for (const std::string& source : input.sources)
                for (std::uint64_t back = 0; back <= std::min(longest, node.cycle); ++back) {
                    const std::uint64_t then = node.cycle - back;
                    if (latest && then <= *latest) break;
                    const auto path = path_of(node, source, then);
                    if (!path) break;
                    if (!holds(*path, then)) continue;
                    latest = then, from = source;
                    break;
                }
        }
        if (!latest) return false;
        node.name = from, node.cycle = *latest;
        return true;
    }

    /// Out of an instance, to what its input is connected to; not out of the unit.
    bool go_out(ConeNode& node) {
        if (node.levels.size() < 2) return false;
        std::string instance = node.levels.back().instance;
        instance.pop_back();
        instance = instance.substr(instance.rfind('.') + 1);
        node.levels.pop_back();
        const ModuleText& module = modules_.at(node.levels.back().module);
        for (const InputConnection& input : module.inputs) {
            if (input.instance != instance || input.port != node.name) continue;
            for (const std::string& source : input.sources)
                if (const auto path = path_of(node, source, node.cycle); path && holds(*path, node.cycle)) {
                    node.name = source;
                    return true;
                }
        }
        return false;
    }

    const Divergence& divergence_;
    std::string unit_, wanted_;
    std::vector<std::string> ports_;   // that the unit may have for it
    Signals signals_;
    std::map<std::string, ModuleText> modules_;
    std::set<std::pair<std::string, std::uint64_t>> seen_;
    std::vector<ConeStep> steps_;
};

}   // namespace

std::vector<ConeStep> cone_of(const Divergence& divergence, const Config& config, const Capture& capture,
                              const std::string& rtl_wave, const std::vector<RtlText>& sources) {
    if (!divergence.on) return {};
    return ConeWalk(divergence, config, capture, rtl_wave, sources).run();
}

}   // namespace rayclock
