// Reads nodes of boxes and their primitives back from a memory image.
#include "model/engine/bvh/decode.hpp"

#include "model/layout/words.hpp"

namespace rayclock::bvh {

Node read_node(const MemoryImage& image, std::uint32_t line, const Config& config) {
    return unpack<Node>(image.line(line), config);
}

void for_each_node(const MemoryImage& image, std::uint32_t root, const Config& config,
                   const std::function<void(const Node&, std::uint32_t, std::uint32_t)>& f) {
    std::vector<std::uint32_t> pending{root};
    while (!pending.empty()) {
        const Node node = read_node(image, pending.back(), config);
        pending.pop_back();
        std::uint32_t inner = 0, primitives = 0;
        for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) {
            inner += node.kind[i] == 1;
            primitives += node.kind[i] > 1 ? node.kind[i] - 1 : 0;
        }
        f(node, inner, primitives);
        for (std::uint32_t i = inner; i-- > 0;) pending.push_back(node.base + i);
    }
}

void for_each_primitive(const MemoryImage& image, const Config& config,
                        const std::function<void(const PrimData&)>& f) {
    for_each_node(image, 0, config, [&](const Node& node, std::uint32_t inner, std::uint32_t primitives) {
        for (std::uint32_t i = 0; i < primitives; ++i)
            f(read_primitive(image, 2 * (node.base + inner) + i, config));
    });
}

}   // namespace rayclock::bvh
