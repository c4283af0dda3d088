// Reinsertion. Each round searches the best moves in parallel on a fixed tree. It then makes them one by one,
// largest gain first, and undoes a move whose gain an earlier move has turned into a loss.
#include "model/engine/bvh/build.hpp"

#include <tbb/parallel_for.h>

namespace rayclock::bvh {

namespace {

constexpr int rounds = 3;
constexpr std::size_t share = 10;                // a round tries the tenth of the nodes with the largest area
constexpr std::size_t least_candidates = 8192;   // a small tree tries all nodes

/// Takes `node` and its parent out, and puts both back above `to`. `gain` is the area saved.
struct TreeMove {
    double gain = 0;
    std::uint32_t node = no_node, to = no_node;
};

class Optimiser {
public:
    explicit Optimiser(BinaryTree& tree) : tree_(tree), parents_(tree.nodes.size(), no_node) {
        for (std::uint32_t i = 0; i < tree.nodes.size(); ++i)
            if (!at(i).is_leaf()) parents_[at(i).left] = parents_[at(i).right] = i;
    }

    void run() {
        for (int round = 0; round < rounds; ++round)
            if (!improve()) return;
    }

private:
    using Pending = std::vector<std::pair<double, std::uint32_t>>;

    BinaryNode& at(std::uint32_t i) { return tree_.nodes[i]; }
    const BinaryNode& at(std::uint32_t i) const { return tree_.nodes[i]; }
    std::uint32_t sibling(std::uint32_t i) const {
        const BinaryNode& parent = at(parents_[i]);
        return parent.left == i ? parent.right : parent.left;
    }

    bool improve() {
        const std::vector<std::uint32_t> nodes = candidates();
        std::vector<TreeMove> moves(nodes.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes.size(), 64), [&](const auto& range) {
            Pending pending;
            for (std::size_t i = range.begin(); i < range.end(); ++i) moves[i] = search(nodes[i], pending);
        });
        std::erase_if(moves, [](const TreeMove& m) { return m.to == no_node; });
        std::sort(moves.begin(), moves.end(), [](const TreeMove& a, const TreeMove& b) {
            return a.gain != b.gain ? a.gain > b.gain : a.node < b.node;
        });
        bool better = false;
        for (const TreeMove& move : moves) better = attempt(move) || better;
        return better;
    }

    std::vector<std::uint32_t> candidates() const {
        std::vector<std::pair<double, std::uint32_t>> sized;
        sized.reserve(tree_.nodes.size());
        for (std::uint32_t i = 0; i < tree_.nodes.size(); ++i)
            if (i != tree_.root) sized.emplace_back(-at(i).box.area(), i);
        const std::size_t n = std::min(sized.size(), std::max(least_candidates, sized.size() / share));
        if (n < sized.size()) std::nth_element(sized.begin(), sized.begin() + std::ptrdiff_t(n), sized.end());
        std::vector<std::uint32_t> nodes(n);
        for (std::size_t i = 0; i < n; ++i) nodes[i] = sized[i].second;
        return nodes;
    }

    /// Climbs from the node and searches the other side of each ancestor. `saved` is the area of the removed
    /// parent plus the area that the ancestors below the current one lose.
    TreeMove search(std::uint32_t node, Pending& pending) const {
        TreeMove best{0, node, no_node};
        std::uint32_t pivot = parents_[node];
        double saved = at(pivot).box.area();
        LatticeBox without = at(sibling(node)).box;   // of the pivot's subtree without the node
        look_down(sibling(node), saved, best, pending);
        for (; pivot != tree_.root; pivot = parents_[pivot]) {
            look_down(sibling(pivot), saved, best, pending);
            without.add(at(sibling(pivot)).box);
            saved += at(parents_[pivot]).box.area() - without.area();
        }
        return best;
    }

    void look_down(std::uint32_t from, double saved, TreeMove& best, Pending& pending) const {
        const LatticeBox& box = at(best.node).box;
        const double own = box.area();
        pending.assign(1, {saved, from});
        while (!pending.empty()) {
            const auto [so_far, to] = pending.back();
            pending.pop_back();
            if (so_far - own <= best.gain) continue;   // the new parent is at least as large as the node
            const BinaryNode& place = at(to);
            const double gain = so_far - merged(place.box, box).area();
            if (gain > best.gain) best = {gain, best.node, to};
            if (place.is_leaf()) continue;
            pending.emplace_back(gain + place.box.area(), place.right);
            pending.emplace_back(gain + place.box.area(), place.left);
        }
    }

    /// Makes a move unless earlier moves have made it impossible or bad.
    bool attempt(const TreeMove& move) {
        if (move.node == tree_.root || move.to == parents_[move.node] || move.to == sibling(move.node))
            return false;
        for (std::uint32_t i = move.to; i != no_node; i = parents_[i])
            if (i == move.node) return false;   // by now below the node itself
        const std::uint32_t home = sibling(move.node);
        if (put(move.node, move.to) < 0) return true;
        put(move.node, home);
        return false;
    }

    /// Moves a node and its parent above `to`. Returns the growth of the area.
    double put(std::uint32_t node, std::uint32_t to) {
        const std::uint32_t parent = parents_[node], other = sibling(node), above = parents_[parent];
        double growth = -at(parent).box.area();
        replace(above, parent, other);
        growth += refit(above);
        replace(parents_[to], to, parent);
        at(parent).left = to;
        at(parent).right = node;
        parents_[to] = parents_[node] = parent;
        at(parent).box = merged(at(to).box, at(node).box);
        growth += at(parent).box.area();
        return growth + refit(parents_[parent]);
    }

    void replace(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
        parents_[by] = parent;
        if (parent == no_node)
            tree_.root = by;
        else
            (at(parent).left == child ? at(parent).left : at(parent).right) = by;
    }

    double refit(std::uint32_t i) {
        double growth = 0;
        for (; i != no_node; i = parents_[i]) {
            const LatticeBox box = merged(at(at(i).left).box, at(at(i).right).box);
            if (box == at(i).box) break;
            growth += box.area() - at(i).box.area();
            at(i).box = box;
        }
        return growth;
    }

    BinaryTree& tree_;
    std::vector<std::uint32_t> parents_;
};

}   // namespace

void optimise_tree(BinaryTree& tree) { Optimiser{tree}.run(); }

}   // namespace rayclock::bvh
