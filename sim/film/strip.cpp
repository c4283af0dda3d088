#include "sim/film/strip.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/input.hpp"
#include "sim/film/read_back.hpp"
#include "sim/rtl/interrupt.hpp"
#include "sim/rtl/process.hpp"

namespace rayclock {

namespace fs = std::filesystem;

std::string frame_name(std::size_t f) { return fmt::format("frame_{:04}.png", f); }

std::string make_film(const std::string& folder, std::size_t count, double fps) {
    const fs::path film = fs::path(folder) / "film.png";
    std::error_code error;
    fs::remove(film, error);
    // The program takes all that are numbered on: those of an older, longer film go.
    for (std::size_t f = count; !error && fs::remove(fs::path(folder) / frame_name(f), error); ++f) {}
    if (error) throw UserError(film.string() + ": an older film cannot be removed (" + error.message() + ")");
    const fs::path program = find_program(film_program);
    if (program.empty())
        return fmt::format(
            "no film: the program {} is not installed (Debian's package {}); the frames lie in {}",
            film_program, film_program, printable(folder));
    // It numbers them by itself from the first name on. A delay is a fraction of two numbers of 16 bits.
    const auto thousandths = long(std::lround(1000 / fps));
    Process process({{program.string(), fs::absolute(film).string(), frame_name(0),
                      std::to_string(std::min(thousandths, 65'535l)), "1000", "-kc"},
                     folder,
                     fs::absolute(fs::path(folder) / "film.log"),
                     {}});
    while (!process.ended() && !interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (interrupted()) return "no film: interrupted";
    if (process.code() != 0 || !fs::exists(film, error))
        return fmt::format("no film: {} ended with {}; what it said is in {}/film.log", film_program,
                           process.code(), printable(folder));
    // The frames were read back when they were written; a film that does not show them is worth nothing.
    const std::string fault =
        film_fault(read_if_there(film), count, std::min(thousandths, 65'535l),
                   [&](std::size_t f) { return read_if_there(fs::path(folder) / frame_name(f)); });
    if (!fault.empty()) {
        fs::remove(film, error);
        return fmt::format("no film: {} made it wrongly: read back, {}", film_program, fault);
    }
    fs::remove(fs::path(folder) / "film.log", error);
    return fmt::format("film of {} frames, made by {}: {}/film.png", count, film_program, printable(folder));
}

}   // namespace rayclock
