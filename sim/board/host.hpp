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

/// The cost of a frame as the board reports it.
struct BoardTiming {
    std::uint64_t cycles = 0;           ///< of the chip
    std::uint64_t written_cycles = 0;   ///< until the last pixel is in memory
    std::uint32_t underruns = 0;        ///< pixels that came too late for the screen, since the board's reset
};

/// A picture in the board's memory.
struct BoardPicture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 3>> pixels;   ///< [y * width + x]: red, green, blue
};

/// A frame with its counters and its picture.
struct BoardFrame : BoardTiming {
    Accounts accounts;   ///< of all units except the memory
    std::vector<std::array<std::uint8_t, 3>> pixels;
};

/// A board at the other end of a link. The board itself holds the scene, the frame's registers and the places
/// of its pictures, so a later program can continue where another one ended. All functions throw the
/// exceptions of BoardLink, and UserError if the board has another configuration or memory than expected, or
/// does not finish in time. Times are those of a real board; LinkSettings::slower stretches them.
class BoardHost {
public:
    /// Says hello. Throws UserError if the bitstream was made from another configuration. Writes nothing.
    BoardHost(BoardLink& link, const Config& config, const SdramPart& part);

    /// Resets the chip, so that its caches are empty, and writes the memory image. `done` counts lines that
    /// the board has; a call with the same arguments continues after LinkLost.
    void load(const MemoryImage& image, std::uint64_t& done, const Progress& progress = {});
    /// Writes the lines of an upload, and resets the chip if its caches may hold older ones.
    void update(const Upload& upload);
    /// Writes the registers of the next frame.
    void set_frame(const Frame& frame);
    /// Resets the chip, so that its caches are empty. The frame's registers keep their values.
    void reset();
    /// Draws the frame of the registers into the picture that is not shown, and then shows it. `most`: the
    /// longest time from the command to the last pixel in memory. Throws UserError if no frame was loaded.
    BoardTiming draw(LinkTime most);

    /// The results of the last frame. accounts(), picture() and timing() throw UserError if none was drawn
    /// since the chip's last reset.
    Accounts accounts();
    BoardPicture picture(const Progress& progress = {});
    /// The cost of the last frame.
    BoardTiming timing();
    /// Waits for this time. Then returns the pixels that came too late for the screen since the board's
    /// reset.
    std::uint32_t underruns(LinkTime after);

    /// set_frame(), draw(), accounts() and picture().
    BoardFrame run(const Frame& frame, LinkTime most, const Progress& progress = {});
    /// Reads lines of memory. Throws UserError if the board does not have them.
    std::vector<MemoryLine> read_lines(std::uint64_t first, std::uint64_t count,
                                       const Progress& progress = {});

private:
    void check_capacity(std::uint64_t lines) const;
    void check_drawn();
    /// Reads the register `status` until this bit is 1. `event` ends the sentence of the UserError.
    void wait_for(std::uint32_t bit, LinkTime most, const char* event);
    std::uint64_t read_counter(std::uint32_t address);

    BoardLink& link_;
    Config config_;
    SdramPart part_;
};

}   // namespace rayclock
