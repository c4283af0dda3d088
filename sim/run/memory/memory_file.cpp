// The keys of a memory file, their ranges, and the rules between them.
#include "sim/run/memory/memory_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "sim/files/input.hpp"
#include "sim/files/json_value.hpp"
#include "sim/files/text.hpp"

namespace rayclock {

namespace {

/// A key of the file. Times are nanoseconds in the file and integer picoseconds in DramPart.
struct Field {
    const char* key;
    int DramPart::*member;
    int lo, hi;   // in units of the file: counts, or nanoseconds
    bool power_of_two = false;
    bool optional = false;   // if the key is missing, DramPart's initial value holds

    bool is_time() const { return std::string_view(key).ends_with("_ns"); }
};

constexpr Field fields[]{{"bus_bits", &DramPart::bus_bits, 8, 1024, true},
                         {"transfers_per_clock", &DramPart::transfers, 1, 8, true},
                         {"burst_length", &DramPart::burst_length, 1, 64, true},
                         {"banks", &DramPart::banks, 1, 32},
                         {"bank_groups", &DramPart::bank_groups, 1, 8, false, true},
                         {"rows", &DramPart::rows, 1, 1 << 20},
                         {"columns", &DramPart::columns, 1, 1 << 16},
                         {"tck_ns", &DramPart::tck, 0, 1000},
                         {"cl_clocks", &DramPart::cl, 1, 200},
                         {"trcd_ns", &DramPart::trcd, 0, 10'000},
                         {"trp_ns", &DramPart::trp, 0, 10'000},
                         {"tras_ns", &DramPart::tras, 0, 10'000},
                         {"trc_ns", &DramPart::trc, 0, 10'000},
                         {"trrd_ns", &DramPart::trrd, 0, 10'000},
                         {"trrd_l_ns", &DramPart::trrd_l, 0, 10'000, false, true},
                         {"tfaw_ns", &DramPart::tfaw, 0, 10'000, false, true},
                         {"trtp_ns", &DramPart::trtp, 0, 10'000},
                         {"tccd_ns", &DramPart::tccd, 0, 10'000},
                         {"tccd_l_ns", &DramPart::tccd_l, 0, 10'000, false, true},
                         {"cwl_clocks", &DramPart::cwl, 0, 200, false, true},
                         {"twr_ns", &DramPart::twr, 0, 10'000, false, true},
                         {"twtr_ns", &DramPart::twtr, 0, 10'000, false, true},
                         {"trefi_ns", &DramPart::trefi, 1'000, 1'000'000},
                         {"trfc_ns", &DramPart::trfc, 0, 100'000},
                         {"request_ns", &DramPart::request_ps, 0, 10'000},
                         {"answer_ns", &DramPart::answer_ps, 0, 10'000},
                         {"queue", &DramPart::queue, 1, 64, false, true},
                         {"age_cap", &DramPart::age_cap, 0, 1'000, false, true}};
constexpr int least_tck = 100;   // picoseconds

/// Converts picoseconds to nanoseconds without trailing zeros: "13.75".
std::string nanoseconds(std::int64_t ps) { return fmt::format("{}", double(ps) / 1000); }

/// Reads one object.
class Reader {
public:
    Reader(const Json& object, std::string stem, std::function<SourcePosition(const std::string& key)> place)
        : object_(object), stem_(std::move(stem)), place_(std::move(place)) {}

    DramPart read() {
        if (!object_.is_object()) place_({}).refuse("a memory is a JSON object");
        check_keys();
        DramPart part;
        const bool like = object_.contains("like");
        if (like) part = named(text("like"));
        part.name = printable(object_.contains("name") ? text("name") : stem_, 80);
        if (part.name.empty()) part.name = "memory";
        part.description = object_.contains("description") ? text("description") : part.name;
        part.source = object_.contains("source") ? text("source") : "not stated";
        for (const Field& f : fields)
            if (object_.contains(f.key))
                part.*f.member = f.is_time() ? time(f) : count(f);
            else if (!like && !f.optional)
                place_({}).refuse(fmt::format(
                    "{} is missing; a memory states its organisation and every gate, or names one to start "
                    "from under \"like\"",
                    f.key));
        check_rules(part);
        return part;
    }

private:
    void check_keys() const {
        std::vector<std::string> known{"like", "name", "description", "source"};
        for (const Field& f : fields) known.emplace_back(f.key);
        for (const auto& [key, ignored] : object_.items())
            if (std::find(known.begin(), known.end(), key) == known.end())
                place_(key).refuse("a memory has no key " + shown(key) + meant(key, known));
    }
    /// Suggests the nearest key. For a word without its unit, suggests the key with the unit.
    static std::string meant(const std::string& key, const std::vector<std::string>& known) {
        for (const Field& f : fields)
            if (std::string_view(f.key).starts_with(key + "_"))
                return fmt::format("; did you mean '{}'?", f.key);
        return did_you_mean(key, known);
    }
    std::string text(const char* key) const {
        const Json& value = object_.at(key);
        if (!value.is_string())
            place_(key).refuse(fmt::format("{} must be a string, not {}", key, dump(key)));
        return printable(value.get<std::string>(), 1000);
    }
    DramPart named(const std::string& name) const {
        try {
            return dram_part(name);
        } catch (const UserError& e) {
            place_("like").refuse(e.what());
        }
    }
    std::string dump(const std::string& key) const {
        return printable(object_.at(key).dump(-1, ' ', true, Json::error_handler_t::replace), 60);
    }
    int count(const Field& f) const {
        const Json& value = object_.at(f.key);
        if (!value.is_number_integer() || value < f.lo || value > f.hi ||
            (f.power_of_two && !std::has_single_bit(value.get<unsigned>())))
            place_(f.key).refuse(fmt::format("{} must be a {} from {} to {}, not {}", f.key,
                                             f.power_of_two ? "power of two" : "whole number", f.lo, f.hi,
                                             dump(f.key)));
        return value.get<int>();
    }
    int time(const Field& f) const {
        const Json& value = object_.at(f.key);
        const double ns = value.is_number() ? value.get<double>() : -1;
        const int least = f.member == &DramPart::tck ? least_tck : f.lo * 1000;
        if (!(ns * 1000 >= least && ns <= f.hi))
            place_(f.key).refuse(fmt::format("{} must be a time from {} to {} nanoseconds, not {}", f.key,
                                             nanoseconds(least), f.hi, dump(f.key)));
        const double ps = std::round(ns * 1000);
        if (std::abs(ps - ns * 1000) > 1e-3)
            place_(f.key).refuse(
                fmt::format("{} must be a whole number of picoseconds, not {} ns", f.key, dump(f.key)));
        return int(ps);
    }

    /// Checks the rules that concern several values.
    void check_rules(const DramPart& p) const {
        const auto demand = [&](bool holds, const char* key, const std::string& sentence) {
            if (!holds) place_(object_.contains(key) ? key : "").refuse(sentence);
        };
        demand(p.burst_length % p.transfers == 0, "burst_length",
               fmt::format("burst_length must be a multiple of transfers_per_clock, {}, not {}", p.transfers,
                           p.burst_length));
        const std::int64_t row_bits = std::int64_t(p.columns) * p.bus_bits;
        demand(row_bits % (8 * line_bytes) == 0, "columns",
               fmt::format("columns * bus_bits must be a multiple of 512, since a row holds words of 64 "
                           "bytes, and is {}",
                           row_bits));
        demand(p.banks % p.bank_groups == 0, "bank_groups",
               fmt::format("bank_groups must divide banks, {}, not {}", p.banks, p.bank_groups));
        demand(p.trc >= p.tras, "trc_ns",
               fmt::format("trc_ns must be at least tras_ns, {}, not {}", nanoseconds(p.tras),
                           nanoseconds(p.trc)));
        demand(p.trefi >= longest_pause_ps(p), "trefi_ns",
               fmt::format("trefi_ns must be at least {}, the longest time that a read with a refresh in "
                           "front of it takes, not {}",
                           nanoseconds(longest_pause_ps(p)), nanoseconds(p.trefi)));
    }

    const Json& object_;
    std::string stem_;
    std::function<SourcePosition(const std::string&)> place_;
};

/// Returns the line of a key of the outermost object, counted from 1. Returns 0 if it is not found.
std::uint64_t line_of(std::string_view text, const std::string& key) {
    const std::string quoted = '"' + key + '"';
    for (std::size_t at = text.find(quoted); !key.empty() && at != text.npos;
         at = text.find(quoted, at + 1)) {
        const std::size_t next = text.find_first_not_of(" \t\r\n", at + quoted.size());
        if (next != text.npos && text[next] == ':')
            return 1 + std::uint64_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
    }
    return 0;
}

}   // namespace

bool is_memory_file(std::string_view value) { return value.find_first_of("./\\") != value.npos; }

DramPart parse_memory(const std::string& path, std::string_view text) {
    const Json json = parse_json(path, text);
    return Reader(json, std::filesystem::path(path).stem().string(),
                  [&](const std::string& key) {
                      return SourcePosition{path, line_of(text, key)};
                  })
        .read();
}

DramPart inner_memory(const std::string& path, const nlohmann::json& object) {
    return Reader(object, "own", [&](const std::string&) { return SourcePosition{path + ": dram"}; }).read();
}

void set_value(Config& config, const std::string& key, const std::string& value, const std::string& where,
               const std::string& folder) {
    if (key != "dram" || !is_memory_file(value)) {
        set_parameter(config, key, value, where);
        return;
    }
    constexpr std::uint64_t max_bytes = 1 << 20;
    const std::filesystem::path path = std::filesystem::path(folder) / value;
    config.own_dram =
        std::make_shared<const DramPart>(parse_memory(path.string(), read_file(path, where, max_bytes)));
}

nlohmann::ordered_json memory_file_json(const DramPart& part) {
    nlohmann::ordered_json json{
        {"name", part.name}, {"description", part.description}, {"source", part.source}};
    for (const Field& f : fields)
        json[f.key] = f.is_time() ? nlohmann::ordered_json(part.*f.member / 1000.0)
                                  : nlohmann::ordered_json(part.*f.member);
    return json;
}

std::string own_memory_text(const Config& config) {
    return config.own_dram ? memory_file_json(*config.own_dram).dump() : std::string{};
}

}   // namespace rayclock
