#pragma once
#include "model/layout/memory_image.hpp"
#include "model/trace/line_cache.hpp"
#include "model/engine/bsp/slant.hpp"
#include "model/engine/bvh/box.hpp"
#include "model/engine/globe/globe.hpp"
#include "model/engine/kd/treelet.hpp"
#include "model/engine/none/page.hpp"

namespace rayclock {

/// Lines of the memory image in the model's own form. Each is unpacked when it is first read, by any thread.
/// This only saves time: all data come from the image's bytes.
class Decoder {
public:
    Decoder(const MemoryImage& image, const Config& config)
        : image_(image),
          config_(config),
          upper_(config.engine()),
          lower_(config.lower_engine()),
          read_node_(config),
          nodes_(config.has_boxes() ? image.lines() : 0),
          treelets_(config.has_treelets() ? image.lines() : 0),
          globes_(config.has_globes() ? image.lines() : 0),
          slants_(config.has_slants() ? image.lines() : 0),
          placements_(config.has_instances() ? image.lines() : 0),
          prims_(std::size_t(image.lines()) * 2),
          surfaces_(config.shading ? image.lines() - image.surfaces : 0) {}

    const WideNode& node(std::uint32_t line) const {
        return nodes_.get(line, [&] { return read_node_(image_.line(line)); });
    }
    /// With two levels: kind() returns the kind of a line, placement() an instance.
    LineKind kind(std::uint32_t line) const { return line_kind(image_.line(line)); }
    /// Returns the engine that walks the tree of the node in a line.
    Structure engine(std::uint32_t line) const {
        return config_.has_instances() && kind(line) == LineKind::mesh_node ? lower_ : upper_;
    }
    const Placement& placement(std::uint32_t line) const {
        return placements_.get(line, [&] { return unpack<Placement>(image_.line(line), config_); });
    }
    /// Returns a node of a kd-tree.
    const WideTreelet& treelet(std::uint32_t line) const {
        return treelets_.get(
            line, [&] { return widen(unpack<Treelet>(image_.line(line), config_), config_.node_width); });
    }
    /// Returns a node of a hierarchy of globes.
    const WideGlobes& globes(std::uint32_t line) const {
        return globes_.get(
            line, [&] { return widen(unpack<GlobeNode>(image_.line(line), config_), config_.node_width); });
    }
    /// Returns a node of a tree of planes in any direction.
    const WideSlant& slant(std::uint32_t line) const {
        return slants_.get(
            line, [&] { return widen(unpack<Slant>(image_.line(line), config_), config_.node_width); });
    }
    /// Returns the children of the node in a line, of any tree: their places and their number.
    const WideNode& below(std::uint32_t line) const {
        switch (engine(line)) {
            case Structure::kd: return treelet(line).exits;
            case Structure::spheres: return globes(line).children;
            case Structure::bsp: return slant(line).exits;
            default: return node(line);
        }
    }
    /// Returns the number of children or exits of the node in a line. An instance has none.
    std::uint32_t children(std::uint32_t line) const {
        if (config_.has_instances() && kind(line) == LineKind::placement) return 0;
        return below(line).children;
    }
    /// For a list: page() returns the page that begins in a line, next_page() the line of the next one, 0
    /// after the last.
    WideNode page(std::uint32_t line) const { return page_of(line, image_.listed, config_.node_width); }
    std::uint32_t next_page(std::uint32_t line) const {
        const std::uint32_t next = line + page_lines(config_.node_width);
        return 2 * next < image_.listed ? next : 0;
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
    Structure upper_, lower_;
    NodeReader read_node_;
    LineCache<WideNode> nodes_;
    LineCache<WideTreelet> treelets_;
    LineCache<WideGlobes> globes_;
    LineCache<WideSlant> slants_;
    LineCache<Placement> placements_;
    LineCache<PrimData> prims_;
    LineCache<Surface> surfaces_;
};

}   // namespace rayclock
