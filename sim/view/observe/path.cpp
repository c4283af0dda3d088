// Repeats the walks of one pixel's rays and records their nodes, tests and hits.
#include "sim/view/observe/path.hpp"

#include <bit>

#include "model/scene/hit.hpp"
#include "model/trace/record_shaded.hpp"
#include "model/trace/walk.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/unit/shade/pass/pass.hpp"

namespace rayclock {

namespace {

/// Records the rays of a shaded pixel and the parent of each.
class Family final : public ShadeWatch {
public:
    std::vector<RayValues> rays;

    void sent(const Ray& ray) override {
        RayValues values;
        values.ray = ray;
        values.purpose = next_;
        values.depth = depth_;
        if (next_ == RayPurpose::shadow)
            values.parent = surface_;
        else if (next_ != RayPurpose::camera)
            values.parent = at_depth_[std::size_t(depth_ - (goes_on_ ? 0 : 1))];
        if (next_ != RayPurpose::shadow) {
            at_depth_.resize(std::size_t(depth_) + 1);
            at_depth_[std::size_t(depth_)] = surface_ = int(rays.size());
        }
        rays.push_back(values);
    }
    void answered(const Closest& hit) override { rays.back().hit = hit; }
    void passed(const PassIn& in, const PassOut& out) override {
        if (out.leave != PassOut::Leave::spawn) return;
        const ShadeEvent event = event_of(in);   // no pass that requests a cut-out's texture sends a ray
        depth_ = int(out.state.depth);
        goes_on_ = event == ShadeEvent::texture;
        next_ = out.spawn.kind == RayKind::camera ? RayPurpose::camera
                : event == ShadeEvent::light      ? RayPurpose::shadow
                : event == ShadeEvent::reflect    ? RayPurpose::reflection
                                                  : RayPurpose::refraction;
    }

private:
    RayPurpose next_ = RayPurpose::camera;
    int depth_ = 0, surface_ = -1;
    bool goes_on_ = false;        ///< the next ray continues through a hole, so it is not a bounce
    std::vector<int> at_depth_;   ///< the last camera ray or bounce at each depth
};

/// Returns the visit whose node has this line among its children, which are contiguous. For a list, returns
/// the previous page.
int parent_of(const Decoder& decoder, const Config& config, const std::vector<VisitValues>& visits,
              std::uint32_t line) {
    if (config.is_list() || visits.empty()) return int(visits.size()) - 1;
    for (std::size_t v = visits.size(); v-- > 0;) {
        const std::uint32_t at = visits[v].line;
        const std::uint32_t base = decoder.below(at).base;
        if (base <= line && line < base + std::uint32_t(visits[v].children)) return int(v);
    }
    return int(visits.size()) - 1;
}

/// Repeats the walk of a ray and records its visits and tests.
Closest note_visits(const Decoder& decoder, const Config& config, Walk& walk, RayValues& values) {
    walk.start_at(values.ray);
    for (bool done = false; !done;) {
        VisitValues visit;
        visit.line = walk.node();
        visit.parent = parent_of(decoder, config, values.visits, visit.line);
        bool more = walk.visit_node();
        visit.children =
            int(config.is_list() ? decoder.page(visit.line).children : decoder.children(visit.line));
        visit.met = walk.enters() ? 0 : std::popcount(walk.met());
        for (; more; more = walk.advance()) {
            TestValues test;
            test.half_line = walk.prim();
            const TriRsp& answer = walk.test_triangle();
            test.closer = answer.closer;
            test.prim = answer.closer ? answer.prim : no_primitive;
            test.t = answer.closer ? answer.t : 0;
            visit.tests.push_back(test);
        }
        visit.dropped = walk.decide(done);
        values.visits.push_back(std::move(visit));
    }
    return walk.closest();
}

}   // namespace

std::vector<RayValues> rays_of_pixel(const MemoryImage& image, const Frame& frame, const Config& config,
                                     std::uint32_t x, std::uint32_t y) {
    const Decoder decoder(image, config);
    Family family;
    if (config.is_stream()) {
        const std::uint32_t ray = y * frame.width + x;
        family.sent(recorded_ray(unpack<RayRecord>(image.record(ray), config), 0, config));
    } else if (config.shading) {
        ShadedRecorder recorder(image, frame, config, decoder);
        RecordScratch scratch(config);
        recorder.follow(x, y, scratch, family);
    } else {
        family.sent(raygen({0, x, y}, frame, config));
    }
    Walk walk(frame, config, decoder);
    for (RayValues& ray : family.rays) {
        const Closest hit = note_visits(decoder, config, walk, ray);
        if (!config.shading || config.is_stream()) ray.hit = hit;
    }
    return std::move(family.rays);
}

}   // namespace rayclock
