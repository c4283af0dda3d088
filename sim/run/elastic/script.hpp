#pragma once
// The order in which each pixel's rays move through the machine. It does not depend on timing.
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "model/core/frame.hpp"
#include "model/machine/machine.hpp"

namespace rayclock {

/// The sequence of links on which the rays of each pixel make their transfers in the model. A context is in
/// one place at a time, so its transfers form one sequence. A transfer takes one byte.
class Script {
public:
    explicit Script(const Frame& frame) : width_(frame.width), pixels_(std::size_t(frame.pixels())) {}

    /// Adds a transfer of the model. Call it in the order of the machine's cycles.
    void add(const Move& move) {
        if (move.link == Link::tile)
            tiles_.emplace(move.x, move.y);
        else if (link_infos[index(move.link)].carries_ray)
            pixels_[place(move.x, move.y)].push_back(std::uint8_t(move.link));
    }

    bool has_pixel(std::uint32_t x, std::uint32_t y) const {
        return x < width_ && place(x, y) < pixels_.size();
    }
    std::size_t place(std::uint32_t x, std::uint32_t y) const { return std::size_t(y) * width_ + x; }
    std::size_t size() const { return pixels_.size(); }
    Slot pixel(std::size_t place) const {
        return {0, std::uint32_t(place % width_), std::uint32_t(place / width_)};
    }
    std::span<const std::uint8_t> links(std::size_t place) const { return pixels_[place]; }
    const std::set<std::pair<std::uint32_t, std::uint32_t>>& tiles() const { return tiles_; }

private:
    std::uint32_t width_;
    std::vector<std::vector<std::uint8_t>> pixels_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> tiles_;
};

}   // namespace rayclock
