// Traces come from lean forms of the units, for speed. Each must equal the unit's public form, and the
// recorder as a whole must equal the walk.
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/unit/tri/facet.hpp"
#include "model/engine/check.hpp"
#include "model/scene/builtin.hpp"
#include "model/trace/record.hpp"
#include "model/trace/trace.hpp"
#include "model/trace/walk.hpp"
#include "model/engine/bvh/slab.hpp"
#include "model/core/parameters.hpp"
#include "tests/support/cases/box_cases.hpp"
#include "tests/support/cases/tri_cases.hpp"
#include "tests/support/machine/walked.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

__extension__ using Int128 = __int128;

/// Returns the default with some parameters changed.
Config with(std::initializer_list<std::pair<const char*, int>> values) {
    Config config = named_config("default");
    for (const Parameter& p : parameters())
        for (const auto& [key, value] : values)
            if (key == std::string(p.key)) p.set(config, value);
    check_config(config, "test");
    return config;
}
std::vector<Config> corner_configs() {
    return {with({}),
            named_config("small"),
            with({{"coord_bits", 12}, {"dir_bits", 12}}),
            with({{"coord_bits", 20}, {"dir_bits", 22}}),
            with({{"coord_bits", 19}, {"dir_bits", 24}}),
            with({{"dir_bits", 24}, {"recip_bits", 24}}),
            with({{"recip_bits", 8}}),
            with({{"coord_bits", 20}, {"t_frac_bits", 8}, {"recip_bits", 24}}),
            with({{"t_frac_bits", 0}, {"bary_bits", 24}}),
            with({{"bary_bits", 4}, {"box_bits", 4}}),
            with({{"box_bits", 5}, {"node_width", 4}, {"stack_depth", 64}}),
            with({{"box_bits", 7}, {"leaf_size", 6}}),
            with({{"node_width", 2}, {"stack_depth", 64}}),
            with({{"node_width", 4}, {"stack_depth", 64}, {"leaf_size", 3}})};
}

/// Returns the corner configurations and one for each primitive test.
std::vector<Config> configs_of_traces() {
    std::vector<Config> all = corner_configs();
    for (int test = 1; test < int(names_of<PrimitiveTest>().size()); ++test)
        all.push_back(with({{"primitive_test", test}}));
    all.push_back(with({{"primitive_test", 1}, {"coord_bits", 12}, {"dir_bits", 14}, {"leaf_size", 6}}));
    return all;
}

bool same_node(const WideNode& a, const WideNode& b) {
    return a.org == b.org && a.exp == b.exp && a.base == b.base && a.children == b.children &&
           a.children_mask == b.children_mask && a.inner_mask == b.inner_mask && a.planes == b.planes &&
           a.offset == b.offset && a.count == b.count;
}

std::vector<std::uint32_t> walked(Walk& walk, const Slot& slot) {
    std::vector<std::uint32_t> words;
    walk.start(slot);
    append_walk(walk, words);
    return words;
}

}   // namespace

TEST_CASE("a node read straight from its line is the node unpacked", "[trace]") {
    for (const Config& config : corner_configs()) {
        Draw draw{1};
        const NodeReader read{config};
        for (int i = 0; i < 2000; ++i) {
            Node node = random_node(draw, config, draw.vector(config.coord_bits));
            if (draw.coin())
                for (auto& e : node.exp) e = std::uint32_t(draw.natural(exp_bits));
            Words line = pack(node, config);
            // Bits above the node are arbitrary.
            for (std::size_t k = std::size_t(bits_of<Node>(config)); k < line_bits; ++k)
                if (line.size() <= k / 32) line.push_back(std::uint32_t(draw.bits(32)));
            REQUIRE(
                same_node(read(line.data()), widen(unpack<Node>(line.data(), config), config.node_width)));
        }
    }
}

TEST_CASE("box gives the same answers with and without wide vector instructions", "[trace]") {
    for (const Config& config : corner_configs()) {
        Draw draw{2};
        for (int i = 0; i < 3000; ++i) {
            const BoxCase c = random_box_case(draw, config);
            const NodeAnswer fast = box(c.req, config), plain = box(c.req, config, box_children_plain);
            REQUIRE(same(fast, plain, config));
            if (i % 10 == 0) judge(c, plain, config);
        }
    }
}

TEST_CASE("children are sorted by distance, then place", "[trace]") {
    Draw draw{3};
    for (std::uint32_t set = 0; set < 256; ++set)
        for (int round = 0; round < 20; ++round) {
            std::array<std::uint32_t, max_width> t_near;
            for (auto& t : t_near) t = std::uint32_t(draw.coin() ? draw.below(3) : draw.natural(31));
            std::vector<std::uint64_t> expected;
            for (std::uint32_t i = 0; i < max_width; ++i)
                if (set >> i & 1) expected.push_back(std::uint64_t(t_near[i]) << 3 | i);
            std::sort(expected.begin(), expected.end());
            std::array<std::uint64_t, max_width> sorted;
            REQUIRE(sort_children(set, t_near.data(), sorted.data()) == expected.size());
            REQUIRE(std::equal(expected.begin(), expected.end(), sorted.begin()));
        }
}

