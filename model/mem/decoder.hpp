#pragma once
#include <cstdint>
#include <vector>

#include "model/accel/memory_image.hpp"
#include "model/trav/box.hpp"

namespace rayclock {

/// Lines of the memory image in the model's own form, each unpacked when it is first read. A speed-up only: nothing is
/// known here that the bytes do not say.
class Decoder {
public:
    Decoder(const MemoryImage& image, const Config& config)
        : image_(image), config_(config), node_at_(image.lines(), 0), prim_at_(std::size_t(image.lines()) * 2, 0) {}

    const WideNode& node(std::uint32_t line) {
        std::uint32_t& at = node_at_[line];
        if (at == 0) {
            nodes_.push_back(widen(unpack<Node>(image_.line(line), config_), config_.node_width));
            at = std::uint32_t(nodes_.size());
        }
        return nodes_[at - 1];
    }
    const PrimData& prim(std::uint32_t half_line) {
        std::uint32_t& at = prim_at_[half_line];
        if (at == 0) {
            prims_.push_back(unpack<PrimData>(image_.half_line(half_line), config_));
            at = std::uint32_t(prims_.size());
        }
        return prims_[at - 1];
    }

private:
    const MemoryImage& image_;
    Config config_;
    std::vector<std::uint32_t> node_at_, prim_at_;   // 1 + index, 0: not yet read
    std::vector<WideNode> nodes_;
    std::vector<PrimData> prims_;
};

} // namespace rayclock
