// Builds the HTML tables of the page of one frame.
#include "sim/view/page/tables.hpp"

#include <fmt/format.h>

#include "sim/files/table.hpp"
#include "sim/view/page/data.hpp"
#include "sim/view/page/html.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string share(std::uint64_t part, std::uint64_t all) {
    return all ? fmt::format("{:.1f} %", 100 * double(part) / double(all)) : "";
}
std::string plain(const nlohmann::ordered_json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

}   // namespace

std::string clock_section(const PageInput& input) {
    Rows rows;
    for (const auto& clock : input.report.at("clocks"))
        rows.push_back({fmt::format("{:g}", clock.at("mhz").get<double>()),
                        grouped(clock.at("cycles").get<std::uint64_t>()),
                        fmt::format("{:.2f}", clock.at("fps").get<double>()),
                        fmt::format("{:.2f}", clock.at("mrays_per_s").get<double>()),
                        fmt::format("{:.1f}", clock.at("bytes_per_ray").get<double>()),
                        fmt::format("{:.3f}", clock.at("dram_gb_per_s").get<double>()),
                        clock.at("bound").get<std::string>(),
                        fmt::format("{:.0f} %", 100 * clock.at("bound_reached").get<double>())});
    const auto& first = input.report.at("clocks")[0];
    return "<p id=\"bottleneck\">" + html::escaped(first.at("bottleneck").get<std::string>()) + ".</p>\n" +
           html::table(
               "Every clock that was asked for",
               {"MHz", "cycles", "frames/s", "Mrays/s", "bytes/ray", "memory GB/s", "bound", "reached"},
               rows);
}

std::string accounts_table(const PageInput& input) {
    Rows rows;
    for (const UnitAccount& a : unit_accounts(input.config, input.run)) {
        const std::uint64_t all = a.busy + a.starved + a.stalled;
        std::string causes;
        // Causes below 0.05 % are hidden. The JSON report has all of them.
        for (const auto* parts : {&a.busy_by, &a.starved_by, &a.stalled_by})
            for (const UnitAccount::Part& part : *parts)
                if (2000 * part.cycles >= all && part.cycles > 0)
                    causes += fmt::format("{}{}{} {}", causes.empty() ? "" : ", ",
                                          parts == &a.busy_by      ? ""
                                          : parts == &a.starved_by ? "starved by "
                                                                   : "stalled by ",
                                          part.cause, share(part.cycles, all));
        rows.push_back({a.unit, causes, fmt::format("{}", a.instances), grouped(a.count), share(a.busy, all),
                        share(a.starved, all), share(a.stalled, all)});
    }
    return html::table("What every unit did, in shares of all its cycles",
                       {"unit", "causes", "instances", "pieces of work", "busy", "starved", "stalled"}, rows,
                       2);
}

std::string kinds_table(const PageInput& input) {
    Rows rows;
    std::uint64_t all = 0;
    for (const PurposeCost& p : input.costs.purposes) all += p.cycles();
    for (std::size_t k = 0; k < input.costs.purposes.size(); ++k) {
        const PurposeCost& p = input.costs.purposes[k];
        if (p.rays == 0) continue;
        const double rays = double(p.rays);
        std::uint64_t hits = 0;
        for (const std::uint64_t h : p.hits) hits += h;
        rows.push_back({purpose_names[k], grouped(p.rays), fmt::format("{:.2f}", double(p.visits) / rays),
                        fmt::format("{:.2f}", double(p.tests) / rays), share(hits, hits + p.all_misses()),
                        fmt::format("{:.2f}", double(p.bytes) / rays),
                        fmt::format("{:.1f}", double(p.cycles()) / rays), share(p.cycles(), all)});
    }
    return html::table("Means of a ray, by what it is for. Its cycles include the shading of its hit",
                       {"rays that are for", "rays", "node visits", "primitive tests", "cache hits", "bytes",
                        "cycles", "share of all rays' cycles"},
                       rows);
}

