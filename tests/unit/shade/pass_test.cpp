// pass: the work of the unit shade on a context; compares its RTL with the model.
#include <cmath>
#include <deque>
#include <map>
#include <optional>

#include <catch2/catch.hpp>

#include "model/scene/texture.hpp"
#include "model/unit/shade/surface/surf.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "tests/support/cases/pass_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

void put(RtlModule& rtl, const char* name, std::uint32_t value) {
    std::memcpy(rtl.port(name).data, &value, rtl.port(name).bytes);
}
Words got(const RtlModule& rtl, const char* name) {
    Words words((rtl.port(name).bytes + 3) / 4);
    std::memcpy(words.data(), rtl.port(name).data, rtl.port(name).bytes);
    return words;
}
void put_vector(RtlModule& rtl, const char* name, const Vec3i& v, int bits) {
    Words words(std::size_t(3 * bits + 31) / 32, 0);
    PackVisitor pack{words, 3 * bits};
    pack("", v, bits, 3);
    copy_words(rtl.port(name), words);
}

/// Clears the fields of units that the chip does not have.
ShadeState seen(ShadeState s, const Config& c) {
    if (!c.supersampling) s.sample = 0, s.sum = s.least = s.most = {};
    return s;
}

/// shade_place_t: the fields of an instance that a pass uses.
struct Place {
    Placement placement;
    template <class V> void fields(V& v, const Config& c) {
        placement.here = placement.home();
        v("here", placement.here, c.addr_bits);
        if (c.has_textures()) v("texel_scale", placement.texel_scale, level_bits);
        v("a", placement.a, c.map_bits(), 9);
        v("b", placement.b, c.coord_bits + c.map_frac(), 3);
    }
};

void drive(RtlModule& rtl, const PassIn& in, const Config& c) {
    put(rtl, "ray", in.ray);
    set_data(rtl.port("state"), seen(in.state, c), c);
    Closest hit = in.hit;
    hit.ray = 0;
    set_data(rtl.port("hit"), hit, c);
    put_vector(rtl, "o", in.o, c.origin_width());
    put_vector(rtl, "d", in.d, c.dir_bits);
    set_data(rtl.port("surface"), in.surface, c);
    if (c.has_textures()) set_data(rtl.port("texel"), TexRsp{0, in.hole, in.texel}, c);
    if (c.has_homes()) set_data(rtl.port("place"), Place{in.placement}, c);
}

/// Ignores groups that have not changed, because they are not written. The material was written when the pass
/// began (judge_look).
ShadeState written(ShadeState s, const ShadeChanges& changes, const ShadeState& kept,
                   const ShadeState& wanted) {
    if (!changes.point) s.o = kept.o, s.normal = kept.normal, s.view = kept.view, s.cosine = kept.cosine;
    if (!changes.inner) s.inner = kept.inner;
    if (!changes.face) s.n = kept.n, s.is_far = kept.is_far, s.is_lost = kept.is_lost;
    if (!changes.albedo) s.albedo = kept.albedo;
    if (!changes.share) s.share = kept.share;
    s.diffuse = wanted.diffuse, s.highlight = wanted.highlight, s.mirror = wanted.mirror,
    s.shine = wanted.shine;
    s.transmit = wanted.transmit, s.ratio = wanted.ratio, s.schlick = wanted.schlick, s.r0 = wanted.r0;
    s.self = wanted.self, s.is_inside = wanted.is_inside;
    s.ambient = wanted.ambient, s.record = wanted.record;
    return s;
}

template <class P> void compare(const RtlModule& rtl, const char* name, const P& expected, const Config& c) {
    Words words = got(rtl, name), wanted = pack(expected, c);
    words.resize(wanted.size());
    if (words != wanted) FAIL(name << " is not the model's");
}

