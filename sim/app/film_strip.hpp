#pragma once
// What simulate, verify and render do with the frames of a film beside running them: pictures, the
// reference's error, and the report of all frames.
#include <memory>

#include "sim/files/folder.hpp"
#include "sim/run/film/film.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

/// What is known of the frames beside their runs.
struct FilmStrip {
    bool moves = false;
    double fps = 0;
    std::vector<double> times;        ///< seconds of the scene
    std::vector<FrameError> errors;   ///< of the model's pictures beside the reference's, if it was asked for
    std::string folder;               ///< of numbered pictures; empty: there are none
    std::shared_ptr<StagedFiles> staged;   ///< where they wait for the film
};

struct StripOptions {
    int threads = 0;
    std::string folder;
    bool compares = false;   ///< every frame with the reference's
};

/// Records all frames. Of a scene that moves, and has more frames than one, it writes the pictures, which
/// finish_film() publishes, and compares them.
FilmStrip record_film(Film& film, const StripOptions& options, const Progress& progress,
                      std::vector<FrameTrace>& traces);

/// Fails early (UserError) if the frames could not be written.
void check_film_folder(const std::string& folder, std::size_t frames);
/// The errors of all frames of a film, the last of which is `last`; of a single frame that alone.
std::vector<FrameError> all_errors(const FilmStrip& strip, const FrameError& last);
/// Joins the pictures, publishes all, and says so, unless `quiet`.
void finish_film(const FilmStrip& strip, bool quiet);

/// A row for each frame, then the least, mean and most; empty if nothing moves. At the first clock.
std::string film_table(const Config& config, const std::vector<ClockRun>& runs, const FilmStrip& strip,
                       const std::vector<FrameTrace>& traces);
/// The same for each clock; null if nothing moves.
nlohmann::ordered_json film_json(const Config& config, const std::vector<ClockRun>& runs,
                                 const FilmStrip& strip, const std::vector<FrameTrace>& traces);

}   // namespace rayclock
