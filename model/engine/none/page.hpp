#pragma once
// The pages of a list of primitives (structure=none).
#include <algorithm>

#include "model/engine/node_answer.hpp"

namespace rayclock {

/// A list of all primitives has no nodes. A ray gets it page by page. A page is the amount that list accepts
/// at a time: node_width leaves of page_leaf primitives each, all from t = 0 on.
constexpr std::uint32_t page_leaf = 4;   ///< a power of two; rtl/engine/none/rc_none.sv
constexpr std::uint32_t page_lines(int node_width) { return std::uint32_t(node_width) * page_leaf / 2; }

/// Returns the page that begins in `line`, in a list of `listed` primitives from line 0 on, as a node with
/// only leaves.
inline WideNode page_of(std::uint32_t line, std::uint32_t listed, int node_width) {
    WideNode page;
    page.base = line;
    std::uint32_t left = std::min(listed - 2 * line, std::uint32_t(node_width) * page_leaf);
    for (; left > 0; left -= std::min(left, page_leaf), ++page.children) {
        page.offset[page.children] = std::uint8_t(page_leaf * page.children);
        page.count[page.children] = std::uint8_t(std::min(left, page_leaf));
    }
    page.children_mask = std::uint8_t((1u << page.children) - 1);
    return page;
}

}   // namespace rayclock