void judge(const RtlModule& rtl, const PassIn& in, const Frame& frame, const Config& c) {
    CAPTURE(in.state.next_event, in.surface.kind, in.hit.found, in.state.waiting);
    CAPTURE(in.hole, in.state.holes, in.texel, in.state.albedo, in.state.ambient, in.state.colour);
    const PassOut out = pass(in, frame, c);
    REQUIRE(got(rtl, "end_ray")[0] == in.ray);
    REQUIRE(got(rtl, "leave")[0] == std::uint32_t(out.leave));
    const ShadeState state =
        written(get_data<ShadeState>(rtl.port("end_state"), c),
                get_data<ShadeChanges>(rtl.port("changes"), c), seen(in.state, c), out.state);
    CAPTURE(state.next_event, out.state.next_event, state.colour, out.state.colour, state.o, out.state.o,
            state.n, out.state.n, state.normal, out.state.normal);
    CAPTURE(state.view, out.state.view, state.cosine, out.state.cosine, state.is_far, out.state.is_far,
            state.albedo, out.state.albedo);
    CAPTURE(state.share, out.state.share, state.light, out.state.light, state.pending, out.state.pending,
            state.weight, out.state.weight);
    REQUIRE(pack(seen(state, c), c) == pack(seen(out.state, c), c));
    REQUIRE(got(rtl, "push")[0] == std::uint32_t(out.push));
    if (out.push) compare(rtl, "pushed", out.pushed, c);
    if (out.leave == PassOut::Leave::spawn) {
        const auto sent = get_data<Spawn>(rtl.port("spawn"), c);
        CAPTURE(sent.o, out.spawn.o, sent.d, out.spawn.d, sent.home.line, out.spawn.home.line, sent.home.o,
                out.spawn.home.o, sent.home.d, out.spawn.home.d);
        compare(rtl, "spawn", out.spawn, c);
    }
    if (out.leave == PassOut::Leave::pixel) compare(rtl, "pixel", out.pixel, c);
    if (out.leave == PassOut::Leave::texture) compare(rtl, "tex_req", out.tex, c);
}

/// Counts the bits of a state's material: of its fields from diffuse on, which are its lowest bits.
struct MaterialBits {
    int bits = 0;
    bool counts = false;
    template <class T> void operator()(const std::string_view name, const T&, int width, int count = 1) {
        counts = counts || name == "diffuse";
        if (counts) bits += width * count;
    }
};

/// Requires that the material of a hit surface is driven when the pass begins, and only then.
void judge_look(const RtlModule& rtl, const std::optional<PassIn>& in, const Frame& frame, const Config& c) {
    const bool looks = in && in->state.next_event == ShadeEvent::arrive && in->hit.found;
    REQUIRE(got(rtl, "material_valid")[0] == std::uint32_t(looks));
    if (!looks) return;
    REQUIRE(got(rtl, "material_ray")[0] == in->ray);
    const Words wanted = pack(pass(*in, frame, c).state, c), told = got(rtl, "material");
    MaterialBits material;
    ShadeState{}.fields(material, c);
    for (int at = 0; at < material.bits; ++at) {
        const auto bit = [&](const Words& words) { return words[std::size_t(at / 32)] >> (at % 32) & 1; };
        if (bit(told) != bit(wanted)) FAIL("bit " << at << " of the material is not the model's");
    }
}

/// Runs random passes, with idle cycles in between if `idle`, and checks every answer in its exact cycle.
/// Counts the outcomes.
void run(const Config& c, unsigned seed, int count, bool idle, std::map<int, int>& seen_leaves, int& pushes) {
    Draw draw{seed};
    const Frame frame = random_shade_frame(draw, c);
    RtlModule rtl(c, "rc_pass", int(seed));
    set_data(rtl.port("frame"), frame.shade, c);
    put(rtl, "valid", 0);
    rtl.reset();
    std::deque<std::optional<PassIn>> under_way(std::size_t(c.pass_latency()), std::nullopt);
    for (int i = 0, opens = 0; i < count * c.shade_interval; ++i) {
        INFO(c.name << ", seed " << seed << ", cycle " << i);
        const bool valid = i >= opens && (!idle || draw.coin());
        if (valid) opens = i + c.shade_interval;
        under_way.push_back(valid ? std::optional(random_pass(draw, frame, c)) : std::nullopt);
        put(rtl, "valid", valid);
        if (valid) drive(rtl, *under_way.back(), c);
        // If a pass stays for several cycles, its waiting ray comes exactly one cycle later.
        const std::optional<PassIn>& entering = under_way[under_way.size() - (c.shade_interval == 1 ? 1 : 2)];
        set_data(rtl.port("top"), entering ? entering->top : Waiting{}, c);
        rtl.settle();
        judge_look(rtl, entering, frame, c);
        const std::optional<PassIn> due = under_way.front();
        under_way.pop_front();
        REQUIRE(got(rtl, "end_valid")[0] == std::uint32_t(due.has_value()));
        if (due) {
            judge(rtl, *due, frame, c);
            const PassOut out = pass(*due, frame, c);
            const int event = meets_cutout(*due) ? 8 : passes_hole(*due) ? 9 : int(due->state.next_event);
            ++seen_leaves[8 * event + int(out.leave)];
            pushes += out.push;
        }
        rtl.clock();
    }
}

