// Layout: cells of space as memory lines, node by node.
#include "model/compile/emit.hpp"
#include "model/engine/engines.hpp"
#include "model/layout/node_statistics.hpp"
#include "model/layout/words.hpp"

namespace rayclock {

namespace {

using space_cells::CellPart;

constexpr std::size_t leaf_most = (1u << count_bits) - 2;   // primitives of an exit

/// Writes a tree of cells.
template <class Engine> class CellEmitter {
public:
    CellEmitter(const space_cells::Cell& root, const std::vector<PrimData>& prims, const Config& config,
                const std::string& name, MemoryImage& image)
        : root_(root), prims_(prims), config_(config), name_(name), image_(image) {}

    void run() {
        image_.words.assign(words_per_line, 0);
        pending_.push_back({CellPart(&root_), 0, 0});
        while (!pending_.empty()) {   // depth-first, as for the box tree
            const Pending next = pending_.back();
            pending_.pop_back();
            emit(next);
        }
        nodes_written_.fill_report(image_);
    }

private:
    struct Pending {
        CellPart place;
        std::uint32_t line = 0, parent = 0;
    };

    void emit(const Pending& at) {
        const auto width = std::size_t(config_.node_width);
        typename Engine::Node node;
        const std::array<CellPart, max_width> exits = exits_.of(at.place, config_.node_width, node);
        std::uint32_t inner = 0;
        std::size_t primitives = 0;
        for (std::size_t i = 0; i < width; ++i) {
            const bool leaf = exits[i].is_leaf(leaf_most);
            node.kind[i] = exits[i].is_empty() ? 0 : leaf ? 1 + std::uint32_t(exits[i].count) : 1;
            inner += !leaf;
            if (leaf && !exits[i].is_empty()) primitives += exits[i].count, ++image_.report.leaves;
        }
        const std::size_t base = image_.words.size() / words_per_line;
        const std::size_t lines = base + inner + (primitives + 1) / 2;
        check_lines(lines, config_, name_);
        image_.words.resize(lines * words_per_line, 0);
        node.base = std::uint32_t(base);
        write_payload(node, config_, &image_.words[at.line * words_per_line], scratch_);
        std::size_t half_line = 2 * (base + inner);
        for (std::size_t i = 0; i < width; ++i)
            for (std::size_t p = 0; node.kind[i] > 1 && p < exits[i].count; ++p)
                write_payload(prims_[exits[i].prim(p)], config_, &image_.words[half_line++ * words_per_half],
                              scratch_);
        image_.report.references += primitives;
        const std::uint32_t id = nodes_written_.add(at.parent, inner);
        for (std::size_t i = width, line = base + inner; i-- > 0;)
            if (node.kind[i] == 1) pending_.push_back({exits[i], std::uint32_t(--line), id});
    }

    const space_cells::Cell& root_;
    const std::vector<PrimData>& prims_;
    const Config& config_;
    const std::string& name_;
    MemoryImage& image_;
    space_cells::Exits<Engine> exits_{leaf_most};
    std::vector<Pending> pending_;
    NodeStatistics nodes_written_;
    Words scratch_;
};

}   // namespace

void emit_cells(const std::vector<PrimData>& prims, const Config& config, const std::string& name,
                MemoryImage& image, const std::function<void()>& report) {
    with_engine(config.engine(), [&]<class E>(E) {
        if constexpr (E::has_cells) {
            space_cells::Pieces pieces(prims, config);
            pieces.report_to(report);
            const space_cells::CellPtr root = E::build(pieces, prims, config);
            CellEmitter<E>{*root, prims, config, name, image}.run();
        }
    });
}

void emit_list(const std::vector<PrimData>& prims, const Config& config, const std::string& name,
               MemoryImage& image) {
    const std::size_t lines = (prims.size() + 1) / 2;
    check_lines(lines, config, name);
    image.words.assign(lines * words_per_line, 0);
    Words scratch;
    for (std::size_t i = 0; i < prims.size(); ++i)
        write_payload(prims[i], config, &image.words[i * words_per_half], scratch);
    image.listed_primitives = std::uint32_t(prims.size());
    image.report.references = prims.size();
    image.report.bytes = image.words.size() * sizeof(std::uint32_t);
}

}   // namespace rayclock
