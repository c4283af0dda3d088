// Layout: cells of space as memory lines, treelet by treelet.
#include "model/accel/emit.hpp"
#include "model/accel/encode.hpp"
#include "model/accel/kd/build.hpp"
#include "model/accel/octree/build.hpp"
#include "model/accel/written.hpp"

namespace rayclock {

namespace {

using kd::Cell;

constexpr std::size_t leaf_most = (1u << count_bits) - 2;   // primitives of an exit

/// A cell, or some of a leaf's primitives: a leaf that is too large for an exit is walked in parts.
struct Place {
    const Cell* cell = nullptr;
    std::size_t first = 0, count = 0;   ///< of a leaf
    explicit Place(const Cell* c = nullptr) : cell(c), count(c ? c->prims.size() : 0) {}
    Place(const Cell* c, std::size_t f, std::size_t n) : cell(c), first(f), count(n) {}
    bool is_empty() const { return !cell || (cell->is_leaf() && count == 0); }
    bool is_leaf() const { return is_empty() || (cell->is_leaf() && count <= leaf_most); }
    Place lower() const { return cell->is_leaf() ? Place(cell, first, count / 2) : Place(cell->lower.get()); }
    Place upper() const {
        return cell->is_leaf() ? Place(cell, first + count / 2, count - count / 2) : Place(cell->upper.get());
    }
};

void put(const Cell& cell, std::size_t plane, Treelet& treelet) {
    treelet.axis[plane] = cell.axis;
    if (cell.axis != no_axis) treelet.at[plane] = cell.at;
}
void put(const Cell& cell, std::size_t plane, Slant& slant) {
    for (std::size_t k = 0; k < 3; ++k) slant.normal[3 * plane + k] = cell.normal[k];
    slant.at[plane] = cell.at;
}
void put_none(std::size_t plane, Treelet& treelet) { treelet.axis[plane] = no_axis; }
void put_none(std::size_t, Slant&) {}

/// `Line` is what a node is: a treelet or a slant.
template <class Line> class Emitter {
public:
    Emitter(const Cell& root, const std::vector<PrimData>& prims, const Config& config,
            const std::string& name, MemoryImage& image)
        : root_(root), prims_(prims), config_(config), name_(name), image_(image) {}

    void run() {
        image_.words.assign(words_per_line, 0);
        pending_.push_back({Place(&root_), 0, 0});
        while (!pending_.empty()) {   // depth first, as of the box tree
            const Pending next = pending_.back();
            pending_.pop_back();
            emit(next);
        }
        written_.account(image_);
    }

private:
    struct Pending {
        Place place;
        std::uint32_t line = 0, parent = 0;
    };

    /// The part of a treelet under plane `plane`, which has the exits from `exit` on.
    void fill(const Place& place, std::size_t plane, std::size_t exit, std::size_t exits, Line& treelet) {
        if (exits == 1 || plane >= treelet.at.size()) {   // the second says it to GCC 14
            exits_[exit] = place;
            return;
        }
        const bool cut = !place.is_leaf() && (plane == 0 || !place.cell->begins);
        if (cut && !place.cell->is_leaf())
            put(*place.cell, plane, treelet);
        else
            put_none(plane, treelet);
        fill(cut ? place.lower() : place, 2 * plane + 1, exit, exits / 2, treelet);
        fill(cut ? place.upper() : Place(), 2 * plane + 2, exit + exits / 2, exits / 2, treelet);
    }

    void emit(const Pending& at) {
        const auto width = std::size_t(config_.node_width);
        Line treelet;
        const LatticeBox& bounds = at.place.cell->bounds;
        treelet.open = bounds.lo[0] > bounds.hi[0];
        if (!treelet.open) treelet.lo = bounds.lo, treelet.hi = bounds.hi;
        fill(at.place, 0, 0, width, treelet);
        const std::array<Place, max_width> exits = exits_;
        std::uint32_t inner = 0;
        std::size_t primitives = 0;
        for (std::size_t i = 0; i < width; ++i) {
            const bool leaf = exits[i].is_leaf();
            treelet.kind[i] = exits[i].is_empty() ? 0 : leaf ? 1 + std::uint32_t(exits[i].count) : 1;
            inner += !leaf;
            if (leaf && !exits[i].is_empty()) primitives += exits[i].count, ++image_.report.leaves;
        }
        const std::size_t base = image_.words.size() / words_per_line;
        const std::size_t lines = base + inner + (primitives + 1) / 2;
        check_lines(lines, config_, name_);
        image_.words.resize(lines * words_per_line, 0);
        treelet.base = std::uint32_t(base);
        write_payload(treelet, config_, &image_.words[at.line * words_per_line], scratch_);
        std::size_t half_line = 2 * (base + inner);
        for (std::size_t i = 0; i < width; ++i)
            for (std::size_t p = 0; treelet.kind[i] > 1 && p < exits[i].count; ++p)
                write_payload(prims_[exits[i].cell->prims[exits[i].first + p]], config_,
                              &image_.words[half_line++ * words_per_half], scratch_);
        image_.report.references += primitives;
        const std::uint32_t id = written_.add(at.parent, inner);
        for (std::size_t i = width, line = base + inner; i-- > 0;)
            if (treelet.kind[i] == 1) pending_.push_back({exits[i], std::uint32_t(--line), id});
    }

    const Cell& root_;
    const std::vector<PrimData>& prims_;
    const Config& config_;
    const std::string& name_;
    MemoryImage& image_;
    std::array<Place, max_width> exits_;   // of the treelet under way
    std::vector<Pending> pending_;
    WrittenNodes written_;
    Words scratch_;
};

}   // namespace

void emit_cells(const std::vector<PrimData>& prims, const Config& config, const std::string& name,
                MemoryImage& image) {
    const kd::CellPtr root = (config.is_octree() ? octree::build : kd::build)(prims, config);
    if (config.has_slants())
        Emitter<Slant>{*root, prims, config, name, image}.run();
    else
        Emitter<Treelet>{*root, prims, config, name, image}.run();
}

void emit_list(const std::vector<PrimData>& prims, const Config& config, const std::string& name,
               MemoryImage& image) {
    const std::size_t lines = (prims.size() + 1) / 2;
    check_lines(lines, config, name);
    image.words.assign(lines * words_per_line, 0);
    Words scratch;
    for (std::size_t i = 0; i < prims.size(); ++i)
        write_payload(prims[i], config, &image.words[i * words_per_half], scratch);
    image.listed = std::uint32_t(prims.size());
    image.report.references = prims.size();
    image.report.bytes = image.words.size() * sizeof(std::uint32_t);
}

}   // namespace rayclock