void check(const char* name, unsigned first_seed, int frames, int count) {
    const Config c = shaded_format(name);
    std::map<int, int> seen_leaves;
    int pushes = 0;
    for (unsigned seed = first_seed; seed < first_seed + unsigned(frames); ++seed)
        run(c, seed, count, seed % 2 != 0, seen_leaves, pushes);
    const auto times = [&](ShadeEvent event, PassOut::Leave leave) {
        return seen_leaves[8 * int(event) + int(leave)];
    };
    using enum PassOut::Leave;
    REQUIRE(times(ShadeEvent::arrive, again) > 50);
    REQUIRE(times(ShadeEvent::light, spawn) > 20);
    REQUIRE(times(ShadeEvent::light, again) > 20);
    REQUIRE(times(ShadeEvent::reflect, spawn) > 20);
    REQUIRE(times(ShadeEvent::reflect, again) > 20);
    REQUIRE(times(ShadeEvent::pop, pixel) > 5);
    if (c.refraction)
        REQUIRE((times(ShadeEvent::refract, again) > 20 && pushes > 5 && times(ShadeEvent::pop, spawn) > 20));
    if (c.has_homes()) REQUIRE(times(ShadeEvent::transform, again) > 50);
    if (c.has_textures()) {
        REQUIRE(times(c.has_homes() ? ShadeEvent::transform : ShadeEvent::arrive, texture) > 30);
        REQUIRE(times(ShadeEvent::texture, again) > 50);
        REQUIRE(times(ShadeEvent::texture, spawn) > 20);
        REQUIRE(times(ShadeEvent(8), texture) > 20);   // a cut-out requests its texture
        REQUIRE(times(ShadeEvent(8), again) > 10);     // or has none
        REQUIRE(times(ShadeEvent(9), spawn) > 10);     // another ray to the same light
    }
}

/// Draws a direction along or near an axis, a face diagonal or a space diagonal, of full length or shorter.
Vec3i random_corner_direction(Draw& draw, const Config& c) {
    const std::int32_t most = (1 << (c.dir_bits - 1)) - 1, size = most >> draw.below(c.dir_bits);
    Vec3i d{};
    for (auto& x : d) {
        const std::int32_t beside = std::clamp(size * draw.between(-1, 1) + draw.between(-2, 2), -most, most);
        x = draw.percent(10) ? -most - 1 : beside;
    }
    return d;
}

/// Returns |d| in 128ths of 2^(M-1), and the length of the path, not saturated. |d| counts as its largest
/// component, 1/4 + 1/8 of the second one and 1/4 + 1/16 of the smallest one, each rounded down.
std::pair<std::int64_t, std::int64_t> wanted_path(std::uint32_t before, const Vec3i& d, std::uint32_t t,
                                                  const Config& c) {
    std::array<std::int64_t, 3> size{};
    for (std::size_t k = 0; k < 3; ++k) size[k] = std::abs(std::int64_t(d[k]));
    std::ranges::sort(size);
    const std::int64_t sum = size[2] + size[1] / 4 + size[1] / 8 + size[0] / 4 + size[0] / 16,
                       length = sum * 128 / (1 << (c.dir_bits - 1));
    return {length, before + length * t / 128};
}

}   // namespace

