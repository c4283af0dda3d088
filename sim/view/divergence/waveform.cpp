// Writes the links of a capture as an FST file, with a save file for GTKWave.
#include "sim/view/divergence/waveform.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "sim/view/divergence/fields.hpp"
#include "sim/view/wave/fst.hpp"
#include "sim/view/wave/gtkw.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t cycle_time = 10, settled = 5;
constexpr int cycle_bits = 40;

std::string scope_of(const Capture::CapturedLink& where, const Config& config) {
    const char* link = link_infos[index(where.link)].name;
    return config.pipelines > 1 && index(where.link) < pipeline_links
               ? fmt::format("{}_{}", link, where.pipeline)
               : link;
}

/// The links of a capture as signals.
class LinkSignals {
public:
    LinkSignals(FstWriter& out, const Capture& capture, const Config& config) : out_(out), capture_(capture) {
        out.open_scope("links");
        cycle_ = out.add_bits("cycle", cycle_bits);
        for (const Capture::CapturedLink& where : capture.links) {
            out.open_scope(scope_of(where, config));
            Signals s;
            for (std::size_t i = 0; i < flag_names.size(); ++i)
                if (has(i)) s.flags[i] = out.add_bits(flag_names[i], 1);
            s.fields = payload_fields(where.link, config);
            for (const PayloadField& field : s.fields) {
                if (capture.has_model) s.model.push_back(out.add_bits(field.name + "_model", field.width));
                s.rtl.push_back(out.add_bits(field.name + "_rtl", field.width));
            }
            out.close_scope();
            signals_.push_back(std::move(s));
        }
        out.close_scope();
    }

    /// Changes up to a time of the file, and at it.
    void set_up_to(std::uint64_t time) {
        for (; next_ < capture_.cycles.size() && (capture_.first + next_) * cycle_time <= time; ++next_) {
            out_.set_time((capture_.first + next_) * cycle_time);
            set(capture_.cycles[next_], capture_.first + next_);
        }
    }

private:
    static constexpr std::array flag_names{"valid_model", "valid_rtl", "fires_model", "fires_rtl", "differs"};
    /// True if the file has a flag: without the model only the RTL's, which are the second and the fourth.
    bool has(std::size_t flag) const { return capture_.has_model || flag == 1 || flag == 3; }
    struct Signals {
        std::array<FstWriter::Signal, flag_names.size()> flags;
        std::vector<PayloadField> fields;
        std::vector<FstWriter::Signal> model, rtl;
    };

    void set(const std::vector<LinkCycle>& links, std::uint64_t cycle) {
        out_.set_value(cycle_, cycle);
        for (std::size_t i = 0; i < links.size(); ++i) {
            const LinkCycle& link = links[i];
            const std::array flags{link.model_valid, link.rtl_valid, link.model_fires, link.rtl_fires,
                                   link.differs()};
            for (std::size_t f = 0; f < flags.size(); ++f)
                if (has(f)) out_.set_value(signals_[i].flags[f], flags[f]);
            for (std::size_t f = 0; f < signals_[i].fields.size(); ++f) {
                const PayloadField& field = signals_[i].fields[f];
                if (capture_.has_model) set(signals_[i].model[f], field, link.model);
                set(signals_[i].rtl[f], field, link.rtl);
            }
        }
    }
    void set(FstWriter::Signal signal, const PayloadField& field, const Words& payload) {
        out_.set_bits(signal, payload.empty() ? std::string(std::size_t(field.width), 'x')
                                              : digits_of(payload, field.at, field.width));
    }

    FstWriter& out_;
    const Capture& capture_;
    FstWriter::Signal cycle_ = 0;
    std::vector<Signals> signals_;
    std::size_t next_ = 0;
};

/// The signals of the unit itself, not of instances inside it.
std::vector<GtkwSignal> signals_of(const std::string& rtl_wave, const std::string& unit, int pipeline) {
    std::vector<GtkwSignal> all;
    for (const InsideSignal& signal : signals_inside(rtl_wave, unit, pipeline))
        if (signal.name.find('.') == std::string::npos)
            all.push_back({signal.width > 1 ? GtkwSignal::As::hexadecimal : GtkwSignal::As::bits,
                           signal.instance + signal.name});
    return all;
}

std::string hexadecimal(std::string_view digits) {
    constexpr std::size_t group = 4;
    std::string text;
    for (std::size_t end = digits.size(); end > 0; end -= std::min(end, group)) {
        const std::size_t begin = end - std::min(end, group);
        unsigned value = 0;
        for (std::size_t i = begin; i < end; ++i) value = 2 * value + (digits[i] == '1');
        text.insert(0, fmt::format("{:x}", value));
    }
    return text;
}

std::vector<GtkwSignal> signals_of_link(const Capture::CapturedLink& where, bool has_model,
                                        const Config& config) {
    using Names = std::vector<const char*>;
    const std::string path = "links." + scope_of(where, config) + ".";
    std::vector<GtkwSignal> all;
    for (const char* flag : has_model
                                ? Names{"differs", "valid_model", "valid_rtl", "fires_model", "fires_rtl"}
                                : Names{"valid_rtl", "fires_rtl"})
        all.push_back({GtkwSignal::As::bits, path + flag});
    for (const PayloadField& field : payload_fields(where.link, config))
        for (const char* side : has_model ? Names{"_model", "_rtl"} : Names{"_rtl"}) {
            all.push_back({field.width > 1 ? GtkwSignal::As::hexadecimal : GtkwSignal::As::bits,
                           path + ranged(field.name + side, field.width)});
        }
    return all;
}

}   // namespace