std::string memory_table(const PageInput& input) {
    Rows rows;
    const auto cache = [&](Unit unit) {
        if (!is_there(unit, input.config)) return;
        const CacheAccount c = cache_account(input.run, unit);
        rows.push_back({unit_infos[index(unit)].name, grouped(c.accesses), grouped(c.hits), grouped(c.merged),
                        fmt::format("{:.2f} %", 100 * c.hit_rate())});
    };
    for (const Unit unit : cache_units) cache(unit);
    cache(Unit::l2);
    const MemoryStats& m = input.run.memory;
    std::string picture;
    if (input.config.is_board())
        picture += fmt::format(
            "<p>{} of these reads were the screen's. It showed {} pixels black, because their "
            "word came too late.</p>\n",
            grouped(m.scanned), grouped(m.underruns));
    else if (input.config.scan_out)
        picture += fmt::format(
            "<p>{} of these reads were the screen's, which waited for {} words of 64 bytes at most.</p>\n",
            grouped(m.scanned), m.backlog);
    if (input.config.pixel_writes)
        picture += fmt::format("<p>Finished pixels were written in {} words of 64 bytes.</p>\n",
                               grouped(m.pixel_writes));
    return html::table("Caches", {"cache", "look-ups", "hits", "joined a line on its way", "hit rate"},
                       rows) +
           fmt::format(
               "<p>The memory was read {} times, 64 bytes each; {} of these found their row open, {} "
               "another row; {} refreshes.</p>\n",
               grouped(m.reads), grouped(m.row_hits), grouped(m.row_conflicts), grouped(m.refreshes)) +
           picture;
}

std::string slowest_table(const PageInput& input) {
    Rows rows;
    for (const std::uint32_t i : slowest_pixels(input.costs, 100)) {
        const PixelCost& p = input.costs.pixels[i];
        rows.push_back({fmt::format("{}, {}", i % input.costs.width, i / input.costs.width),
                        cause_of(input, i), grouped(p.cycles), grouped(p.rays), grouped(p.visits),
                        grouped(p.tests), grouped(p.misses), grouped(p.bytes)});
    }
    return html::table("",
                       {"pixel", "why it differs", "cycles", "rays", "node visits", "primitive tests",
                        "cache misses", "bytes"},
                       rows, 2);
}

std::string error_table(const PageInput& input) {
    const auto& error = input.report.at("error");
    if (error.is_null()) return "<p>The frame was not compared with the reference.</p>\n";
    Rows rows;
    if (error.contains("causes"))
        for (const auto& [cause, pixels] : error.at("causes").items())
            rows.push_back({cause, grouped(pixels.get<std::uint64_t>()),
                            grouped(error.at("causes_other_primitive").at(cause).get<std::uint64_t>())});
    return fmt::format("<p>{} of {} pixels hold another primitive than the reference; PSNR {}.</p>\n",
                       grouped(error.at("pixels_other_primitive").get<std::uint64_t>()),
                       grouped(error.at("pixels").get<std::uint64_t>()),
                       error.at("psnr_db").is_null()
                           ? "infinite"
                           : fmt::format("{:.1f} dB", error.at("psnr_db").get<double>())) +
           (rows.empty() ? ""
                         : html::table("Pixels that differ, by cause",
                                       {"cause", "pixels", "that hold another primitive"}, rows));
}

std::string config_table(const PageInput& input) {
    Rows rows;
    for (const auto& [key, value] : input.report.at("config").items()) rows.push_back({key, plain(value)});
    return html::table("", {"parameter", "value"}, rows, 2);
}

std::string origin_table(const PageInput& input) {
    Rows rows;
    for (const auto& [what, text] : input.origin) rows.push_back({what, text});
    return html::table("How to repeat this report", {"what", ""}, rows, 2);
}

}   // namespace rayclock