TEST_CASE("the RTL's pass is the model's, after exactly its latency, one in a cycle",
          "[pass][lockstep][all]") {
    check("all", 1, 12, 400);
}

TEST_CASE("the RTL's pass is the model's without units that are not needed, and at the ends of the lattice",
          "[pass][lockstep]") {
    const auto name = GENERATE("plain", "narrow");
    check(name, 1, 12, 400);
}

TEST_CASE("the RTL's pass is the model's if it stays in each stage for several cycles",
          "[pass][lockstep][interval][long]") {
    check("every8:fast:all", 1, 4, 400);   // the configuration with the most registers
}

TEST_CASE("the RTL's pass is the model's with instances", "[pass][lockstep][levels]") {
    const auto name = GENERATE("levels:mirror", "every8:fast:levels:all");
    check(name, 1, 4, 400);
}

TEST_CASE("the RTL's pass is the model's with textures", "[pass][lockstep][textures]") {
    check("textured:all", 1, 8, 400);
}

TEST_CASE("the RTL's pass is the model's with textures and instances, if it stays for several cycles",
          "[pass][lockstep][textures][interval][long]") {
    check("textured:every8:fast:levels:all", 1, 4, 800);
}

TEST_CASE("a path is as long as its rays together, rounded down and saturated", "[pass][textures]") {
    const Config c = shaded_format(GENERATE("textured:all", "textured:narrow", "textured:short"));
    Draw draw{17};
    int saturated = 0, longer = 0;
    for (int i = 0; i < 50000; ++i) {
        const Frame frame = i % 1000 == 0 ? random_shade_frame(draw, c) : Frame{};
        PassIn in = without_cutout(random_pass(draw, frame, c));
        in.state.next_event = ShadeEvent::arrive, in.hit.found = 1;
        if (draw.percent(10)) in.d[std::size_t(draw.below(3))] = -(1 << (c.dir_bits - 1));
        if (draw.percent(20)) in.d = random_corner_direction(draw, c);
        if (in.surface.kind == PrimKind::plane) in.hit.t >>= 1;   // not too far away for t
        if (draw.percent(5)) in.state.path = std::uint32_t((std::uint64_t(1) << c.path_bits()) - 1);
        const auto [length, wanted] = wanted_path(in.state.path, in.d, in.hit.t, c);
        const std::int64_t most = (std::int64_t(1) << c.path_bits()) - 1;
        REQUIRE(std::int64_t(pass(in, frame, c).state.path) == std::min(wanted, most));
        saturated += wanted > most, longer += length > 128;
        // At (1, 3/8, 5/16) the estimate is largest, sqrt(1 + 9/64 + 25/256) times the length. Along a
        // diagonal, (1, 1, 1), it is smallest, (1 + 3/8 + 5/16) / sqrt(3) times.
        const double exact =
            std::hypot(double(in.d[0]), double(in.d[1]), double(in.d[2])) / (1 << (c.dir_bits - 1));
        REQUIRE(double(length) / 128 <= 1.1128 * exact);
        REQUIRE(double(length + 2) / 128 >= 0.9742 * exact);
    }
    CAPTURE(saturated, longer);
    CHECK((saturated > 300 && longer > 500));
}

