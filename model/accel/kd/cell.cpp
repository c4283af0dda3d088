#include "model/accel/kd/cell.hpp"

namespace rayclock::kd {

CellPtr leaf_of(const Items& items) {
    auto cell = std::make_unique<Cell>();
    cell->bounds = bounds_of(items);
    for (const Item& item : items) cell->prims.push_back(item.prim);
    return cell;
}

Pieces::Pieces(const std::vector<PrimData>& prims, const Config& config) {
    const std::int32_t far = (1 << (config.coord_bits - 1)) - 1;
    space_ = {{-far, -far, -far}, {far, far, far}};
    clippers_.reserve(prims.size());
    for (std::uint32_t i = 0; i < prims.size(); ++i) {
        clippers_.emplace_back(prims[i], config.coord_bits, config.is_sheared() ? 1 : 0);
        if (PrimKind(prims[i].kind) == PrimKind::plane) endless_.push_back(i);
    }
}

Items Pieces::all() const {
    LatticeBox beyond = space_;   // an item that reaches out of space is clipped to it
    --beyond.lo[0];
    Items items;
    std::size_t endless = 0;
    for (std::uint32_t i = 0; i < clippers_.size(); ++i)
        if (endless < endless_.size() && endless_[endless] == i)
            ++endless;
        else
            take({i, beyond}, space_, items);
    return items;
}

void Pieces::take(const Item& item, const LatticeBox& box, Items& out) const {
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k)
        inside = inside && item.box.lo[k] >= box.lo[k] && item.box.hi[k] <= box.hi[k];
    if (inside)
        out.push_back(item);
    else if (const auto clipped = clippers_[item.prim](box))
        out.push_back({item.prim, *clipped});
}

void Pieces::divide(const Items& items, const LatticeBox& box, const Cut& cut, Items& lower,
                    Items& upper) const {
    LatticeBox below = box, above = box;
    below.hi[cut.axis] = above.lo[cut.axis] = cut.plane;
    for (const Item& item : items) {
        const std::int32_t lo = item.box.lo[cut.axis], hi = item.box.hi[cut.axis];
        const bool flat = lo == cut.plane && hi == cut.plane;
        if (lo < cut.plane || (flat && !cut.flat_above)) take(item, below, lower);
        if (hi > cut.plane || (flat && cut.flat_above)) take(item, above, upper);
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

}   // namespace rayclock::kd
