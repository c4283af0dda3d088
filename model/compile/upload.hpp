#pragma once
// What the host writes into the memory of a chip for a frame of a scene that moves: docs/motion.md.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/layout/memory_image.hpp"

namespace rayclock {

/// Cycles that a reset of the chip takes: its caches are emptied, and in sixteen more it clears its counters
/// (docs/chip.md).
inline int reset_cycles(const Config& c) { return c.clear_cycles() + 16; }

/// Lines that differ from what the memory holds, and what the host did to know them. Applied in their order,
/// uploads give every frame the lines that it reads, whatever the image held before.
struct Upload {
    std::vector<std::uint32_t> lines;   ///< their numbers, rising
    std::vector<std::uint32_t> words;   ///< 16 for each of them
    MemoryImage image;                  ///< of the frame, but that its words are elsewhere
    std::uint32_t image_lines = 0;      ///< of it; 0: no upload at all, the scene stands still
    bool beside = false;   ///< written while the chip draws the frame before, which reads none of these lines
    bool resets = false;   ///< the caches may hold lines that were written since the last reset: the chip is
                           ///< reset
    bool is_whole = false;   ///< the host has made everything anew, and not the upper structure alone
    std::uint64_t nodes = 0, instances = 0;    ///< that the host has made anew
    std::uint64_t refitted = 0, rebuilt = 0;   ///< trees of meshes that deform
    double cost = 0;      ///< of the worst of them: its surface-area cost over that of when it was built
    double seconds = 0;   ///< that it took the host
};

/// What an upload says of an image beside its lines.
inline MemoryImage without_words(const MemoryImage& image) {
    MemoryImage shape;
    shape.lattice = image.lattice;
    shape.meshes = image.meshes;
    shape.surfaces = image.surfaces;
    shape.primitives = image.primitives;
    shape.listed = image.listed;
    shape.levels = image.levels;
    shape.report = image.report;
    return shape;
}

/// All lines of the image from `first` on that are not in `held`, which are so many words of before.
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

/// Writes what an upload holds into an image.
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
    std::uint64_t lines = 0;    ///< written for the frame, whenever
    std::uint64_t cycles = 0;   ///< in which the chip waited for them
    std::uint64_t reset = 0;    ///< of the reset
};

/// What must happen before frame `f`: the host's writes, and a reset, on a machine of the model or the RTL.
/// Then the writes of the next frame begin, if they go beside this one. `upload_of(f)` is a frame's upload,
/// null beyond the last.
template <class Machine, class UploadOf>
UploadTiming bring(Machine& machine, std::size_t f, const UploadOf& upload_of) {
    UploadTiming timing;
    const Upload& own = *upload_of(f);
    const std::uint64_t begin = machine.cycle();
    if (!own.beside || f == 0) machine.write(own.lines);
    machine.finish_writes();
    timing.lines = own.lines.size();
    timing.cycles = machine.cycle() - begin;
    if (own.resets) machine.reset();
    timing.reset = machine.cycle() - begin - timing.cycles;
    const Upload* next = upload_of(f + 1);
    if (next && next->beside) machine.write(next->lines);
    return timing;
}

}   // namespace rayclock