TEST_CASE("the RTL computes the exact length of a path in three cycles, one path per cycle",
          "[pass][path][textures]") {
    const Config c = shaded_format("textured:all");
    RtlModule rtl(c, "rc_path_length");
    Draw draw{29};
    std::array<bool, 4> valid{};                         // of the last cycles
    std::array<std::optional<std::int64_t>, 4> path{};   // their results
    int checked = 0;
    for (int cycle = 0; cycle < 40000; ++cycle) {
        const auto before = std::uint32_t(draw.natural(c.path_bits())),
                   t = std::uint32_t(draw.natural(c.t_bits()));
        const Vec3i d = draw.percent(30) ? random_corner_direction(draw, c) : draw.vector(c.dir_bits);
        std::shift_right(valid.begin(), valid.end(), 1), std::shift_right(path.begin(), path.end(), 1);
        valid[0] = cycle % 2000 < 1000 || draw.coin();
        path[0].reset();
        if (valid[0])
            path[0] = std::min(wanted_path(before, d, t, c).second, (std::int64_t(1) << c.path_bits()) - 1);
        put(rtl, "valid",
            std::uint32_t(valid[0]) | std::uint32_t(valid[1]) << 1 | std::uint32_t(valid[2]) << 2);
        put(rtl, "s1_phase", 1);
        put(rtl, "s0_path", before), put(rtl, "s0_t", t);
        put_vector(rtl, "s0_d", d, c.dir_bits);
        rtl.settle();
        if (valid[3]) {
            INFO("cycle " << cycle);
            REQUIRE(std::int64_t(got(rtl, "s3_path")[0]) == *path[3]);
            ++checked;
        }
        rtl.clock();
    }
    CHECK(checked > 20000);
}

TEST_CASE("a path to a plane beyond the range of t has the length of the way to its point",
          "[pass][textures]") {
    const Config c = shaded_format(GENERATE("textured:all", "textured:narrow", "textured:short"));
    Draw draw{31};
    int long_ones = 0;
    for (int i = 0; i < 20000; ++i) {
        PassIn in = without_cutout(random_pass(draw, Frame{}, c));
        in.state.next_event = ShadeEvent::arrive, in.hit.found = 1;
        in.surface.kind = PrimKind::plane, in.surface.smooth = 0;
        in.hit.t = (1u << c.t_bits()) - 1;
        const ShadeState s = pass(in, Frame{}, c).state;
        std::array<std::int64_t, 3> size{};
        for (std::size_t k = 0; k < 3; ++k) size[k] = std::abs(s.o[k] - in.o[k]);
        std::sort(size.begin(), size.end());
        const std::int64_t length = size[2] + size[1] / 4 + size[1] / 8 + size[0] / 4 + size[0] / 16,
                           wanted = in.state.path + (length * (1 << c.t_frac_bits)) / (1 << c.origin_bits),
                           most = (std::int64_t(1) << std::min(c.t_bits() + 6, 32)) - 1;
        REQUIRE(std::int64_t(s.path) == std::min(wanted, most));
        long_ones += wanted > (std::int64_t(1) << c.t_bits());
    }
    CHECK(long_ones > 2000);
}

TEST_CASE("a sphere's request has the place of its outward normal in the octahedral picture",
          "[pass][textures][octahedral]") {
    const Config c = shaded_format(GENERATE("textured:all", "textured:narrow", "textured:short"));
    Draw draw{37};
    int lower = 0, inside = 0, edges = 0;
    for (int i = 0; i < 100000; ++i) {
        ShadeState s;
        Vec3l toward{};
        for (auto& x : toward) x = draw.percent(15) ? 0 : draw.number(draw.between(2, 40));
        if (toward == Vec3l{}) continue;
        s.normal = unit_vector(toward), s.is_inside = draw.percent(25);
        const auto [u, v] = octahedral(s, c);
        std::array<std::int64_t, 3> n{};
        for (std::size_t k = 0; k < 3; ++k) n[k] = s.is_inside ? -s.normal[k] : s.normal[k];
        const std::int64_t sum = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]) + 1,
                           half = std::int64_t(1) << (c.bary_bits - 1);
        // The distance from the middle, in exact fractions rounded down: x and z on the octahedron. In the
        // lower half it is 1 minus the other one.
        const std::int64_t x = half * std::abs(n[0]) / sum, z = half * std::abs(n[2]) / sum;
        const std::int64_t across = n[1] < 0 ? half - z : x, down = n[1] < 0 ? half - x : z;
        REQUIRE(std::int64_t(u) == half + (n[0] < 0 ? -across : across));
        REQUIRE(std::int64_t(v) == half + (n[2] < 0 ? -down : down));
        lower += n[1] < 0, inside += s.is_inside != 0, edges += across == half || down == half;
        // The direction of that place is the normal, within the steps of u and v.
        const glm::dvec2 place = glm::dvec2(u, v) / double(2 * half);
        const glm::dvec3 out = glm::normalize(glm::dvec3(n[0], n[1], n[2]));
        REQUIRE(glm::length(octahedral_direction(place) - out) <
                4.25 * (std::exp2(1 - c.bary_bits) + 0x1p-16));
        REQUIRE(glm::length(octahedral_direction(octahedral_place(out)) - out) < 1e-12);
    }
    CAPTURE(lower, inside, edges);
    CHECK((lower > 25000 && inside > 15000 && edges > 10000));
}

