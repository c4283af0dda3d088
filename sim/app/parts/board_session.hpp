#pragma once
// What the actions of `rayclock board` share: their options, and the board that they use.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/app/options/options.hpp"
#include "sim/board/host.hpp"
#include "sim/board/port.hpp"
#include "sim/board/simulated_board.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

/// The value of --port for a board that is simulated in this process.
constexpr const char* simulated_port = "simulated";

struct BoardOptions {
    std::string action, scene, size = "64x48", clock = "75", port = simulated_port, sdram = "as4c32m16sb";
    std::optional<int> patience;
    ConfigChoice config{"ulx3s-board", {}};
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    bool dark = false;
    std::optional<std::string> lines;
    std::uint64_t cycles = 0;
    std::string output;
    JsonOutput json;

    bool is_simulated() const { return port == simulated_port; }
};

/// Gives a configuration the board's SDRAM, and returns the clock in kHz. Throws UserError if the
/// configuration is not a board's, or if the board cannot have the clock.
int settle_board(const BoardOptions& o, Config& config);
/// The frames of a scene that a command runs on a board. The port is open; none for a simulated board.
struct BoardRequest {
    FrameSize size;
    std::unique_ptr<Port> port;
    Request request;
    int khz = 0;
};
/// Throws UserError for an option that the board cannot follow.
BoardRequest board_request(const BoardOptions& o, const Progress& progress);
/// Opens the port; none for a simulated board. Throws UserError.
std::unique_ptr<Port> open_port(const BoardOptions& o);
/// Returns the board under Verilator. Builds the RTL if necessary. Throws UserError.
std::unique_ptr<SimulatedBoard> simulate_board(const BoardOptions& o, const Config& config, int khz);

/// A board whose identity was compared with the options. Ctrl-C ends every wait for it.
class BoardSession {
public:
    /// Says hello to the board at the port, or simulates one if `port` is null. Throws UserError.
    BoardSession(const BoardOptions& o, const Config& config, int khz, std::unique_ptr<Port> port);
    ~BoardSession();

    BoardHost& host() { return *host_; }
    SimulatedBoard* simulated() { return simulated_.get(); }   ///< null at a port

private:
    std::unique_ptr<Port> port_;
    std::unique_ptr<SimulatedBoard> simulated_;
    std::unique_ptr<Channel> channel_;
    std::unique_ptr<BoardLink> link_;
    std::unique_ptr<BoardHost> host_;
};

/// Red, green and blue of a pixel, as in a PNG file.
using PixelBytes = std::array<std::uint8_t, 3>;
Picture picture_of(FrameSize size, const std::vector<PixelBytes>& bytes);
/// Throws UserError unless a PNG file could be written to `path` later.
void check_png(const std::string& path);

/// Returns the sentences of everything on a simulated board that violates a specification.
std::vector<std::string> memory_faults(const SimulatedBoard& board);
std::vector<std::string> screen_faults(const SimulatedBoard& board);

/// Draws frames on the board and on the model, and compares them. Returns the exit code.
int check_frames(const BoardOptions& o);
/// Simulates a board behind a pseudo-terminal until Ctrl-C. Returns the exit code.
int serve_board(const BoardOptions& o);

}   // namespace rayclock
