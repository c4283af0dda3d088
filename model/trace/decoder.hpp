#pragma once
// The memory image, decoded into nodes and primitives on first use.
#include "model/engine/engines.hpp"
#include "model/engine/none/page.hpp"
#include "model/layout/memory_image.hpp"
#include "model/trace/line_cache.hpp"

namespace rayclock {

/// The decoded nodes of one engine. Empty if no level uses the engine.
template <class Engine> struct NodeCacheOf {
    typename Engine::Reader read;
    LineCache<typename Engine::Wide> lines;
    NodeCacheOf(const MemoryImage& image, const Config& config)
        : read(config), lines(config.is_walked(Engine::structure) ? image.lines() : 0) {}
};

/// Lines of the memory image in the model's own form. Each is unpacked when it is first read, by any thread.
/// This only saves time: all data come from the image's bytes.
class Decoder {
public:
    Decoder(const MemoryImage& image, const Config& config)
        : image_(image),
          config_(config),
          upper_(config.engine()),
          lower_(config.lower_engine()),
          nodes_(image_, config_),
          placements_(config.has_instances() ? image.lines() : 0),
          prims_(std::size_t(image.lines()) * 2),
          surfaces_(config.has_shade() ? image.lines() - image.first_surface_line : 0) {}

    /// Returns a node of the tree that an engine walks.
    template <class Engine> const typename Engine::Wide& node(std::uint32_t line) const {
        const NodeCacheOf<Engine>& nodes = nodes_.of<Engine>();
        return nodes.lines.get(line, [&] { return nodes.read(image_.line(line)); });
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
    /// Returns the children of the node in a line, of any tree: their places and their number.
    const WideNode& below(std::uint32_t line) const {
        return with_engine(engine(line),
                           [&]<class E>(E) -> const WideNode& { return E::children(node<E>(line)); });
    }
    /// Returns the number of children or exits of the node in a line. An instance has none.
    std::uint32_t children(std::uint32_t line) const {
        if (config_.has_instances() && kind(line) == LineKind::placement) return 0;
        return below(line).children;
    }
    /// For a list: page() returns the page that begins in a line, next_page() the line of the next one, 0
    /// after the last.
    WideNode page(std::uint32_t line) const {
        return page_of(line, image_.listed_primitives, config_.node_width);
    }
    std::uint32_t next_page(std::uint32_t line) const {
        const std::uint32_t next = line + page_lines(config_.node_width);
        return 2 * next < image_.listed_primitives ? next : 0;
    }
    const PrimData& prim(std::uint32_t half_line) const {
        return prims_.get(half_line, [&] { return unpack<PrimData>(image_.half_line(half_line), config_); });
    }
    const Surface& surface(std::uint32_t line) const {
        return surfaces_.get(line - image_.first_surface_line,
                             [&] { return unpack<Surface>(image_.line(line), config_); });
    }

private:
    const MemoryImage& image_;
    Config config_;
    Structure upper_, lower_;
    PerEngine<NodeCacheOf> nodes_;
    LineCache<Placement> placements_;
    LineCache<PrimData> prims_;
    LineCache<Surface> surfaces_;
};

}   // namespace rayclock