TEST_CASE("a path begins at the camera ray, and a refracted ray continues its own", "[pass][textures]") {
    const Config c = shaded_format("textured:all");
    Draw draw{19};
    int samples = 0, waited = 0, pushed = 0;
    for (int i = 0; i < 20000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        const PassIn in = without_cutout(random_pass(draw, frame, c));
        const PassOut out = pass(in, frame, c);
        const bool pops = in.state.next_event == ShadeEvent::pop;
        if (out.leave == PassOut::Leave::spawn && pops && in.state.waiting > 0) {
            REQUIRE(out.state.path == in.top.path);
            ++waited;
        } else if (out.leave == PassOut::Leave::spawn && pops) {
            REQUIRE(out.state.path == 0);
            ++samples;
        }
        if (out.push) {
            REQUIRE(out.pushed.path == in.state.path);
            ++pushed;
        }
    }
    CHECK((samples > 100 && waited > 100 && pushed > 100));
}

TEST_CASE("a texture multiplies the albedo once, and ambient light comes after it", "[pass][textures]") {
    const Config c = shaded_format(GENERATE("textured:plain", "textured:all", "textured:levels:all"));
    Draw draw{23};
    int arrived = 0, textured = 0, last = 0;
    for (int i = 0; i < 20000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        PassIn in = random_pass(draw, frame, c);
        in.state.pending = Pending::none;
        const PassOut out = pass(in, frame, c);
        const ShadeState &was = in.state, &is = out.state;
        const auto event = was.next_event;
        if (event == ShadeEvent::texture && (!in.hole || was.holes == 63)) {
            ++textured, last += in.hole;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint64_t albedo = (std::uint64_t(was.albedo[k]) * in.texel[k] + 2048) / 4096;
                const std::uint64_t light =
                    (was.weight * std::uint64_t(was.ambient) * albedo + (1 << 23)) >> 24;
                REQUIRE(is.albedo[k] == albedo);
                REQUIRE(is.colour[k] == std::min<std::uint64_t>(was.colour[k] + light, 1 << unit_bits));
            }
            REQUIRE(is.holes == was.holes);
            REQUIRE(out.leave == PassOut::Leave::again);
        } else if (event == ShadeEvent::arrive && in.hit.found && in.surface.record != 0) {
            ++arrived;
            REQUIRE(is.colour == was.colour);   // no ambient light yet
            REQUIRE(is.record == in.surface.record);
            REQUIRE(is.ambient == in.surface.ambient);
            REQUIRE((out.leave == PassOut::Leave::texture) == !c.has_homes());
            if (c.has_homes()) continue;
            const std::array place{out.tex.u, out.tex.v};
            REQUIRE(place == (in.surface.kind == PrimKind::sphere ? octahedral(is, c)
                                                                  : std::array{in.hit.u, in.hit.v}));
            REQUIRE((out.tex.ray == in.ray && out.tex.record == in.surface.record &&
                     out.tex.cosine == is.cosine && out.tex.path == is.path));
        }
    }
    CHECK((arrived > 300 && textured > 1000 && last > 100));
}

