#pragma once
// The host's writes into the chip's memory for a frame of a moving scene: docs/machine/motion.md.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// Returns the cycles of a chip's reset. The caches are emptied, and the counters take sixteen cycles more
/// (docs/machine/chip.md).
inline int reset_cycles(const Config& c) { return c.clear_cycles() + 16; }

/// Lines that differ from the memory's content, and the host's work to find them. Applied in order, uploads
/// give every frame the lines that it reads, whatever the image held before.
struct Upload {
    std::vector<std::uint32_t> lines;   ///< line numbers, rising
    std::vector<std::uint32_t> words;   ///< 16 words per line
    MemoryImage image;                  ///< of the frame, without its words
    std::uint32_t image_lines = 0;      ///< lines of the image; 0: no upload, the scene does not move
    /// The part is written while the chip draws the previous frame, which reads none of these lines.
    bool overlaps_previous_frame = false;
    /// The caches may hold lines that were written since the last reset, so the chip is reset.
    bool resets = false;
    bool is_whole = false;   ///< the host has rebuilt everything, not only the upper structure
    std::uint64_t nodes = 0, instances = 0;    ///< that the host has recomputed
    std::uint64_t refitted = 0, rebuilt = 0;   ///< trees of deforming meshes
    double cost = 0;      ///< of the worst of these: its surface-area cost over the cost when built
    double seconds = 0;   ///< of host time
};

/// Returns an image's data without its lines.
inline MemoryImage without_words(const MemoryImage& image) {
    MemoryImage shape;
    shape.lattice = image.lattice;
    shape.first_mesh_line = image.first_mesh_line;
    shape.first_surface_line = image.first_surface_line;
    shape.first_plane = image.first_plane;
    shape.first_plane_surface_line = image.first_plane_surface_line;
    shape.primitives = image.primitives;
    shape.listed_primitives = image.listed_primitives;
    shape.levels = image.levels;
    shape.report = image.report;
    return shape;
}

/// Adds all lines of the image from `first` on that differ from `held`, the earlier words of the same lines.
inline void take_differences(const MemoryImage& image, std::uint32_t first, std::uint32_t count,
                             const std::vector<std::uint32_t>& held, Upload& upload) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t* const line = image.line(first + i);
        const std::size_t at = 16 * std::size_t(i);
        if (at + 16 <= held.size() && std::equal(line, line + 16, &held[at])) continue;
        upload.lines.push_back(first + i);
        upload.words.insert(upload.words.end(), line, line + 16);
    }
}

/// Writes an upload into an image.
inline void apply(const Upload& upload, MemoryImage& image) {
    if (upload.image_lines == 0) return;
    std::vector<std::uint32_t> words = std::move(image.words);
    image = upload.image;
    words.resize(std::size_t(upload.image_lines) * 16);
    image.words = std::move(words);
    for (std::size_t i = 0; i < upload.lines.size(); ++i)
        std::copy_n(&upload.words[16 * i], 16, &image.words[16 * std::size_t(upload.lines[i])]);
}

/// Cycles before a frame in which the chip draws nothing.
struct UploadTiming {
    std::uint64_t lines = 0;    ///< written for the frame, at any time
    std::uint64_t cycles = 0;   ///< in which the chip waited for them
    std::uint64_t reset = 0;    ///< of the reset
};

/// Prepares frame `f` on a machine of the model or the RTL: performs the host's writes, and a reset if
/// necessary. Then it begins the writes of the next frame, if they overlap this one. `upload_of(f)` is a
/// frame's upload, null beyond the last. Returns the time taken.
template <class Machine, class UploadOf>
UploadTiming prepare_frame(Machine& machine, std::size_t f, const UploadOf& upload_of) {
    UploadTiming timing;
    const Upload& own = *upload_of(f);
    const std::uint64_t begin = machine.cycle();
    if (!own.overlaps_previous_frame || f == 0) machine.write(own.lines);
    machine.finish_writes();
    timing.lines = own.lines.size();
    timing.cycles = machine.cycle() - begin;
    if (own.resets) machine.reset();
    timing.reset = machine.cycle() - begin - timing.cycles;
    const Upload* next = upload_of(f + 1);
    if (next && next->overlaps_previous_frame) machine.write(next->lines);
    return timing;
}

}   // namespace rayclock
