#include "model/reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "model/reference/hierarchy.hpp"
#include "model/reference/ray.hpp"
#include "model/reference/unit_space.hpp"

namespace rayclock {
namespace {

constexpr int tile_side = 32;

std::vector<RefBox> triangle_boxes(const Scene& scene, const RefUnitSpace& space) {
    std::vector<RefBox> boxes(scene.triangles.size());
    tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
        const auto& vertex = scene.triangles[i].vertex;
        const glm::dvec3 a = space(scene.vertices[vertex[0]]), b = space(scene.vertices[vertex[1]]),
                         c = space(scene.vertices[vertex[2]]);
        const glm::dvec3 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
        for (int k = 0; k < 3; ++k) {
            boxes[i].lo[k] = float_below(lo[k]);
            boxes[i].hi[k] = float_above(hi[k]);
        }
        boxes[i].primitive = static_cast<std::uint32_t>(i);
    });
    return boxes;
}

std::vector<RefBlock> gather_blocks(const Scene& scene, const RefUnitSpace& space,
                                    const std::vector<std::uint32_t>& order) {
    std::vector<RefBlock> blocks(order.size() / ref_block_size);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        for (int lane = 0; lane < ref_block_size; ++lane) {
            const std::uint32_t primitive = order[i * ref_block_size + lane];
            blocks[i].primitive[lane] = primitive;
            for (int v = 0; v < 3; ++v) {
                const glm::dvec3 p = space(scene.vertices[scene.triangles[primitive].vertex[v]]);
                for (int k = 0; k < 3; ++k) blocks[i].vertex[v][k][lane] = p[k];
            }
        }
    });
    return blocks;
}

} // namespace

struct Reference::Impl {
    RefUnitSpace space;
    std::vector<RefNode> nodes;
    std::vector<RefBlock> blocks;

    explicit Impl(const Scene& scene) : space(scene) {
        std::vector<RefBox> boxes = triangle_boxes(scene, space);
        RefHierarchy hierarchy = build_hierarchy(boxes);
        nodes = std::move(hierarchy.nodes);
        blocks = gather_blocks(scene, space, hierarchy.order);
    }

    RefClosest closest(const RefRay& ray) const;
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const;
};

/// Nearest child first. The answer is the smallest (depth, primitive) of all accepted triangles and a box is
/// skipped only if it begins beyond the closest hit, so the order of the visit does not matter.
RefClosest Reference::Impl::closest(const RefRay& ray) const {
    struct Entry {
        std::uint32_t child, blocks;
        float near;
    };
    Entry stack[ref_stack_size];
    stack[0] = {0, 0, 0};
    int top = nodes.empty() ? 0 : 1;
    RefClosest best;
    float limit = std::numeric_limits<float>::infinity();
    while (top > 0) {
        const Entry entry = stack[--top];
        if (entry.near > limit) continue;
        if (entry.blocks == 0) {
            const RefNode& node = nodes[entry.child];
            RefFloat4 near;
            int entered = boxes_entered(node, ray, limit, near);
            const int base = top;
            for (; entered != 0; entered &= entered - 1) {
                const int i = std::countr_zero(static_cast<unsigned>(entered));
                int place = top++;
                for (; place > base && stack[place - 1].near < near[i]; --place) stack[place] = stack[place - 1];
                stack[place] = {node.child[i], node.blocks[i], near[i]};
            }
        } else {
            for (std::uint32_t i = 0; i < entry.blocks; ++i) test_block(blocks[entry.child + i], ray, best);
            limit = float_above(best.depth) * slab_margin;
        }
    }
    return best;
}

Hit Reference::Impl::trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
    // Scaled by the largest component first: the square of a very short or long direction would not fit.
    const glm::dvec3 size = glm::abs(direction);
    const double largest = std::max(size.x, std::max(size.y, size.z));
    const bool has_direction = largest > 0 && std::isfinite(size.x + size.y + size.z);
    const glm::dvec3 from = space(origin);
    if (!has_direction || !std::isfinite(from.x + from.y + from.z)) return {};
    const RefClosest found = closest(RefRay(from, glm::normalize(direction / largest)));
    if (found.primitive == no_primitive) return {};
    return {found.primitive, static_cast<float>(found.depth / space.scale), static_cast<float>(found.u),
            static_cast<float>(found.v)};
}

Reference::Reference(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Reference::~Reference() = default;
Reference::Reference(Reference&&) noexcept = default;

Hit Reference::trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return impl_->trace(origin, direction);
}

HitFrame Reference::frame(const Camera& camera, FrameSize size, int threads, const Progress& progress) const {
    check_frame_size(size);
    const PixelRays rays = pixel_rays(camera, size);
    HitFrame frame{size, std::vector<Hit>(static_cast<std::size_t>(size.width) * size.height)};
    std::mutex reporting;
    std::uint64_t done = 0;
    const auto trace_tile = [&](const tbb::blocked_range2d<int>& tile) {
        for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
            for (int x = tile.cols().begin(); x < tile.cols().end(); ++x)
                frame.hits[static_cast<std::size_t>(y) * size.width + x]
                    = impl_->trace(rays.eye, rays.direction(x, y));
        if (!progress) return;
        const std::lock_guard lock(reporting);
        done += tile.rows().size() * tile.cols().size();
        progress("reference", done, frame.hits.size());
    };
    const int cores = tbb::this_task_arena::max_concurrency();
    tbb::task_arena arena(threads > 0 ? std::min(threads, cores) : cores);
    arena.execute([&] {
        const tbb::blocked_range2d<int> pixels(0, size.height, tile_side, 0, size.width, tile_side);
        tbb::parallel_for(pixels, trace_tile, tbb::simple_partitioner{});
    });
    return frame;
}

} // namespace rayclock