TEST_CASE("a ray continues through a hole with the same direction and weight", "[pass][hole]") {
    const Config c = shaded_format(GENERATE("textured:plain", "textured:all", "textured:levels:all"));
    Draw draw{37};
    int first = 0, later = 0;
    for (int i = 0; i < 20000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        PassIn in = without_cutout(random_pass(draw, frame, c));
        in.state.next_event = ShadeEvent::texture;
        in.state.is_far = in.state.is_lost = 0;
        for (std::size_t k = 0; const std::int32_t x : draw_place(draw, c)) in.state.o[k++] = x;
        for (std::size_t k = 0; const std::int32_t x : draw_place(draw, c)) in.state.inner[k++] = x;
        in.hole = 1;
        if (in.state.holes == 63) continue;
        (in.state.holes == 0 ? first : later)++;
        const PassOut out = pass(in, frame, c);
        const ShadeState &was = in.state, &is = out.state;
        REQUIRE(out.leave == PassOut::Leave::spawn);
        REQUIRE_FALSE(out.push);
        REQUIRE(is.next_event == ShadeEvent::arrive);
        REQUIRE(is.holes == was.holes + 1);
        REQUIRE((is.depth == was.depth && is.weight == was.weight && is.path == was.path));
        REQUIRE((is.in_cell == was.in_cell && is.waiting == was.waiting && is.sample == was.sample));
        // Earlier contributions of lights remain, but the surface adds no ambient light.
        const bool adds = was.pending == Pending::sure || (was.pending == Pending::answer && !in.hit.found);
        for (std::size_t k = 0; k < 3; ++k)
            REQUIRE(is.colour[k] ==
                    std::min<std::uint32_t>(was.colour[k] + (adds ? was.share[k] : 0), 1 << unit_bits));
        REQUIRE(out.spawn.ray == in.ray);
        REQUIRE(out.spawn.kind == RayKind::bounce);
        REQUIRE(out.spawn.d == in.d);
        for (std::size_t k = 0; k < 3; ++k) REQUIRE(out.spawn.o[k] == was.o[k]);
        REQUIRE(
            (out.spawn.self == was.self && out.spawn.is_inside == was.is_inside && !out.spawn.is_partial));
        if (!c.has_homes()) continue;
        // In the mesh's space the ray starts from the point in the mesh.
        REQUIRE(out.spawn.home.line == in.placement.home());
        for (std::size_t k = 0; k < 3; ++k) REQUIRE(out.spawn.home.o[k] == was.inner[k]);
    }
    CHECK((first > 3000 && later > 3000));
}

TEST_CASE("after a cut-out in the way to a light, a pass only requests the texture", "[pass][hole]") {
    const Config c = shaded_format(GENERATE("textured:plain", "textured:all", "textured:levels:all"));
    Draw draw{41};
    int asked = 0, plain = 0;
    for (int i = 0; i < 20000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        const PassIn in = random_pass(draw, frame, c);
        const bool has_met = in.state.pending == Pending::answer && in.hit.found && in.hit.cutout;
        if (!has_met) continue;
        const PassOut out = pass(in, frame, c);
        ShadeState same = in.state;
        same.pending = in.surface.record != 0 ? Pending::texture : Pending::none;
        REQUIRE(out.state == same);
        REQUIRE_FALSE(out.push);
        (in.surface.record != 0 ? asked : plain)++;
        REQUIRE((out.leave == PassOut::Leave::texture) == (in.surface.record != 0));
        if (in.surface.record == 0) continue;
        REQUIRE((out.tex.ray == in.ray && out.tex.record == in.surface.record && out.tex.u == in.hit.u &&
                 out.tex.v == in.hit.v && out.tex.cosine == 65536 && out.tex.path == in.state.path &&
                 out.tex.scale == in.placement.texel_scale));
    }
    CHECK((asked > 300 && plain > 300));
}

