#pragma once
// The frames of a moving scene, one after the other: the scene at its time, the chip's memory, and the host's
// writes (docs/machine/motion.md). A scene without motion is the same in every frame, and only the camera may
// turn.
#include <memory>
#include <optional>
#include <string>

#include "model/compile/levels/moving.hpp"
#include "model/compile/refit/flat.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

/// The options of the command line.
struct FramesOptions {
    int frames = 1;
    double pan = 0;              ///< degrees that the camera turns from frame to frame
    std::optional<double> fps;   ///< frames per second of the scene's time
    std::string time;            ///< "1.5" or "0:4": seconds of the scene
    std::string uploads = "between";
    /// The tree of a deforming mesh is refitted while its cost is at most this multiple of the cost at its
    /// last build. Above that it is rebuilt.
    double rebuild = usual_rebuild;
    bool is_given() const {
        const FramesOptions none;
        return frames != 1 || pan != 0 || fps || !time.empty() || uploads != none.uploads ||
               rebuild != none.rebuild;
    }
};

/// The times of the frames in seconds of the scene, and the frame rate.
struct FrameTimes {
    std::vector<double> times;
    double fps = 25;
    bool is_given = false;   ///< --fps or --time was given
};
constexpr double usual_fps = 25;
constexpr int max_frames = 1000;
/// Computes the times of the frames. Throws UserError if an option is wrong.
FrameTimes frame_times(const FramesOptions& options, bool moves);

/// Returns the camera of frame i: turned by `pan` i degrees about its up axis. The eye stays.
Camera panned(const Camera& camera, double pan, int i);

/// Produces the frames in order: call next(), then use the other functions.
class Film {
public:
    /// `view_is_given` means that the user chose the camera, which then does not move with the scene.
    /// `for_chip` means that frames are made for a chip and not only for the reference. Throws UserError.
    Film(Request request, const FramesOptions& options, bool view_is_given, FrameSize size,
         const Progress& progress = {}, bool for_chip = true);

    std::size_t frames() const { return times_.times.size(); }
    const FrameTimes& times() const { return times_; }
    bool moves() const { return moves_; }                    ///< the scene moves; --pan alone does not count
    bool is_still() const { return !moves_ && pan_ == 0; }   ///< all frames are equal

    /// Advances to the next frame: the scene, the memory, the registers.
    void next();
    /// Returns the job of the current frame. The job of the last frame with the uploads of all frames is
    /// enough to run all frames on a machine.
    const Job& job() const { return job_; }
    const Camera& camera() const { return *request_.scene.camera; }
    Upload take_upload() { return std::move(upload_); }
    /// Returns the request with the scene as it is in this frame.
    const Request& request();
    /// Records the frame's rays and adds its upload.
    RecordedFrame record(int threads, const Progress& progress);

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
    PlacedScene placed_;   ///< at the time of the current frame, if anything moves
    Camera first_camera_;
    std::unique_ptr<MovingLevels> levels_;
    std::unique_ptr<RefittedScene> flat_;
    Job job_;
    Upload upload_;
    std::size_t frame_ = 0;   ///< number of the next frame
};

}   // namespace rayclock
