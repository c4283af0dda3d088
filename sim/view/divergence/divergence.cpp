// Writes the waveform and the page of a divergence.
#include "sim/view/divergence/divergence.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "sim/files/input.hpp"
#include "sim/files/output.hpp"
#include "sim/view/divergence/divergence_page.hpp"
#include "sim/view/divergence/waveform.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

constexpr const char *wave_name = "divergence.fst", *view_name = "divergence.gtkw",
                     *page_name = "divergence.html";

/// Registers start at random, and in another order in RTL that has waves: what hangs on them may differ.
std::string note_of(const Divergence& first, const Capture& capture) {
    if (!first.on || !capture.has_model || capture.differs_at == first.cycle) return {};
    if (!capture.differs_at)
        return "The second run, whose registers start with other values, did not diverge: something is used "
               "before it is set.";
    return fmt::format("The second run, whose registers start with other values, diverged in cycle {}.",
                       *capture.differs_at);
}

}   // namespace

void check_divergence_folder(const std::string& folder) {
    fs::path there = fs::absolute(folder);
    std::error_code error;
    while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
    for (const char* name : {wave_name, view_name, page_name}) check_writable((there / name).string());
}

DivergenceShow::DivergenceShow(const DivergedRun& d, const std::string& folder, const Progress& progress)
    : work_("rayclock-divergence"),
      rtl_wave_(work_.path() / "rtl.fst"),
      seen_(capture(d.job, d.frames, d.disturbance, d.seed, d.first.cycle, rtl_wave_, !d.is_elastic,
                    progress)) {
    if (interrupted()) throw Interrupted("interrupted while the waveform was made");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw UserError(folder + ": cannot be made (" + error.message() + ")");
    const auto path = [&](const char* name) { return (fs::path(folder) / name).lexically_normal().string(); };
    files_ = {path(wave_name), path(view_name), d.is_elastic ? "" : path(page_name), note_of(d.first, seen_)};
    const Config& config = d.job.config;
    write_bytes(files_.wave, waveform(seen_, config, rtl_wave_));
    write_bytes(files_.view, waveform_view(seen_, config, d.first, rtl_wave_, wave_name));
}

DivergenceFiles DivergenceShow::page(const DivergedRun& d) {
    if (!files_.page.empty())
        write_bytes(files_.page,
                    divergence_page(d, seen_, source_of(d.first, d.job.config), files_, rtl_wave_));
    return files_;
}

}   // namespace rayclock
