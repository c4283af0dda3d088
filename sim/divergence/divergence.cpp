#include "sim/divergence/divergence.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/divergence/page.hpp"
#include "sim/divergence/waveform.hpp"
#include "sim/files/input.hpp"
#include "sim/files/output.hpp"
#include "sim/rtl/cache.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

constexpr const char *wave_name = "divergence.fst", *view_name = "divergence.gtkw",
                     *page_name = "divergence.html";

/// Registers start at random, and in another order in RTL that has waves: what hangs on them may differ.
std::string note_of(const Divergence& first, const Capture& capture) {
    if (!first.on || capture.differs_at == first.cycle) return {};
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

DivergenceFiles show_divergence(const Diverged& d, const std::string& folder, const Progress& progress) {
    const WorkFolder work(fs::temp_directory_path() / "rayclock-divergence");
    const std::string rtl_wave = work.path() / "rtl.fst";
    const Config& config = d.job.config;
    const Capture seen = capture(d.job, d.frames, d.traffic, d.seed, d.first.cycle, rtl_wave, progress);
    if (interrupted()) throw std::runtime_error("interrupted while the waveform was made");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw UserError(folder + ": cannot be made (" + error.message() + ")");
    const auto path = [&](const char* name) { return (fs::path(folder) / name).lexically_normal().string(); };
    DivergenceFiles files{path(wave_name), path(view_name), path(page_name), note_of(d.first, seen)};
    write_bytes(files.wave, waveform(seen, config, rtl_wave));
    write_bytes(files.view, waveform_view(seen, config, d.first, rtl_wave, wave_name));
    write_bytes(files.page, divergence_page(d, seen, source_of(d.first), files, rtl_wave));
    return files;
}

}   // namespace rayclock
