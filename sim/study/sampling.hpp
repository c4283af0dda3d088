#pragma once
// The study of docs/guide/sampling.md: how often the intervals of samples contain the figures of whole
// frames, how wide they are, how large the bias is, and how much time samples save.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/base/progress.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock::sampling {

/// A frame of the study.
struct FrameSpec {
    std::string scene;
    FrameSize size;
    ConfigChoice config;
    int depth = 0;   ///< 0: camera rays only
};
/// Returns the twelve frames: different scenes, structures, memories and configurations.
std::vector<FrameSpec> usual_frames();

struct Study {
    std::vector<FrameSpec> frames;
    double share = 0.05;   ///< in all twelve frames the smallest sample exceeds it
    int seeds = 300;
    int khz = 66000;
    int threads = 0;
};

/// A figure of a frame over all seeds. Shares are relative to the figure of the whole frame.
struct Row {
    std::string key;
    double exact = 0, covered = 0, half_width = 0, bias = 0, deviation = 0;
};
/// A frame over all seeds.
struct FrameRows {
    FrameSpec spec;
    std::vector<Row> rows;                          ///< the figures that are not 0
    double measured = 0, replayed = 0;              ///< shares of the pixels
    double whole_seconds = 0, sample_seconds = 0;   ///< of processor time
    const Row& cycles() const { return rows.front(); }
};
std::vector<FrameRows> measure(const Study& study, const Progress& progress);

/// Returns the share of intervals that contain the cycles, over all frames and seeds.
double coverage(const std::vector<FrameRows>& frames);
/// Returns the tables as Markdown. `command` is the command that makes them.
std::string page(const std::vector<FrameRows>& frames, const Study& study, const std::string& command);
nlohmann::ordered_json rows_json(const std::vector<FrameRows>& frames);

}   // namespace rayclock::sampling
