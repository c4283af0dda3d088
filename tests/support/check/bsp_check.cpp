// Walks points through an image of slants in exact integers.
#include "tests/support/check/bsp_check.hpp"

#include <algorithm>
#include <set>

#include "model/layout/words.hpp"
#include "model/engine/bsp/slant.hpp"
#include "model/core/layout.hpp"
#include "model/unit/tri/vectors.hpp"

namespace rayclock {

namespace {

constexpr std::size_t most_complaints = 20;
constexpr int parts = 6;   // parts of an edge: points are in units of a sixth of a step

class Reader {
public:
    Reader(const MemoryImage& image, const Config& config) : image_(image), config_(config) {}

    void walk(std::uint32_t line, int level) {
        if (line >= image_.lines() || wrong.size() >= most_complaints || !lines_.insert(line).second)
            return complain(line, "it is reached twice, or does not exist");
        const auto slant = unpack<Slant>(image_.line(line), config_);
        const WideSlant wide = widen(slant, config_.node_width);
        const WideNode& exits = wide.exits;
        ++nodes, depth = std::max(depth, level);
        for (std::uint32_t i = 0; i < exits.children; ++i) {
            if (exits.inner_mask >> i & 1) {
                walk(exits.base + exits.offset[i] / 2u, level + 1);
                continue;
            }
            ++leaves;
            for (std::uint32_t n = 0; n < exits.count[i]; ++n, ++references) {
                const std::uint32_t half = 2 * exits.base + exits.offset[i] + n;
                if (half / 2 >= image_.lines() || !halves_.insert(half).second)
                    complain(line, "a primitive is reached twice, or does not exist");
            }
        }
    }

    /// Returns true if a leaf whose cell contains x / parts has the primitive.
    bool holds(std::uint32_t line, const Vec3l& x, std::uint32_t prim) const {
        const WideSlant wide = widen(unpack<Slant>(image_.line(line), config_), config_.node_width);
        for (std::size_t k = 0; k < 3 && !wide.open; ++k)
            if (x[k] < parts * std::int64_t(wide.lo[k]) || x[k] > parts * std::int64_t(wide.hi[k]))
                return false;
        const WideNode& exits = wide.exits;
        for (std::uint32_t i = 0; i < exits.children; ++i) {
            if (!is_in(wide, wide.exit[i], x)) continue;
            if (exits.inner_mask >> i & 1) {
                if (holds(exits.base + exits.offset[i] / 2u, x, prim)) return true;
                continue;
            }
            for (std::uint32_t n = 0; n < exits.count[i]; ++n)
                if (read_primitive(image_, 2 * exits.base + exits.offset[i] + n, config_).prim == prim)
                    return true;
        }
        return false;
    }
    void complain(std::uint32_t line, const std::string& what) {
        if (wrong.size() < most_complaints)
            wrong.push_back("node in line " + std::to_string(line) + ": " + what);
    }

    std::vector<std::string> wrong;
    std::uint64_t nodes = 0, leaves = 0, references = 0;
    int depth = 0;

private:
    bool is_in(const WideSlant& wide, std::uint32_t exit, const Vec3l& x) const {
        std::size_t plane = 0;
        for (auto half = std::uint32_t(config_.node_width) / 2; half > 0; half /= 2) {
            const bool upper = exit & half;
            std::int64_t above = -parts * std::int64_t(wide.at[plane]);
            for (std::size_t k = 0; k < 3; ++k) above += wide.normal[plane][k] * x[k];
            if (upper ? above < 0 : above > 0) return false;
            plane = 2 * plane + 1 + upper;
        }
        return true;
    }

    const MemoryImage& image_;
    const Config& config_;
    std::set<std::uint32_t> lines_, halves_;
};

}   // namespace

std::vector<std::string> check_slants(const MemoryImage& image, const std::vector<PrimData>& prims,
                                      const Config& config) {
    Reader reader(image, config);
    reader.walk(0, 1);
    const CompileReport& report = image.report;
    if (report.nodes != reader.nodes || report.leaves != reader.leaves || report.depth != reader.depth ||
        report.references != reader.references)
        reader.complain(0, "the report says another number of nodes, leaves or primitives, or another depth");
    if (!reader.wrong.empty()) return reader.wrong;   // reading such an image might not terminate
    for (const PrimData& prim : prims) {
        if (prim.kind == PrimKind::sphere) continue;
        const int step = prim.kind == PrimKind::plane ? parts : 1;
        for (int i = 0; i <= parts; i += step)
            for (int j = 0; i + j <= parts; j += step) {
                Vec3l x{};
                for (std::size_t k = 0; k < 3; ++k)
                    x[k] = std::int64_t(i) * prim.a[k] + std::int64_t(j) * prim.b[k] +
                           std::int64_t(parts - i - j) * prim.c[k];
                if (!reader.holds(0, x, prim.prim))
                    reader.complain(0, "no leaf has primitive " + std::to_string(prim.prim) + " where it is");
            }
    }
    return reader.wrong;
}

}   // namespace rayclock