TEST_CASE("a pass tests a light again behind a hole, and a cut-out without a hole hides the light",
          "[pass][hole]") {
    const Config c = shaded_format(GENERATE("textured:plain", "textured:all", "textured:levels:all"));
    Draw draw{43};
    int again = 0, hidden = 0, last = 0;
    for (int i = 0; i < 40000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        PassIn in = random_pass(draw, frame, c);
        if (in.state.pending != Pending::texture) continue;
        const PassOut out = pass(in, frame, c);
        if (in.hole && in.state.light_holes < 63) {
            // The same as the pass of that light, except for the count.
            PassIn first = in;
            first.state.pending = Pending::none, first.state.light_holes = 0, first.state.light -= 1;
            first.state.next_event = ShadeEvent::light;
            PassOut wanted = pass(first, frame, c);
            wanted.state.light_holes = in.state.light_holes + 1;
            REQUIRE(out.state == wanted.state);
            REQUIRE(out.leave == wanted.leave);
            if (out.leave != PassOut::Leave::spawn) continue;
            ++again;
            REQUIRE(wanted.spawn.holes == 0);
            wanted.spawn.holes = in.state.light_holes + 1;
            REQUIRE(pack(out.spawn, c) == pack(wanted.spawn, c));
        } else {
            ++hidden, last += in.hole;
            PassIn next = in;   // the same as after a blocked light
            next.state.pending = Pending::none, next.state.light_holes = 0;
            const PassOut wanted = pass(next, frame, c);
            REQUIRE(out.state == wanted.state);
            REQUIRE(out.leave == wanted.leave);
        }
    }
    CHECK((again > 300 && hidden > 1000 && last > 100));
}

TEST_CASE("a bounce, a waiting ray and a sample each restart the count of holes", "[pass][hole]") {
    const Config c = shaded_format(GENERATE("textured:all", "textured:levels:all"));
    Draw draw{47};
    int reflected = 0, popped = 0, samples = 0, kept = 0;
    for (int i = 0; i < 30000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        const PassIn in = without_cutout(random_pass(draw, frame, c));
        if (in.state.next_event == ShadeEvent::texture) continue;
        const PassOut out = pass(in, frame, c);
        const bool is_light = in.state.next_event == ShadeEvent::light;
        if (out.leave != PassOut::Leave::spawn || is_light) {
            REQUIRE(out.state.holes == in.state.holes);
            ++kept;
            continue;
        }
        REQUIRE(out.state.holes == 0);
        if (in.state.holes == 0) continue;
        (in.state.next_event == ShadeEvent::reflect ? reflected : in.state.waiting > 0 ? popped : samples)++;
    }
    CAPTURE(reflected, popped, samples, kept);
    CHECK((reflected > 100 && popped > 100 && samples > 100 && kept > 3000));
}

TEST_CASE("a pixel keeps the hit of its first camera ray, not one behind a hole", "[pass][hole]") {
    const Config c = shaded_format("textured:all");
    Draw draw{53};
    int first = 0, behind = 0;
    for (int i = 0; i < 30000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        PassIn in = without_cutout(random_pass(draw, frame, c));
        in.state.next_event = ShadeEvent::arrive;
        if (draw.coin()) in.state.depth = in.state.sample = 0;
        const ShadeState& was = in.state;
        const ShadeState is = pass(in, frame, c).state;
        const auto kept = [](const ShadeState& s) { return std::array{s.found, s.prim, s.t, s.u, s.v}; };
        const bool is_first = was.depth == 0 && was.sample == 0 && was.holes == 0;
        const std::array came{in.hit.found, in.hit.prim, in.hit.t, in.hit.u, in.hit.v};
        REQUIRE(kept(is) == (is_first ? came : kept(was)));
        first += is_first, behind += was.depth == 0 && was.sample == 0 && !is_first;
    }
    CHECK((first > 3000 && behind > 3000));
}

TEST_CASE("the RTL's pass is the model's if it stays for two, four or eight cycles, in every format",
          "[pass][lockstep][interval][slow]") {
    const auto name = GENERATE("every2:all", "every4:all", "every8:all", "every8:fast:all", "every4:fast:all",
                               "every4:fast:plain", "every2:fast:narrow", "every8:fast:narrow");
    check(name, 1, 12, 400);
}

TEST_CASE("the RTL's pass is the model's with directions shorter than unit vectors",
          "[pass][lockstep][short][slow]") {
    check("short", 1, 12, 400);
}

TEST_CASE("the RTL's pass is the model's, many draws", "[pass][lockstep][slow]") {
    const auto name = GENERATE("all", "plain", "mirror", "narrow", "broad", "short");
    check(name, 101, 200, 2000);
}