std::vector<InsideSignal> signals_inside(const std::string& rtl_wave, const std::string& unit, int pipeline) {
    const std::string instance = "u_" + unit, place = fmt::format("gen_pipeline[{}]", pipeline);
    std::vector<std::string> scopes;
    std::vector<InsideSignal> found;
    FstVisitor visitor;
    visitor.open_scope = [&](const std::string& name) { scopes.push_back(name); };
    visitor.close_scope = [&] { scopes.pop_back(); };
    visitor.signal = [&](std::uint32_t number, const std::string& name, int width, bool is_parameter) {
        const auto at = std::find(scopes.begin(), scopes.end(), instance);
        if (is_parameter || at == scopes.end()) return;
        if (is_of_pipeline(unit) && std::find(scopes.begin(), at, place) == at) return;
        InsideSignal signal{number, "", "", width};
        for (auto scope = scopes.begin(); scope != scopes.end(); ++scope)
            (scope <= at ? signal.instance : signal.name) += *scope + ".";
        signal.name += name;
        found.push_back(std::move(signal));
    };
    read_fst(rtl_wave, visitor);
    return found;
}

std::uint64_t cycle_of(std::uint64_t time) { return (time + cycle_time - settled - 1) / cycle_time; }

std::string waveform(const Capture& capture, const Config& config, const std::string& rtl_wave) {
    FstWriter out;
    LinkSignals links(out, capture, config);
    std::map<std::uint32_t, FstWriter::Signal> own;   // by the number in the RTL's file
    FstVisitor visitor;
    visitor.open_scope = [&](const std::string& name) { out.open_scope(name); };
    visitor.close_scope = [&] { out.close_scope(); };
    visitor.signal = [&](std::uint32_t signal, const std::string& name, int width, bool) {
        if (const auto known = own.find(signal); known != own.end())
            out.add_alias(name, width, known->second);
        else
            own[signal] = out.add_bits(name, width);
    };
    std::uint64_t now = 0;
    visitor.change = [&](std::uint64_t time, std::uint32_t signal, std::string_view value) {
        if (time != now) {
            links.set_up_to(time);
            out.set_time(time);
            now = time;
        }
        out.set_bits(own.at(signal), value);
    };
    read_fst(rtl_wave, visitor);
    links.set_up_to(~0ull);
    return out.finish();
}

std::string waveform_view(const Capture& capture, const Config& config, const Divergence& divergence,
                          const std::string& rtl_wave, const std::string& file_name) {
    constexpr std::uint64_t cycles_shown_before = 12;
    const std::uint64_t from = divergence.cycle - std::min(divergence.cycle, cycles_shown_before);
    Gtkw view{
        file_name, divergence.cycle * cycle_time + settled, std::max(from, capture.first) * cycle_time, {}};
    view.groups.push_back({"time",
                           {{GtkwSignal::As::decimal, ranged("links.cycle", cycle_bits)},
                            {GtkwSignal::As::bits, "TOP.clk_i"}}});
    const std::string unit = divergence.unit.substr(0, divergence.unit.find('['));
    const auto at = [&](const Capture::CapturedLink& where) {
        return divergence.on == where.link &&
               (where.pipeline == divergence.pipeline || index(where.link) >= pipeline_links);
    };
    for (const Capture::CapturedLink& where : capture.links)
        if (at(where))
            view.groups.push_back({fmt::format("link {}{}", scope_of(where, config),
                                               capture.has_model ? ": model and RTL" : ""),
                                   signals_of_link(where, capture.has_model, config)});
    for (const Capture::CapturedLink& where : capture.links) {
        const LinkInfo& info = link_infos[index(where.link)];
        const bool near = (unit == info.from || unit == info.to) &&
                          (where.pipeline == divergence.pipeline || index(where.link) >= pipeline_links);
        if (near && !at(where))
            view.groups.push_back({fmt::format("link {}", scope_of(where, config)),
                                   signals_of_link(where, capture.has_model, config), false});
    }
    view.groups.push_back({"unit " + divergence.unit, signals_of(rtl_wave, unit, divergence.pipeline)});
    return gtkw_text(view);
}

std::vector<UnitSignal> unit_signals(const std::string& rtl_wave, const std::string& unit, int pipeline,
                                     std::uint64_t first, std::uint64_t last) {
    const std::vector<InsideSignal> inside = signals_inside(rtl_wave, unit, pipeline);
    std::map<std::uint32_t, std::vector<std::string>> values;   // by number
    for (const InsideSignal& signal : inside) values[signal.number].resize(last - first);
    FstVisitor visitor;
    visitor.change = [&](std::uint64_t time, std::uint32_t number, std::string_view digits) {
        const auto found = values.find(number);
        if (found == values.end()) return;
        for (std::uint64_t c = std::max(cycle_of(time), first); c < last; ++c)
            found->second[c - first] = hexadecimal(digits);
    };
    read_fst(rtl_wave, visitor);
    std::vector<UnitSignal> all;
    for (const InsideSignal& signal : inside) {
        const std::vector<std::string>& own = values.at(signal.number);
        if (std::adjacent_find(own.begin(), own.end(), std::not_equal_to<>()) != own.end())
            all.push_back({signal.name, own});
    }
    return all;
}

}   // namespace rayclock
