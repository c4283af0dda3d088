// Reads an image's nodes from the root down, then bounds them from the leaves up.
#include "tests/support/check/image_check.hpp"

#include <unordered_map>

#include "model/engine/bvh/encode.hpp"
#include "model/layout/words.hpp"

namespace rayclock {

namespace {

constexpr std::size_t most_complaints = 20;

class Checker {
public:
    Checker(const MemoryImage& image, const Config& config)
        : image_(image),
          config_(config),
          used_(2 * std::size_t(image.lines())),
          lowest_(1 << (config.coord_bits - 1)),
          margin_(config.is_sheared()) {}

    std::vector<std::string> run(const Scene* scene) {
        if (image_.words.empty() || image_.words.size() % words_per_line != 0)
            return {"the image is not made of whole lines"};
        claim(0, 2, 0);
        nodes_.push_back({});
        for (std::size_t i = 0; i < nodes_.size() && !full(); ++i) read(i);
        if (full()) return complaints_;   // faults of unreached lines would only be noise
        for (std::size_t i = nodes_.size(); i-- > 0;) bound(i);
        leftovers();
        report();
        if (scene) compare(*scene);
        return complaints_;
    }

private:
    struct Visit {
        std::uint32_t line = 0, parent = 0, child = 0;   ///< `child` is the index in its parent
        int depth = 1, need = 0;
        Node node{};
        std::array<LatticeBox, max_width> real{};   ///< bounds of each child
    };

    bool full() const { return complaints_.size() >= most_complaints; }
    void complain(std::uint32_t line, const std::string& what) {
        if (!full()) complaints_.push_back("node in line " + std::to_string(line) + ": " + what);
    }

    /// Assigns half lines from `first` to the block of the node in `owner`. Returns false if they are not
    /// available.
    bool claim(std::uint64_t first, std::uint64_t count, std::uint32_t owner) {
        for (std::uint64_t i = first; i < first + count; ++i) {
            if (i < used_.size() && !used_[i]) {
                used_[i] = true;
                continue;
            }
            complain(owner, "its block reaches half line " + std::to_string(i) +
                                (i < used_.size() ? ", which is taken" : ", beyond the end"));
            return false;
        }
        return true;
    }

    template <class P>
    void whole(const P& payload, const std::uint32_t* at, std::size_t words, std::uint32_t line) {
        Words packed = pack(payload, config_);
        packed.resize(words, 0);
        if (!std::equal(packed.begin(), packed.end(), at))
            complain(line, "bits beyond a payload are not zero");
    }

    void read(std::size_t index) {
        Visit& at = nodes_[index];
        at.node = bvh::read_node(image_, at.line, config_);
        whole(at.node, image_.line(at.line), words_per_line, at.line);
        const Node node = at.node;
        const std::uint32_t line = at.line;
        const int depth = at.depth;
        std::uint32_t inner = 0, triangles = 0;
        for (std::size_t i = 0; i < std::size_t(config_.node_width); ++i) {
            const std::uint32_t kind = node.kind[i];
            const std::uint32_t before = i == 0 ? 1 : node.kind[i - 1];
            if ((kind == 1 && before != 1) || (kind > 1 && before == 0))
                complain(line, "kinds are out of order");
            if (kind > 1 + std::uint32_t(config_.leaf_size))
                complain(line, "a leaf is larger than leaf_size");
            if (kind == 0) empty(node, i, line);
            inner += kind == 1;
            triangles += kind > 1 ? kind - 1 : 0;
            leaves_ += kind > 1;
        }
        if (node.kind[0] == 0) complain(line, "it has no children");
        if (!claim(2 * std::uint64_t(node.base), 2 * inner + (triangles + 1) / 2 * 2, line)) return;
        if (triangles % 2 != 0) unused(2 * (node.base + inner) + triangles, line);
        leaves(nodes_[index], inner);
        for (std::uint32_t i = 0; i < inner; ++i)
            nodes_.push_back({node.base + i, std::uint32_t(index), i, depth + 1});
    }

    void empty(const Node& node, std::size_t i, std::uint32_t line) {
        for (std::size_t k = 0; k < 3; ++k)
            if (node.lo[3 * i + k] != 0 || node.hi[3 * i + k] != 0)
                complain(line, "an empty child has a box");
    }

    void unused(std::uint32_t half_line, std::uint32_t line) {
        const std::uint32_t* at = image_.half_line(half_line);
        if (!std::all_of(at, at + words_per_half, [](std::uint32_t word) { return word == 0; }))
            complain(line, "the padding of its block is not zero");
    }

