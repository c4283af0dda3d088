#include "model/trace/count.hpp"

#include <algorithm>

#include "model/trace/walk.hpp"

namespace rayclock {

namespace {

struct Counter {
    WorkCount& count;
    void visit(const auto& walk) {
        ++count.nodes;
        count.stack = std::max(count.stack, std::size_t(walk.stack_height()));
    }
    void test(std::uint32_t) { ++count.triangles; }
    static void decided(std::uint32_t, bool) {}
};

}   // namespace

WorkCount count_work(const MemoryImage& image, const Frame& frame, const Config& config, int step) {
    WorkCount count;
    const Decoder decoder(image, config);
    Walk walk(frame, config, decoder);
    const auto stride = std::uint32_t(step);
    for (std::uint32_t y = stride / 2; y < frame.height; y += stride)
        for (std::uint32_t x = stride / 2; x < frame.width; x += stride) {
            walk.start({0, x, y});
            walk.run(Counter{count});
            ++count.rays;
            count.hits += walk.closest().found;
        }
    return count;
}

}   // namespace rayclock
