#pragma once
#include "model/accel/memory_image.hpp"
#include "model/trace/line_cache.hpp"
#include "model/bvh/box.hpp"

namespace rayclock {

/// Lines of the memory image in the model's own form, each unpacked when it is first read, by any thread. A
/// speed-up only: nothing is known here that the bytes do not say.
class Decoder {
public:
    Decoder(const MemoryImage& image, const Config& config)
        : image_(image),
          config_(config),
          read_node_(config),
          nodes_(image.lines()),
          prims_(std::size_t(image.lines()) * 2),
          surfaces_(config.shading ? image.lines() - image.surfaces : 0) {}

    const WideNode& node(std::uint32_t line) const {
        return nodes_.get(line, [&] { return read_node_(image_.line(line)); });
    }
    const PrimData& prim(std::uint32_t half_line) const {
        return prims_.get(half_line, [&] { return unpack<PrimData>(image_.half_line(half_line), config_); });
    }
    const Surface& surface(std::uint32_t line) const {
        return surfaces_.get(line - image_.surfaces,
                             [&] { return unpack<Surface>(image_.line(line), config_); });
    }

private:
    const MemoryImage& image_;
    Config config_;
    NodeReader read_node_;
    LineCache<WideNode> nodes_;
    LineCache<PrimData> prims_;
    LineCache<Surface> surfaces_;
};

}   // namespace rayclock
