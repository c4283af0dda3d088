// Running the film program, and checking the film that it made.
#include "sim/run/film/make_film.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/process.hpp"
#include "sim/run/film/read_back.hpp"

namespace rayclock {

namespace fs = std::filesystem;

std::string frame_name(std::size_t f) { return fmt::format("frame_{:04}.png", f); }

namespace {

/// Runs the program, which makes film.png in a folder of frames. Throws UserError if it fails.
void run_film_program(const fs::path& program, const fs::path& folder, long thousandths) {
    // It finds the following frames by their numbers, starting at the first name.
    const fs::path log = folder / "film.log";
    Process process(
        {{program.string(), "film.png", frame_name(0), std::to_string(thousandths), "1000", "-kc"},
         folder,
         log,
         folder});
    const int code = process.wait("interrupted: the film and its frames are not written");
    const std::string said = read_if_there(log);
    std::error_code ignored;
    fs::remove(log, ignored);
    if (code != 0)
        throw UserError(fmt::format("film.png: {} has failed: {}", film_program, complaint_of(said)));
}

}   // namespace

std::string make_film(StagedFiles& staged, const std::string& folder, std::size_t count, double fps) {
    // The program takes all consecutive numbers, so remove the frames of an older, longer film.
    std::vector<std::string> outdated;
    std::error_code error;
    for (std::size_t f = count; fs::exists(fs::path(folder) / frame_name(f), error); ++f)
        outdated.push_back(frame_name(f));
    const fs::path program = find_program(film_program);
    if (program.empty()) {
        outdated.emplace_back("film.png");   // the old film shows other frames
        staged.publish(outdated);
        return fmt::format(
            "no film: the program {} is not installed (Debian's package {}); the frames are in {}",
            film_program, film_program, printable(folder));
    }
    // A delay is a fraction of two 16-bit numbers.
    const long thousandths = std::min(long(std::lround(1000 / fps)), 65'535l);
    run_film_program(program, staged.stage(), thousandths);
    // The frames were read back when they were written. Check the film against them too: on a full disk the
    // program reports no error.
    const std::string fault =
        film_fault(read_if_there(staged.stage() / "film.png"), count, thousandths,
                   [&](std::size_t f) { return read_if_there(staged.stage() / frame_name(f)); });
    if (!fault.empty())
        throw UserError(fmt::format("{}/film.png: {} wrote it incorrectly (is the disk full?): read back, {}",
                                    printable(folder), film_program, fault));
    staged.publish(outdated);
    return fmt::format("film of {} frames, made by {}: {}/film.png", count, film_program, printable(folder));
}

}   // namespace rayclock