    void leaves(Visit& at, std::uint32_t inner) {
        std::uint32_t half_line = 2 * (at.node.base + inner);
        for (std::size_t i = inner; i < std::size_t(config_.node_width); ++i)
            for (std::uint32_t n = 1; n < at.node.kind[i]; ++n, ++half_line) {
                const PrimData triangle = read_primitive(image_, half_line, config_);
                whole(triangle, image_.half_line(half_line), words_per_half, at.line);
                for (const Vec3i& point : {triangle.a, triangle.b, triangle.c}) {
                    at.real[i].add(LatticeBox{{point[0] - margin_, point[1] - margin_, point[2] - margin_},
                                              {point[0] + margin_, point[1] + margin_, point[2] + margin_}});
                    for (const std::int32_t x : point)
                        if (x == -lowest_) complain(at.line, "a triangle lies outside the symmetric lattice");
                }
                if (!triangles_.emplace(triangle.prim, triangle).second)
                    complain(at.line,
                             "triangle " + std::to_string(triangle.prim) + " is there more than once");
            }
    }

    /// Bounds children before their parents: nodes_ has parents first.
    void bound(std::size_t index) {
        Visit& at = nodes_[index];
        LatticeBox all;
        std::uint32_t inner = 0;
        for (std::size_t i = 0; i < std::size_t(config_.node_width); ++i) {
            if (at.node.kind[i] == 0) continue;
            inner += at.node.kind[i] == 1;
            all.add(at.real[i]);
            for (std::size_t k = 0; k < 3; ++k)
                if (bvh::dequantised(at.node, at.node.lo[3 * i + k], k) > at.real[i].lo[k] ||
                    bvh::dequantised(at.node, at.node.hi[3 * i + k], k) < at.real[i].hi[k])
                    complain(at.line, "child " + std::to_string(i) + " reaches out of its box along axis " +
                                          std::to_string(k));
        }
        at.need += inner >= 2;
        if (index == 0) return;
        Visit& parent = nodes_[at.parent];
        parent.real[at.child].add(all);
        parent.need = std::max(parent.need, at.need);
    }

    void leftovers() {
        for (std::size_t i = 0; i < used_.size(); ++i)
            if (!used_[i]) return complain(0, "nothing leads to half line " + std::to_string(i));
    }

    void report() {
        const CompileReport& r = image_.report;
        int depth = 0;
        for (const Visit& at : nodes_) depth = std::max(depth, at.depth);
        const auto expect = [&](const char* what, std::uint64_t said, std::uint64_t found) {
            if (said != found)
                complain(0, std::string("the report says ") + what + " " + std::to_string(said) +
                                ", the image " + std::to_string(found));
        };
        expect("nodes", r.nodes, nodes_.size());
        expect("leaves", r.leaves, leaves_);
        expect("depth", std::uint64_t(r.depth), std::uint64_t(depth));
        expect("stack_need", std::uint64_t(r.stack_need), std::uint64_t(nodes_[0].need));
        expect("bytes", r.bytes, image_.words.size() * sizeof(std::uint32_t));
        expect("kept triangles", r.triangles - r.collapsed, triangles_.size());
    }

    void compare(const Scene& scene) {
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
            const auto corner = [&](std::size_t k) {
                return image_.lattice.snap(scene.vertices[scene.triangles[i].vertex[k]]);
            };
            const Vec3i a = corner(0), b = corner(1), c = corner(2);
            const auto found = triangles_.find(std::uint32_t(i));
            const bool there = found != triangles_.end();
            const bool useless = config_.is_sheared() ? a == b || b == c || c == a : flat(a, b, c);
            if (there == useless)
                complain(0, "triangle " + std::to_string(i) + (there ? " has no area" : " is missing"));
            else if (there && (found->second.a != a || found->second.b != b || found->second.c != c))
                complain(0, "triangle " + std::to_string(i) + " has other corners than the scene");
        }
        if (image_.report.triangles != scene.triangles.size()) complain(0, "the report is of another scene");
    }

    /// Returns true for collinear corners. Uses Lagrange's identity |u|^2 |v|^2 = (u . v)^2, a different
    /// method than the compiler's cross product.
    static bool flat(const Vec3i& a, const Vec3i& b, const Vec3i& c) {
        __extension__ using Int128 = __int128;
        Int128 uu = 0, vv = 0, uv = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Int128 u = b[k] - a[k], v = c[k] - a[k];
            uu += u * u;
            vv += v * v;
            uv += u * v;
        }
        return uu * vv == uv * uv;
    }

    const MemoryImage& image_;
    const Config& config_;
    std::vector<bool> used_;         // by half line
    std::int32_t lowest_, margin_;   // margin_: the enlargement of a triangle's box
    std::vector<Visit> nodes_;
    std::unordered_map<std::uint32_t, PrimData> triangles_;
    std::uint64_t leaves_ = 0;
    std::vector<std::string> complaints_;
};

}   // namespace

std::vector<std::string> check_image(const MemoryImage& image, const Config& config, const Scene* scene) {
    return Checker{image, config}.run(scene);
}

}   // namespace rayclock
