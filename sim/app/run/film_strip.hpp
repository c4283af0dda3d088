#pragma once
// Handles the frames of a film for simulate, verify and render, apart from running them: pictures, errors
// against the reference, and the report of all frames.
#include <memory>

#include "sim/files/folder.hpp"
#include "sim/run/film/film.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

/// Data about the frames of a film, apart from their runs.
struct FilmStrip {
    bool moves = false;
    double fps = 0;
    std::vector<double> times;        ///< seconds of the scene's time
    std::vector<FrameError> errors;   ///< errors of the model's pictures against the reference, if requested
    std::string folder;               ///< folder of numbered pictures; empty if there are none
    std::shared_ptr<StagedFiles> staged;   ///< holds the pictures until the film is finished
};

/// Options of record_film().
struct StripOptions {
    int threads = 0;
    std::string folder{};
    bool compares = false;   ///< compare every frame with the reference
};

/// Records all frames. If the scene moves and has several frames, also writes their pictures, which
/// finish_film() publishes, and compares them.
FilmStrip record_film(Film& film, const StripOptions& options, const Progress& progress,
                      std::vector<RecordedFrame>& traces);

/// Throws UserError if the frames could not be written, so that a command can fail early.
void check_film_folder(const std::string& folder, std::size_t frames);
/// Returns the errors of all frames of a film; the last is `last`. Returns only `last` for a
/// single frame.
std::vector<FrameError> all_errors(const FilmStrip& strip, const FrameError& last);
/// Joins the pictures, publishes all files, and prints a message unless `quiet`.
void finish_film(const FilmStrip& strip, bool quiet);

/// Returns a row for each frame, then least, mean and most, at the first clock. Empty if nothing moves.
std::string film_table(const Config& config, const std::vector<FramesAtClock>& runs, const FilmStrip& strip,
                       const std::vector<RecordedFrame>& traces);
/// Returns the same for each clock; null if nothing moves.
nlohmann::ordered_json film_json(const Config& config, const std::vector<FramesAtClock>& runs,
                                 const FilmStrip& strip, const std::vector<RecordedFrame>& traces);

}   // namespace rayclock
