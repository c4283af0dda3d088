#pragma once
// Reads nodes of memory in the model's own form.
#include "model/core/config.hpp"
#include "model/core/layout.hpp"

namespace rayclock {

/// Unpacks a node's line and widens it.
template <class Node> class WidenedReader {
public:
    explicit WidenedReader(const Config& config) : config_(config) {}
    auto operator()(const std::uint32_t* line) const {
        return widen(unpack<Node>(line, config_), config_.node_width);
    }

private:
    const Config& config_;
};

}   // namespace rayclock
