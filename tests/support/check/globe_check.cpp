// Reads an image of globes from its root down.
#include "tests/support/check/globe_check.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "model/engine/spheres/node.hpp"
#include "model/layout/words.hpp"
#include "model/engine/spheres/enclose.hpp"
#include "model/core/layout.hpp"
#include "model/unit/tri/vectors.hpp"

namespace rayclock {

namespace {

constexpr std::size_t most_complaints = 20;

/// A globe as stored, in lattice steps.
struct Written {
    Vec3l centre{};
    std::int64_t radius = 0;
    bool holds(const PrimData& prim, const Config& config) const {
        if (prim.kind == PrimKind::plane) {
            const std::int64_t far = std::int64_t(1) << (config.coord_bits - 1);
            for (int i = 0; i < 8; ++i)
                if (!holds(Vec3l{i & 1 ? far : -far, i & 2 ? far : -far, i & 4 ? far : -far}, 0))
                    return false;
            return true;
        }
        if (prim.kind == PrimKind::sphere) {
            const double own = std::sqrt(double(radius_squared(prim, config.coord_bits)));
            return holds(wide(prim.a), own);
        }
        const double margin = config.is_sheared() ? std::sqrt(3.0) : 0;
        return holds(wide(prim.a), margin) && holds(wide(prim.b), margin) && holds(wide(prim.c), margin);
    }

private:
    static Vec3l wide(const Vec3i& v) { return {v[0], v[1], v[2]}; }
    /// Returns true if |p - centre| + more <= radius; exact if `more` is 0.
    bool holds(const Vec3l& p, double more) const {
        std::int64_t square = 0;
        for (std::size_t k = 0; k < 3; ++k) square += (p[k] - centre[k]) * (p[k] - centre[k]);
        if (more == 0) return square <= radius * radius;
        return std::sqrt(double(square)) + more <= double(radius);
    }
};

/// Reads an image from its root down.
class Reader {
public:
    Reader(const MemoryImage& image, const Config& config) : image_(image), config_(config) {}

    /// Returns all primitives below a node. Calls `see` with each child's globe and the primitives below it.
    using See = std::function<void(std::uint32_t line, std::size_t child, const Written& globe,
                                   const std::vector<PrimData>& prims)>;
    std::vector<PrimData> read(std::uint32_t line, int depth, const See& see) {
        std::vector<PrimData> all;
        if (line >= image_.lines() || !lines_.insert(line).second || wrong.size() >= most_complaints) {
            complain(line, "it is reached twice, or does not exist");
            return all;
        }
        const auto node = unpack<GlobeNode>(image_.line(line), config_);
        ++nodes, this->depth = std::max(this->depth, depth);
        std::uint32_t inner = 0;
        const auto width = std::size_t(config_.node_width);
        for (std::size_t i = 0; i < width; ++i) inner += node.kind[i] == 1;
        std::uint32_t half_line = 2 * (node.base + inner);
        for (std::size_t i = 0; i < width; ++i) {
            const std::uint32_t kind = node.kind[i], before = i == 0 ? 1 : node.kind[i - 1];
            if ((kind == 1 && before != 1) || (kind > 1 && before == 0))
                complain(line, "kinds are out of order");
            if (kind == 0) continue;
            std::vector<PrimData> below;
            if (kind == 1) below = read(node.base + std::uint32_t(i), depth + 1, see);
            leaves += kind > 1;
            for (std::uint32_t n = 1; n < kind; ++n, ++half_line) {
                if (half_line / 2 >= image_.lines() || !halves_.insert(half_line).second) {
                    complain(line, "a primitive is reached twice, or does not exist");
                    continue;
                }
                below.push_back(read_primitive(image_, half_line, config_));
            }
            Written globe;
            for (std::size_t k = 0; k < 3; ++k)
                globe.centre[k] = node.org[k] + (std::int64_t(node.centre[3 * i + k]) << node.exp);
            globe.radius = std::int64_t(node.radius[i]) << node.exp;
            see(line, i, globe, below);
            all.insert(all.end(), below.begin(), below.end());
        }
        return all;
    }
    void complain(std::uint32_t line, const std::string& what) {
        if (wrong.size() < most_complaints)
            wrong.push_back("node in line " + std::to_string(line) + ": " + what);
    }

    std::vector<std::string> wrong;
    std::uint64_t nodes = 0, leaves = 0;
    int depth = 0;

private:
    const MemoryImage& image_;
    const Config& config_;
    std::set<std::uint32_t> lines_, halves_;
};

}   // namespace

std::vector<std::string> check_globes(const MemoryImage& image, const Config& config) {
    Reader reader(image, config);
    const std::vector<PrimData> all = reader.read(
        0, 1, [&](std::uint32_t line, std::size_t child, const Written& globe, const auto& prims) {
            for (const PrimData& prim : prims)
                if (!globe.holds(prim, config)) {
                    reader.complain(line, "primitive " + std::to_string(prim.prim) +
                                              " reaches out of globe " + std::to_string(child));
                    return;
                }
        });
    const CompileReport& report = image.report;
    if (report.nodes != reader.nodes || report.leaves != reader.leaves || report.depth != reader.depth ||
        report.references != all.size())
        reader.complain(0, "the report says another number of nodes, leaves or primitives, or another depth");
    return reader.wrong;
}

GlobeSizes globe_sizes(const MemoryImage& image, const Config& config) {
    GlobeSizes sizes;
    double sum = 0;
    Reader(image, config)
        .read(0, 1, [&](std::uint32_t, std::size_t, const Written& globe, const auto& prims) {
            std::vector<spheres::Bead> beads;
            for (const PrimData& prim : prims) spheres::add_beads(prim, config, beads);
            const double least = spheres::enclose(beads).radius;
            if (least < 1) return;
            const double ratio = double(globe.radius) / least;
            ++sizes.globes;
            sum += ratio;
            sizes.most = std::max(sizes.most, ratio);
        });
    sizes.mean = sizes.globes > 0 ? sum / double(sizes.globes) : 0;
    return sizes;
}

}   // namespace rayclock
