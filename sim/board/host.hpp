#pragma once
// The host's program for a board: loads a scene, runs frames, reads counters and pictures. The same code
// drives a real and a simulated board.
#include <array>
#include <cstdint>
#include <vector>

#include "model/base/progress.hpp"
#include "model/board/board_memory.hpp"
#include "model/compile/upload.hpp"
#include "model/core/frame.hpp"
#include "model/layout/memory_image.hpp"
#include "model/machine/units.hpp"
#include "sim/board/link.hpp"

namespace rayclock {

/// A frame as the board reports it.
struct BoardFrame {
    std::uint64_t cycles = 0;           ///< of the chip
    std::uint64_t written_cycles = 0;   ///< until the last pixel is in memory
    Accounts accounts;                  ///< of all units except the memory
    std::uint32_t underruns = 0;        ///< pixels that came too late for the screen, since the board's reset
    std::vector<std::array<std::uint8_t, 3>> pixels;   ///< [y * width + x]: red, green, blue
};

/// A board at the other end of a link. All functions throw the exceptions of BoardLink, and UserError
/// if the board has another configuration or memory than expected, or does not finish in time.
class BoardHost {
public:
    /// Says hello. Throws UserError if the bitstream was made from another configuration. Resets the chip.
    BoardHost(BoardLink& link, const Config& config, const SdramPart& part);

    /// Writes the memory image. `done` counts lines that the board has; a call with the same arguments
    /// continues after LinkLost.
    void load(const MemoryImage& image, std::uint64_t& done, const Progress& progress = {});
    /// Writes the lines of an upload, and resets the chip if its caches may hold older ones.
    void update(const Upload& upload);
    /// Draws a frame into the picture that is not shown, reads counters and pixels, and shows the picture.
    /// `most`: the longest time from the command to the last pixel in memory.
    BoardFrame run(const Frame& frame, LinkTime most, const Progress& progress = {});

private:
    void reset();
    void check_capacity(std::uint64_t lines) const;
    /// Reads the register `status` until this bit is 1. `event` ends the sentence of the UserError.
    void wait_for(std::uint32_t bit, LinkTime most, const char* event);
    std::uint64_t read_counter(std::uint32_t address);
    void read_accounts(Accounts& accounts);

    BoardLink& link_;
    Config config_;
    SdramPart part_;
    std::uint32_t drawn_ = 0;   ///< picture 0 or 1
};

}   // namespace rayclock
