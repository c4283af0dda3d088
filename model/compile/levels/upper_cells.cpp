// The scene's tree as cells of space.
#include "model/compile/levels/upper_lines.hpp"

#include "model/engine/engines.hpp"

namespace rayclock {
namespace {

template <class Engine> class CellWriter {
public:
    CellWriter(UpperLines& lines, UpperTotals& totals) : lines_(lines), totals_(totals) {}

    /// Writes a subtree. Returns the number of sibling groups that a ray may have to keep below the node.
    int write(const space_cells::CellPart& place, std::uint32_t at, int depth) {
        typename Engine::Node line;
        const int width = lines_.config().node_width;
        const std::array<space_cells::CellPart, max_width> exits =
            space_cells::Exits<Engine>(1).of(place, width, line);
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < std::size_t(width); ++i) {
            line.kind[i] = !exits[i].is_empty();   // an instance takes the place of an inner child
            count += line.kind[i];
        }
        line.base = lines_.take(count);
        lines_.write(line, at);
        ++totals_.report.nodes;
        int need = 0;
        for (std::uint32_t i = 0, next = line.base; i < std::uint32_t(width); ++i) {
            if (exits[i].is_empty()) continue;
            need = std::max(need, exits[i].is_leaf(1) ? totals_.place(exits[i].prim(0), next, depth)
                                                      : write(exits[i], next, depth + 1));
            ++next;
        }
        return need + (count >= 2);
    }

private:
    UpperLines& lines_;
    UpperTotals& totals_;
};

}   // namespace

UpperReport write_upper_cells(const std::vector<UpperEntry>& entries, const std::vector<LatticeBox>& boxes,
                              UpperLines& lines, std::uint32_t root, std::vector<PlacedEntry>& placed) {
    Config config = lines.config();
    config.leaf_size = 1;   // for an octree
    const space_cells::Pieces pieces(boxes, config);
    UpperTotals totals{entries, placed};
    with_engine(config.engine(), [&]<class E>(E) {
        if constexpr (E::has_cells) {
            const space_cells::CellPtr cells = E::build(pieces, {}, config);
            CellWriter<E> writer(lines, totals);
            totals.report.stack_need = writer.write(space_cells::CellPart(cells.get()), root, 1);
        }
    });
    return totals.report;
}

}   // namespace rayclock
