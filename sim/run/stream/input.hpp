#pragma once
// What a command traces in place of a camera's picture: a scene, and a stream of rays that meets it.
#include <memory>
#include <string>
#include <vector>

#include "sim/run/request/tracer.hpp"
#include "sim/run/stream/stream.hpp"

namespace rayclock {

/// Parses "clip" or "refuse". Throws UserError.
Outside parse_outside(const std::string& text);

/// A scene and its rays. One input serves jobs of several configurations, which refer to it.
class StreamInput {
public:
    /// Throws UserError if the scene is folded.
    StreamInput(Scene scene, std::unique_ptr<const Rays> rays, Outside outside);
    StreamInput(const StreamInput&) = delete;
    StreamInput& operator=(const StreamInput&) = delete;

    const Scene& scene() const { return scene_; }
    const Rays& rays() const { return *rays_; }
    Outside outside() const { return outside_; }
    /// Compiles the scene and puts the rays on its lattice. Throws UserError; see make_stream_job().
    StreamJob job(const Config& config, const Progress& progress = {}) const {
        return make_stream_job(scene_, *rays_, config, outside_, progress);
    }
    /// Returns a digest of every number of the rays and of `outside`, as 16 hexadecimal digits. Two inputs
    /// with equal digests and scenes have equal answers.
    std::string digest() const;

private:
    Scene scene_;
    std::unique_ptr<const Rays> rays_;
    Outside outside_;
};

/// Returns a sentence for each kind of change that the host made to the rays of a stream, such as clipping.
std::vector<std::string> stream_notes(const StreamJob& stream);

/// The answers to a stream, in the order of the rays.
struct StreamAnswers {
    std::vector<StreamHit> hits;
    std::vector<std::string> notes;   ///< stream_notes(); empty for the reference, which changes no ray
};
/// Returns every ray's answer without timing, in the order of the rays. The reference traces the rays and the
/// scene as given, in double precision; its t, u and v have the precision of float32. Model and RTL give
/// equal answers. Throws UserError, and Interrupted after Ctrl-C.
StreamAnswers trace_stream(const StreamInput& input, Tracer tracer, const Config& config, int threads = 0,
                           const Progress& progress = {});

}   // namespace rayclock
