#pragma once
// The frames of a scene that moves, one after the other: the scene at its time, the chip's memory, what the
// host writes (docs/motion.md). A scene that stands still is the same for every frame, and only the camera
// turns.
#include <memory>
#include <optional>
#include <string>

#include "model/compile/levels/moving.hpp"
#include "model/compile/refit/flat.hpp"
#include "sim/run/engine/engine.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

/// What was asked for.
struct FramesOptions {
    int frames = 1;
    double pan = 0;              ///< degrees that the camera turns from frame to frame
    std::optional<double> fps;   ///< frames in a second of the scene's time
    std::string time;            ///< "1.5" or "0:4": seconds of the scene
    std::string uploads = "between";
    /// The tree of a mesh that deforms is built anew above so many times the cost that it had when it was
    /// built; until then it is refitted.
    double rebuild = usual_rebuild;
};

/// The times of the frames, seconds of the scene, and how long each is to be seen. Throws UserError.
struct FrameTimes {
    std::vector<double> times;
    double fps = 25;
    bool is_asked = false;   ///< --fps or --time was given
};
constexpr double usual_fps = 25;
constexpr int most_frames = 1000;
FrameTimes frame_times(const FramesOptions& options, bool moves);

/// The camera of frame i: turned by `pan` i degrees about its up axis. The eye stays.
Camera panned(const Camera& camera, double pan, int i);

class Film {
public:
    /// `view_is_asked`: the camera was chosen by hand, and does not move with the scene. `for_chip`: frames
    /// are made for a chip, and not for the reference alone. Throws UserError.
    Film(Request request, const FramesOptions& options, bool view_is_asked, FrameSize size,
         const Progress& progress = {}, bool for_chip = true);

    std::size_t frames() const { return times_.times.size(); }
    const FrameTimes& times() const { return times_; }
    bool moves() const { return moves_; }                    ///< anything but the camera by --pan
    bool is_still() const { return !moves_ && pan_ == 0; }   ///< all frames are alike

    /// Makes the next frame the one at hand: its place in time, the memory, the registers.
    void next();
    /// Of the frame at hand. The job of the last frame, with the uploads of all, gives a machine all frames.
    const Job& job() const { return job_; }
    const Camera& camera() const { return *request_.scene.camera; }
    Upload take_upload() { return std::move(upload_); }
    /// With the scene as it is in this frame.
    const Request& request();
    /// Its rays, with the upload.
    FrameTrace record(int threads, const Progress& progress);

private:
    void pose_at(std::size_t f);
    void prepare_levels();
    void prepare_flat();
    void next_flat();
    void next_whole();
    void set_registers();
    Camera camera_of(std::size_t f, const std::optional<Camera>& moving) const;

    Request request_;
    FrameTimes times_;
    double pan_;
    FrameSize size_;
    Progress progress_;
    bool for_chip_;
    double rebuild_;
    bool moves_ = false, is_double_ = false, camera_moves_ = false, is_stale_ = false;
    PlacedScene placed_;   ///< at the time of the frame at hand, if anything moves
    Camera first_camera_;
    std::unique_ptr<MovingLevels> levels_;
    std::unique_ptr<RefittedScene> flat_;
    Job job_;
    Upload upload_;
    std::size_t frame_ = 0;   ///< the next
};

}   // namespace rayclock