TEST_CASE("a quotient made with doubles is the whole number below", "[trace]") {
    Draw draw{4};
    const Int128 most = (Int128(1) << 33) - 1;
    for (int i = 0; i < 200000; ++i) {
        const int shift = draw.between(4, 31);
        const auto det = std::int64_t(std::max<std::uint64_t>(1, draw.natural(draw.between(1, 63))));
        auto num = std::int64_t(draw.natural(draw.between(1, 62)));
        // Half of the quotients are whole numbers, or differ from one by the least amount.
        if (draw.coin()) {
            const Int128 product = (Int128(det) * Int128(draw.natural(33))) >> shift;
            num = std::int64_t(std::clamp<Int128>(product + draw.between(-1, 1), 0, (Int128(1) << 62) - 1));
        }
        const Int128 exact = (Int128(num) << shift) / det;
        const Quotient q = quotient(num, shift, det);
        CAPTURE(num, shift, det);
        REQUIRE(q.whole == std::uint64_t(std::min(exact, most)));
        if (exact < most) REQUIRE(q.rest == ((Int128(num) << shift) % det != 0));
    }
}

TEST_CASE("a reciprocal made with doubles is the whole number below", "[trace]") {
    for (const Config& config : corner_configs()) {
        const std::int32_t most = 1 << (config.dir_bits - 1), step = std::max(1, most >> 14);
        for (std::int32_t d = 1; d <= most; d += d < 4096 || d > most - 4096 ? 1 : step) {
            const int len = std::bit_width(std::uint32_t(d));
            const std::uint64_t m = std::uint64_t(d) << (config.dir_bits - len);
            const std::uint64_t power = std::uint64_t(1) << (config.dir_bits + config.recip_bits - 1);
            const Recip r = reciprocal(d, config), negative = reciprocal(-d, config);
            const bool right = r.recip == power / m && r.len == std::uint32_t(len);
            if (!right || negative.recip != r.recip || negative.len != r.len) FAIL(d);
        }
    }
}

TEST_CASE("a triangle seen from a point is the triangle", "[trace]") {
    int ahead = 0, edges = 0;
    for (const Config& config : corner_configs()) {
        Draw draw{5};
        for (int i = 0; i < 5000; ++i) {
            TriReq req = random_tri_req(draw, config);
            req.best = {};
            const TriRsp rsp = tri(req, config);
            const Facet facet = make_facet(req.triangle, req.o);
            const Edges<std::int64_t> hit = test_facet(facet, req.d);
            REQUIRE(facet.prim == req.triangle.prim);
            if (hit.on_edge())
                ++edges;
            else
                REQUIRE((rsp.closer != 0) == (hit.ahead() && hit.num != 0));
            if (!rsp.closer) continue;
            ++ahead;
            const std::int64_t sign = hit.det < 0 ? -1 : 1;
            REQUIRE(rsp.det == sign * hit.det);
            REQUIRE(rsp.num == sign * hit.num);
            const auto num = std::int64_t(rsp.num), det = std::int64_t(rsp.det);
            REQUIRE(rsp.t == distance(num, det, config));
            REQUIRE(rsp.u == barycentric(sign * hit.u, det, config));
            REQUIRE(rsp.v == barycentric(sign * hit.v, det, config));
        }
    }
    REQUIRE(ahead > 1000);
    REQUIRE(edges > 1000);
}

TEST_CASE("a trace is what the walk walks, with the processor's wider vectors and without", "[trace]") {
    const auto name = GENERATE("gears:1", "balls:1", "mount:4", "rings:1", "cornell");
    for (const Config& config : configs_of_traces()) {
        Scene scene = make_builtin(name);
        const FrameSize size{37, 21};
        if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
        const MemoryImage image = compile_scene(scene, scene.camera->eye, config);
        const Frame frame = make_frame(*scene.camera, size, image.lattice, config);
        const Trace trace = record_trace(image, frame, config, 1);
        const Decoder decoder(image, config);
        const RecordJob job(image, frame, config);
        RecordScratch scratch(config);
        RecordTotals totals;
        std::vector<Closest> hits(trace.hits.size());
        Walk walk(frame, config, decoder);
        const std::uint32_t side = RecordBlock::side;
        for (std::uint32_t y0 = 0; y0 < frame.height; y0 += side)
            for (std::uint32_t x0 = 0; x0 < frame.width; x0 += side) {
                const RecordBlock block{x0, y0, std::min(x0 + side, frame.width),
                                        std::min(y0 + side, frame.height)};
                record_block_plain(job, block, scratch, hits.data(), totals);
                std::size_t n = 0;
                for (std::uint32_t y = y0; y < block.y1; ++y)
                    for (std::uint32_t x = x0; x < block.x1; ++x, ++n) {
                        const std::size_t pixel = std::size_t(y) * frame.width + x;
                        const auto expected = walked(walk, {0, x, y});
                        CAPTURE(config.node_width, config.leaf_size, config.primitive_test, x, y);
                        REQUIRE(std::equal(expected.begin(), expected.end(), trace.rays[pixel]));
                        REQUIRE(
                            std::equal(expected.begin(), expected.end(), &scratch.words[scratch.starts[n]]));
                        REQUIRE(same(trace.hits[pixel], walk.closest(), config));
                        REQUIRE(same(hits[pixel], walk.closest(), config));
                    }
            }
        REQUIRE(totals.visits == trace.visits);
        REQUIRE(totals.box_tests == trace.box_tests);
        REQUIRE(totals.triangle_tests == trace.triangle_tests);
        REQUIRE(totals.dropped_groups == trace.dropped_groups);
    }
}
