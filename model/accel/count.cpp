#include "model/accel/count.hpp"

#include "model/accel/decode.hpp"
#include "model/isect/primitive.hpp"
#include "model/raygen/raygen.hpp"
#include "model/bvh/box.hpp"

namespace rayclock {

namespace {

/// One ray's walk.
class Walk {
public:
    Walk(const MemoryImage& image, const Config& config, const Ray& ray, WorkCount& count)
        : image_(image),
          config_(config),
          ray_(ray),
          count_(count),
          test_(tri_test_of(config)),
          t_best_((1u << config.t_bits()) - 1) {
        box_ray_ = {ray.o, {ray.d[0] < 0, ray.d[1] < 0, ray.d[2] < 0}, ray.recip, ray.len};
    }

    void run(std::uint32_t root) {
        visit(root);
        while (!stack_.empty()) {
            Group& group = stack_.back();
            if (group.next == group.boxes.inner || group.boxes.t_near[group.next] > t_best_) {
                stack_.pop_back();
                continue;
            }
            const std::uint32_t line = group.boxes.base + group.boxes.offset[group.next++] / 2;
            if (group.next == group.boxes.inner)
                stack_.pop_back();   // the last sibling leaves nothing to keep
            count_.stack = std::max(count_.stack, stack_.size());
            visit(line);
        }
        ++count_.rays;
        count_.hits += best_.found;
    }

private:
    struct Group {
        BoxRsp boxes;
        std::size_t next = 0;
    };

    void visit(std::uint32_t line) {
        ++count_.nodes;
        BoxRsp boxes;
        box_children(box_ray_, widen(read_node(image_, line, config_), config_.node_width), config_, boxes);
        for (std::size_t i = boxes.inner; i < boxes.inner + boxes.leaves && boxes.t_near[i] <= t_best_; ++i)
            for (std::uint32_t n = 0; n < boxes.count[i]; ++n) test(2 * boxes.base + boxes.offset[i] + n);
        if (boxes.inner > 0) stack_.push_back({boxes});
    }

    void test(std::uint32_t half_line) {
        ++count_.triangles;
        TriRsp rsp;
        test_(ray_.o, ray_.d, read_triangle(image_, half_line, config_), best_, config_, rsp);
        if (!rsp.closer) return;
        best_ = {1, rsp.num, rsp.det, rsp.prim};
        t_best_ = rsp.t;
    }

    const MemoryImage& image_;
    const Config& config_;
    const Ray& ray_;
    WorkCount& count_;
    TriTest* test_;
    BoxRay box_ray_;
    std::vector<Group> stack_;
    Best best_;
    std::uint32_t t_best_;
};

}   // namespace

WorkCount count_work(const MemoryImage& image, const Frame& frame, const Config& config, int step) {
    WorkCount count;
    const auto stride = std::uint32_t(step);
    for (std::uint32_t y = stride / 2; y < frame.height; y += stride)
        for (std::uint32_t x = stride / 2; x < frame.width; x += stride) {
            const Ray ray = raygen({0, x, y}, frame, config);
            Walk{image, config, ray, count}.run(frame.root);
        }
    return count;
}

}   // namespace rayclock
