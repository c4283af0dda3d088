// Finds the distinct units of all variants and synthesises those that the cache lacks.
#include "sim/silicon/area/synthesise_units.hpp"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/silicon/synth/yosys.hpp"

namespace rayclock::area {

namespace {

/// A unit of a variant. Units of the same shape share one result of Yosys.
struct Piece {
    std::size_t variant;
    std::string unit;
    std::string shape;   ///< empty until it is known
};

class Runner {
public:
    Runner(Areas& areas, results::Cache& cache, const Progress& progress, int threads)
        : areas_(areas), cache_(cache), progress_(progress), threads_(threads) {}

    void run(std::vector<Piece> pieces) {
        for_each(pieces, "looking at units", [&](Piece& piece) { find_shape(piece); });
        std::map<std::string, Piece> shapes;   // any one piece of each shape
        for (const Piece& piece : pieces)
            if (!piece.shape.empty()) shapes.emplace(piece.shape, piece);
        areas_.different = shapes.size();
        std::vector<Piece> missing;
        for (const auto& [shape, piece] : shapes)
            if (auto part = cache_.find("area", shape, synth::part_of))
                parts_[shape] = std::move(*part), ++areas_.known;
            else
                missing.push_back(piece);
        // Start the longest ones first, so that none runs alone at the end.
        std::stable_sort(missing.begin(), missing.end(),
                         [](const Piece& a, const Piece& b) { return weight(a) > weight(b); });
        for_each(missing, "synthesis", [&](Piece& piece) { count(piece); });
        for (const Piece& piece : pieces)
            if (const auto part = parts_.find(piece.shape); part != parts_.end())
                areas_.units[piece.variant][piece.unit] = part->second;
        areas_.partial = interrupted();
    }

private:
    static int weight(const Piece& piece) {
        return piece.unit == "shade" ? 2 : piece.unit == "tri" || piece.unit == "box";
    }

    template <class Do> void for_each(std::vector<Piece>& pieces, const char* what, Do look_at) {
        done_ = 0;
        parallel::for_each(pieces.size(), threads_, [&](std::size_t i) {
            if (interrupted()) return;
            look_at(pieces[i]);
            const std::lock_guard lock(mutex_);
            if (progress_) progress_(fmt::format("{}, {}", what, pieces[i].unit), ++done_, pieces.size());
        });
    }

    const Config& config(const Piece& piece) const { return areas_.variants[piece.variant].config; }

    void find_shape(Piece& piece) {
        const std::string with =
            fmt::format("script {} {}", results::hash_text(synth::synth_script()), synth::yosys_version());
        const std::string key = fmt::format("package {} rtl {} unit {} pipelines {} {}",
                                            results::hash_text(rc_package(config(piece))),
                                            synth::rtl_digest(), piece.unit, config(piece).pipelines, with);
        if (const auto shape = cache_.find(
                "shape", key, [](const nlohmann::ordered_json& text) { return text.get<std::string>(); })) {
            piece.shape = *shape;
            return;
        }
        const std::optional<std::string> shape = synth::shape_of(config(piece), piece.unit, cache_.folder());
        if (!shape) return;
        piece.shape = fmt::format("unit {} shape {} {}", piece.unit, *shape, with);
        cache_.keep("shape", key, piece.shape);
    }

    void count(const Piece& piece) {
        const std::optional<Part> part = synth::synthesize(config(piece), piece.unit, cache_.folder());
        if (!part) return;
        cache_.keep("area", piece.shape, synth::part_json(*part));
        const std::lock_guard lock(mutex_);
        parts_[piece.shape] = *part;
    }

    Areas& areas_;
    results::Cache& cache_;
    const Progress& progress_;
    int threads_;
    std::mutex mutex_;
    std::size_t done_ = 0;
    std::map<std::string, Part> parts_;
};

}   // namespace

Areas run(std::vector<Variant> variants, const std::vector<std::string>& only, int threads,
          results::Cache& cache, const Progress& progress) {
    if (synth::yosys_version().empty())
        throw UserError(
            "yosys is not installed, and areas come from it; 'rayclock doctor' tells what is missing");
    Areas areas;
    areas.variants = std::move(variants);
    areas.units.resize(areas.variants.size());
    std::vector<Piece> pieces;
    for (std::size_t v = 0; v < areas.variants.size(); ++v)
        for (const UnitRow& row : unit_rows())
            if (row.is_there(areas.variants[v].config) &&
                (only.empty() || std::find(only.begin(), only.end(), row.name) != only.end()))
                pieces.push_back({v, row.name, ""});
    Runner(areas, cache, progress, threads).run(std::move(pieces));
    return areas;
}

Count pipeline_count(const Areas& areas, std::size_t variant) {
    Count all;
    for (const UnitRow& row : unit_rows()) {
        const auto part = areas.units[variant].find(row.name);
        if (row.in_pipeline && part != areas.units[variant].end()) all += part->second.count;
    }
    return all;
}

Count chip_count(const Areas& areas, std::size_t variant) {
    Count all = std::uint64_t(areas.variants[variant].config.pipelines) * pipeline_count(areas, variant);
    for (const UnitRow& row : unit_rows()) {
        const auto part = areas.units[variant].find(row.name);
        if (!row.in_pipeline && part != areas.units[variant].end()) all += part->second.count;
    }
    return all;
}

}   // namespace rayclock::area
