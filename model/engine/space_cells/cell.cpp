// Cells, and the primitives on both sides of a cut.
#include "model/engine/space_cells/cell.hpp"

#include <algorithm>

namespace rayclock::space_cells {

CellPtr leaf_of(const Items& items) {
    auto cell = std::make_unique<Cell>();
    cell->bounds = bounds_of(items);
    for (const Item& item : items) cell->prims.push_back(item.prim);
    cell->count = std::uint32_t(items.size());
    return cell;
}

Region Region::part(const Cut& cut, bool upper) const {
    Region half = *this;
    if (cut.axis == no_axis)
        half.walls.push_back({cut.normal, cut.plane, upper});
    else
        (upper ? half.box.lo : half.box.hi)[cut.axis] = cut.plane;
    return half;
}

namespace {
LatticeBox space_of(const Config& config) {
    const std::int32_t far = (1 << (config.coord_bits - 1)) - 1;
    return {{-far, -far, -far}, {far, far, far}};
}
}   // namespace

Pieces::Pieces(const std::vector<LatticeBox>& boxes, const Config& config)
    : clippers_(boxes.begin(), boxes.end()), space_(space_of(config)) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (boxes[i] == space_) endless_.push_back(i);
}

Pieces::Pieces(const std::vector<PrimData>& prims, const Config& config) : space_(space_of(config)) {
    clippers_.reserve(prims.size());
    for (std::uint32_t i = 0; i < prims.size(); ++i) {
        clippers_.emplace_back(prims[i], config.coord_bits, config.is_sheared() ? 1 : 0);
        if (prims[i].kind == PrimKind::plane) endless_.push_back(i);
    }
}

Items Pieces::all() const {
    LatticeBox beyond = space_;   // larger than space, so that items are clipped to space
    --beyond.lo[0];
    Items items;
    std::size_t endless = 0;
    for (std::uint32_t i = 0; i < clippers_.size(); ++i)
        if (endless < endless_.size() && endless_[endless] == i)
            ++endless;
        else
            take({i, beyond}, {space_}, items);
    return items;
}

void Pieces::take(const Item& item, const Region& region, Items& out) const {
    bool inside = true;
    LatticeBox box = region.box;
    for (std::size_t k = 0; k < 3; ++k)
        inside = inside && item.box.lo[k] >= box.lo[k] && item.box.hi[k] <= box.hi[k];
    std::array<Wall, max_walls> walls;   // those that cut the item
    std::size_t count = 0;
    for (const Wall& wall : region.walls) {
        const Clipper::Reach reach = this->reach(item, wall.normal);
        if (wall.upper ? reach.lo < wall.at : reach.hi > wall.at) walls[count++] = wall;
    }
    if (inside && count == 0) return out.push_back(item);
    if (!region.walls.empty())   // parts that walls have cut off before stay off
        for (std::size_t k = 0; k < 3; ++k)
            box.lo[k] = std::max(box.lo[k], item.box.lo[k]), box.hi[k] = std::min(box.hi[k], item.box.hi[k]);
    if (const auto clipped = clippers_[item.prim](box, {walls.data(), count}))
        out.push_back({item.prim, *clipped});
}

Clipper::Reach Pieces::reach(const Item& item, const Vec3i& n) const {
    Clipper::Reach box{}, reach = clippers_[item.prim].reach(n);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t a = std::int64_t(n[k]) * item.box.lo[k], b = std::int64_t(n[k]) * item.box.hi[k];
        box.lo += std::min(a, b);
        box.hi += std::max(a, b);
    }
    return {std::max(box.lo, reach.lo), std::min(box.hi, reach.hi)};
}

void Pieces::divide(const Items& items, const Region& region, const Cut& cut, Items& lower,
                    Items& upper) const {
    const Region below = region.part(cut, false), above = region.part(cut, true);
    for (const Item& item : items) {
        Clipper::Reach reach;
        if (cut.axis == no_axis)
            reach = this->reach(item, cut.normal);
        else
            reach = {item.box.lo[cut.axis], item.box.hi[cut.axis]};
        const bool flat = reach.lo == cut.plane && reach.hi == cut.plane;
        if (reach.lo < cut.plane || (flat && !cut.flat_above)) take(item, below, lower);
        if (reach.hi > cut.plane || (flat && cut.flat_above)) take(item, above, upper);
    }
}

CellPtr Pieces::with_endless(CellPtr tree) const {
    if (endless_.empty()) return tree;
    auto root = std::make_unique<Cell>();
    root->lower = std::make_unique<Cell>();
    root->lower->prims = endless_;
    root->upper = std::move(tree);
    return root;
}

}   // namespace rayclock::space_cells
