#pragma once
// Commands with a stream of rays in place of a camera.
#include <optional>
#include <string>

#include "sim/app/options/options.hpp"

namespace rayclock {

/// The options of a stream.
struct StreamChoice {
    std::optional<std::string> rays, hits;
    std::string outside = "clip";
    bool any_hit = false;
    bool is_asked() const { return rays.has_value(); }
};
void stream_options(Parser& parser, StreamChoice& choice);
/// Throws UserError if a stream's option was given without a stream.
void check_stream_options(const StreamChoice& choice);
/// Throws UserError if `odd` names an option. The option has no meaning with a stream.
void refuse_with_rays(const char* odd);
/// Throws UserError if an option was given that has a meaning for pictures only.
void refuse_picture_options(const std::string& size, const Finish& finish, const ViewChoice& view,
                            const FramesOptions& frames, const LimitsChoice& limits,
                            const std::string& output);

/// A command's input, when it has a stream.
struct StreamCommand {
    std::string scene, clock;
    ConfigChoice config;
    StreamChoice stream;
    TrafficOptions traffic;
    bool no_judge = false;
    int threads = 0;
    JsonOutput json;
    std::optional<std::string> elastic{};   ///< of verify: the units whose timing is not the model's
};
/// Simulates a stream on the model at each clock. Returns the exit code. Throws UserError.
int simulate_stream(const StreamCommand& command);
/// Runs model and RTL on a stream, in lockstep or elastic. Returns the exit code. Throws UserError.
int verify_stream(const StreamCommand& command);

}   // namespace rayclock
