// The torture set reaches the corners of textures and of their holes.
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "model/trace/record_shaded.hpp"
#include "sim/explore/torture/torture.hpp"

using namespace rayclock;

namespace {

/// The values of textures and holes that the frames of a chip reach.
class Reached final : public ShadeWatch {
public:
    std::map<std::string, std::set<std::int64_t>> values;
    std::size_t surfaces = 0, textured = 0;   ///< hits of triangles, and hits of triangles with a texture

    explicit Reached(const Config& config) : config_(config) {}
    void use(const Frame& frame) { values["spread"].insert(frame.shade.spread); }

    void sent(const Ray& ray) override { values["holes that a ray to a light passes"].insert(ray.holes); }
    void answered(const Closest&) override {}
    void passed(const PassIn& in, const PassOut& out) override {
        const bool is_arrival = !meets_cutout(in) && event_of(in) == ShadeEvent::arrive && in.hit.found;
        if (is_arrival && in.surface.kind == PrimKind::triangle)
            ++surfaces, textured += in.surface.record != 0;
        if (meets_cutout(in)) values["a cut-out has a texture"].insert(in.surface.record != 0);
        if (in.state.pending == Pending::texture && in.hole)
            values["holes in the way to a light"].insert(in.state.light_holes + 1);
        values["holes that a ray passes"].insert(out.state.holes);
    }
    void filtered(const TexReq& hit, const TexRecord& record, const TexelPlace& place,
                  const TexRsp& answer) override {
        values["filter"].insert(9 * record.nearest + 3 * std::uint32_t(record.wrap_s) +
                                std::uint32_t(record.wrap_t));
        for (const std::uint32_t side : {record.log_width, record.log_height}) values["side"].insert(side);
        values["level"].insert(place.level);
        values["last level"].insert(record.last_level);
        values["level is the last"].insert(place.level == record.last_level);
        values["path is at or beyond the end of t"].insert(hit.path >= (1u << config_.t_bits()) - 1);
        values["scale is 0"].insert(hit.scale == 0);
        values["density"].insert(record.density);
        for (const auto& corners : {record.s, record.t})
            for (const std::int32_t x : corners) values["coordinate"].insert(x);
        values["hole at cut-off " + std::to_string(record.cutoff)].insert(answer.hole);
    }

private:
    const Config& config_;
};

/// Walks every pixel of every frame of a chip.
void walk(const std::string& chip, Reached& reached) {
    for (const TortureCase& torture : torture_cases(chip)) {
        const Config& config = torture.job.config;
        MemoryImage image = torture.job.image;
        for (std::size_t f = 0; f < torture.frames.size(); ++f) {
            Upload upload = f < torture.uploads.size() ? torture.uploads[f] : Upload{};
            apply(upload, image);
            const Frame& frame = torture.frames[f];
            const Decoder decoder(image, config);
            ShadedRecorder recorder(image, frame, config, decoder);
            RecordScratch scratch(config);
            reached.use(frame);
            for (std::uint32_t y = 0; y < frame.height; ++y)
                for (std::uint32_t x = 0; x < frame.width; ++x) recorder.follow(x, y, scratch, reached);
        }
    }
}

}   // namespace

TEST_CASE("the torture set has chips with and without textures, and both formats of texels", "[textures]") {
    std::set<int> formats, levels;
    bool plain = false;
    for (const std::string& chip : torture_chips()) {
        const Config c = torture_chip(chip);
        plain = plain || (c.has_shade() && !c.textures);
        if (!c.has_textures()) continue;
        formats.insert(int(c.texels)), levels.insert(c.levels);
    }
    CHECK(plain);
    CHECK(formats == std::set<int>{int(TexelFormat::rgb888), int(TexelFormat::rgb565)});
    CHECK(levels == std::set<int>{1, 2});
}

TEST_CASE("the torture set reaches the corners of textures and holes", "[textures]") {
    for (const std::string& chip : torture_chips()) {
        const Config config = torture_chip(chip);
        if (!config.has_textures()) continue;
        INFO(chip);
        Reached reached(config);
        walk(chip, reached);
        auto& values = reached.values;
        const std::set<std::int64_t> both{0, 1};

        CHECK(4 * reached.textured > reached.surfaces);
        CHECK(values["filter"].size() == 2 * 3 * 3);
        CHECK(values["side"].contains(0));
        CHECK(values["side"].contains(max_side_log));
        CHECK(values["level"].contains(0));
        CHECK(values["level"].contains(max_side_log));
        CHECK(values["level"].size() > max_side_log * 2 / 3);
        CHECK(values["last level"].contains(0));
        for (const char* name :
             {"level is the last", "path is at or beyond the end of t", "a cut-out has a texture"}) {
            INFO(name);
            CHECK(values[name] == both);
        }
        if (config.has_homes()) CHECK(values["scale is 0"] == both);
        const auto reaches_ends = [&](const char* name, int bits) {
            INFO(name);
            const std::int64_t most = (1 << (bits - 1)) - 1;
            CHECK(*values[name].begin() <= 1 - most);
            CHECK(*values[name].rbegin() >= most - 1);
        };
        reaches_ends("density", level_bits);
        reaches_ends("spread", level_bits);
        reaches_ends("coordinate", coordinate_bits);
        CHECK(values["hole at cut-off 0"] == std::set<std::int64_t>{0});
        for (const int cutoff : {1, 128, 255}) {
            INFO("cut-off " << cutoff);
            CHECK(values["hole at cut-off " + std::to_string(cutoff)] == both);
        }
        CHECK(*values["holes that a ray passes"].rbegin() == max_holes);
        CHECK(*values["holes that a ray to a light passes"].rbegin() == max_holes);
        CHECK(*values["holes in the way to a light"].rbegin() == max_holes + 1);
    }
}
