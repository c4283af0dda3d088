#pragma once
// Commands with a stream of rays in place of a camera.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/app/options/options.hpp"
#include "sim/run/stream/input.hpp"

namespace rayclock {

/// The options of a stream.
struct StreamChoice {
    std::optional<std::string> rays, hits;
    std::string outside = "clip";
    bool any_hit = false;
};
/// Declares the options of a stream. `with_hits`: the command can write each ray's hit.
void stream_options(Parser& parser, StreamChoice& choice, bool with_hits);
/// Declares the options of a stream except --rays and --hits.
void treatment_options(Parser& parser, StreamChoice& choice);

/// The options of a camera's picture, and all other options of a command that have no meaning for a stream.
struct PictureOptions {
    const std::string& size;
    const Finish& finish;
    const ViewChoice& view;
    const FramesOptions& frames;
    const LimitsChoice& limits;
    /// An option of one command: whether it is given, and its name.
    struct Own {
        bool is_given;
        const char* name;
    };
    std::vector<Own> own{};
};
/// Returns the options of a command that draws no picture.
PictureOptions no_picture_options(std::vector<PictureOptions::Own> own);
/// Returns true if the command traces a stream of rays, and false if it traces the rays of a camera. Throws
/// UserError if an option of the other kind is given.
bool traces_stream(const StreamChoice& choice, const PictureOptions& picture);

/// The stream that the options choose: the configuration of the chip, and the scene with its rays.
struct StreamRequest {
    Config config;
    std::unique_ptr<const StreamInput> input;
};
/// Loads the rays and the scene, and makes the configuration. Prints notes on standard error. Throws
/// UserError.
StreamRequest stream_request(const std::string& scene, const ConfigChoice& config, const StreamChoice& choice,
                             const Progress& progress);
/// Loads the rays and the scene only, in the form of stream_primitives(). Throws UserError.
std::unique_ptr<const StreamInput> stream_input(const std::string& scene, const ConfigChoice& config,
                                                const StreamChoice& choice, const Progress& progress);
/// Throws UserError if the file of --hits could not be written later.
void check_hits(const StreamChoice& choice, const JsonOutput& json);
/// Returns the line of a command's text about the scene and the rays.
std::string stream_heading(const StreamJob& stream);

/// The input of a command with a stream.
struct StreamCommand {
    std::string scene, clock;
    ConfigChoice config;
    StreamChoice stream;
    DisturbanceOptions disturbance;
    bool no_judge = false;
    int threads = 0;
    JsonOutput json;
    /// For verify: the units whose timing may differ from the model's.
    std::optional<std::string> elastic{};
};
/// Simulates a stream on the model at each clock. Returns the exit code. Throws UserError.
int simulate_stream(const StreamCommand& command);
/// Runs model and RTL on a stream, in lockstep or elastic. Returns the exit code. Throws UserError.
int verify_stream(const StreamCommand& command);

}   // namespace rayclock
