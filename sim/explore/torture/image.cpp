// Draws primitives, surfaces and trees for torture images.
#include "sim/explore/torture/image.hpp"

#include <cmath>

#include "model/base/axes.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/emit.hpp"
#include "model/core/payloads.hpp"
#include "model/engine/engines.hpp"
#include "model/engine/none/page.hpp"
#include "model/layout/words.hpp"
#include "sim/explore/torture/frames.hpp"
#include "sim/explore/torture/levels.hpp"
#include "sim/explore/torture/textures.hpp"

namespace rayclock::torture {

namespace {

PrimData triangle(const Vec3i& a, const Vec3i& b, const Vec3i& c) {
    PrimData t;
    t.a = a, t.b = b, t.c = c;
    return t;
}

PrimData sphere(const Vec3i& centre, std::uint64_t square, int bits) {
    const auto field = [bits](std::uint64_t part) {
        return std::int32_t(std::int64_t(part << (64 - bits)) >> (64 - bits));
    };
    PrimData s;
    s.kind = PrimKind::sphere;
    s.a = centre;
    s.b = {field(square), field(square >> bits), std::int32_t(square & 1)};   // last: the inside is visible
    return s;
}

PrimData plane(const Vec3i& a, const Vec3i& b, const Vec3i& c) {
    PrimData p = triangle(a, b, c);
    p.kind = PrimKind::plane;
    return p;
}

PrimData random_triangle(Dice& dice, std::int32_t most) {
    const Vec3i a = dice.point(most);
    const std::int32_t reach = std::max(1, most >> (2 * dice.below(5)));
    Vec3i b = dice.near(a, reach, most),
          c = dice.percent(20) ? dice.near(b, 1, most) : dice.near(a, reach, most);
    if (dice.percent(15)) b = dice.point(most), c = dice.point(most);
    return triangle(a, b, c);
}

PrimData random_sphere(Dice& dice, const Config& config, std::int32_t most) {
    const auto radius = std::uint64_t(dice.between(1, std::max(2, most >> (3 * dice.below(3)))));
    const std::uint64_t square =
        dice.percent(50) ? radius * radius : radius * radius + std::uint64_t(dice.below(int(radius) + 1));
    return sphere(dice.percent(50) ? dice.near({}, most / 2, most) : dice.point(most), square,
                  config.coord_bits);
}

/// Converts to the type of a surface, with edges that are multiples of 2^fine steps; see Surface::fine.
std::uint32_t fine_of(const PrimData& t, const Config& config) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
        bits |= std::uint32_t(t.b[k] - t.a[k]) | std::uint32_t(t.c[k] - t.a[k]);
    const int least = bits == 0 ? max_fine : __builtin_ctz(bits);
    return std::uint32_t(std::clamp(std::min(least, config.bary_bits - config.origin_bits), 0, max_fine));
}

/// So many of those that count.
template <class Make> std::vector<PrimData> many(int count, const Config& config, const Make& make) {
    std::vector<PrimData> all;
    while (int(all.size()) < count)
        if (const PrimData next = make(); counts(next, config)) all.push_back(next);
    return all;
}

}   // namespace

Surface random_surface(const PrimData& prim, const Config& config, Dice& dice, SurfaceStyle style) {
    Surface s;
    const bool flat = prim.is_triangle();
    s.kind = flat ? PrimKind::triangle : prim.kind;
    s.a = prim.a, s.b = prim.b, s.c = prim.c;
    if (flat) s.fine = fine_of(prim, config);
    s.smooth = style != SurfaceStyle::clear && config.smooth && flat && dice.percent(40);
    for (auto& x : s.normal) x = s.smooth ? dice.number(max_of(corner_bits)) : 0;
    // The phases of a plane's squares, and the bits that distinguish them.
    if (s.kind == PrimKind::plane)
        for (std::size_t side : {0u, 1u}) {
            s.normal[side] = dice.number(max_of(corner_bits));
            s.normal[2 + side] = dice.between(-1, config.bary_bits + corner_bits - 1);
        }
    if (s.kind == PrimKind::plane && config.panes > 0) s.normal[4] = 1 << dice.below(config.panes);
    s.checkered = dice.percent(50), s.schlick = dice.percent(30);
    s.colour = dice.colour(share_bits), s.other = dice.colour(share_bits);
    s.ambient = dice.share(share_bits), s.diffuse = dice.share(share_bits),
    s.highlight = dice.share(share_bits);
    s.mirror = dice.percent(60) ? dice.share(unit_bits) : 0;
    s.transmit = config.refraction && dice.percent(50) ? dice.share(unit_bits) : 0;
    const std::uint32_t one = 1u << share_bits;
    if (style == SurfaceStyle::clear)
        s.mirror = 1u << (unit_bits - 1), s.transmit = config.refraction ? s.mirror : 0, s.ambient = 100,
        s.diffuse = s.highlight = s.schlick = 0;
    if (style == SurfaceStyle::shiny)
        s.mirror = s.transmit = 0, s.highlight = one,
        s.shine = std::uint32_t(dice.below(1 << dice.between(6, shine_bits)));
    if (style == SurfaceStyle::bright)
        s.mirror = s.transmit = s.diffuse = s.highlight = 0, s.ambient = one,
        s.colour = {one, one * (s.a[0] & 1), one}, s.other = {};
    s.r0 = dice.share(unit_bits);
    s.shine = std::uint32_t(dice.below(1 << dice.between(1, shine_bits)));
    s.enter = std::uint32_t(dice.percent(25) ? 1 << index_frac : dice.between(2000, 8000));
    s.leave = std::uint32_t(dice.percent(25) ? 1 << index_frac : dice.between(2000, 8000));
    return s;
}

void append_line(const Surface& surface, const Config& config, std::vector<std::uint32_t>& words) {
    Words scratch;
    words.resize(words.size() + words_per_line, 0);
    write_payload(surface, config, &words[words.size() - words_per_line], scratch);
}

std::vector<PrimData> soup(const Config& config, Dice& dice, int count) {
    const std::int32_t most = max_of(config.coord_bits);
    std::vector<PrimData> all = many(count, config, [&] {
        const PrimData flat = random_triangle(dice, most);
        return config.spheres && dice.percent(25) ? random_sphere(dice, config, most) : flat;
    });
    if (config.planes) {
        const std::int32_t low = -most / 3, square = std::max(4, most / 64);
        all.push_back(plane({0, low, 0}, {square, low, 0}, {0, low, -square}));
        all.push_back(plane({-most, -most, -most}, {most, -most, -most + 1}, {-most, -most / 2, most}));
    }
    return all;
}

std::vector<PrimData> walls(const Config& config) {
    const std::int32_t most = max_of(config.coord_bits), step = std::max(4, most / 256);
    return {plane({0, -most / 2, 0}, {step, -most / 2, 0}, {0, 1 - most / 2, -step}),
            plane({0, most / 2, 0}, {step, most / 2 - 1, 0}, {0, most / 2, step}),
            plane({most - 1, 0, 0}, {most, step, 0}, {most - 1, 0, step})};
}

std::vector<PrimData> spans(const Config& config, Dice& dice, int count) {
    const std::int32_t most = max_of(config.coord_bits);
    const auto end = [&] { return dice.percent(50) ? most : -most; };
    return many(count, config, [&] {
        return triangle({end(), end(), end()}, {end(), end(), end()}, {end(), end(), end()});
    });
}

PrimData mirror(const Config& config, const Vec3i& normal, std::int32_t at) {
    const std::int32_t side = max_of(config.coord_bits) / 64;
    const Vec3i place = mirror_place(config, at), one{normal[2] * side, 0, -normal[0] * side},
                two{0, normal[2] * side, -normal[1] * side};
    const auto corner = [&](std::int32_t x, std::int32_t y) {
        return by_axis([&](std::size_t k) { return place[k] + x * one[k] + y * two[k]; });
    };
    return triangle(corner(-1, -1), corner(2, -1), corner(-1, 2));
}

std::vector<PrimData> balls(const Config& config, Dice& dice, int count) {
    const std::int32_t most = max_of(config.coord_bits);
    return many(count, config, [&] {
        const auto radius = std::uint64_t(dice.between(1, std::max(2, most >> dice.between(2, 5))));
        return sphere(dice.near({}, most / 3, most), radius * radius + std::uint64_t(dice.below(3)),
                      config.coord_bits);
    });
}

PrimData ball(const Config& config, const Vec3i& centre, std::int32_t radius) {
    return sphere(centre, std::uint64_t(radius) * std::uint64_t(radius), config.coord_bits);
}

std::vector<PrimData> beads(const Config& config, Dice& dice, int count) {
    return many(count, config, [&] {
        return sphere(dice.near({}, 6, 6), std::uint64_t(dice.between(1, 9)), config.coord_bits);
    });
}

std::vector<PrimData> specks(const Config& config, Dice& dice, int count) {
    const auto place = [&] { return dice.near({}, 3, 3); };
    return many(count, config, [&] {
        const Vec3i a = place(), b = place(), c = place();
        PrimData next = triangle(a, b, c);
        if (dice.percent(40)) next.b[2] = next.c[2] = next.a[2];
        if (config.spheres && dice.percent(25))
            next = sphere(a, std::uint64_t(dice.between(1, 16)), config.coord_bits);
        return next;
    });
}

std::vector<PrimData> mesh(std::int32_t step, int side) {
    std::vector<PrimData> all;
    for (const bool again : {false, true})
        for (int i = 0; i < side * side; ++i) {
            const int at = again ? side * side - 1 - i : i;
            const std::int32_t x = (at % side - side / 2) * step, y = (at / side - side / 2) * step;
            const Vec3i a{x, y, 0}, b{x + step, y, 0}, c{x + step, y + step, 0}, d{x, y + step, 0};
            if (again)
                all.push_back(triangle(a, b, d)), all.push_back(triangle(c, d, b));
            else
                all.push_back(triangle(a, b, c)), all.push_back(triangle(d, a, c));
        }
    return all;
}

std::vector<PrimData> panes(const Config& config, int count) {
    const std::int32_t most = max_of(config.coord_bits), side = most / 2;
    std::vector<PrimData> all;
    for (int i = 0; i < count; ++i) {
        const std::int32_t z = most / 4 - i * (most / (2 * count)), tilt = i % 3 == 0   ? 0
                                                                           : i % 3 == 1 ? most / 32
                                                                                        : most / 700;
        const Vec3i a{-side, -side, z}, b{side, -side, z + tilt}, c{side, side, z + tilt}, d{-side, side, z};
        all.push_back(triangle(a, b, c)), all.push_back(triangle(a, c, d));
    }
    return all;
}

namespace {

/// Returns the primitives with their numbers. Some triangles become cut-outs.
std::vector<PrimData> numbered_of(const std::vector<PrimData>& prims, Textures& textures) {
    std::vector<PrimData> numbered = prims;
    for (std::size_t i = 0; i < numbered.size(); ++i) numbered[i].prim = std::uint32_t(i);
    textures.make_cutouts(numbered);
    return numbered;
}

/// Appends textures and surfaces to the image, if the chip shades.
void append_surfaces(const std::vector<PrimData>& prims, Textures& textures, const Config& config, Dice& dice,
                     SurfaceStyle style, MemoryImage& image) {
    if (!config.has_shade()) return;
    textures.append(image.words);
    image.first_surface_line = image.lines();
    for (const PrimData& prim : prims) {
        Surface surface = random_surface(prim, config, dice, style);
        surface.record = textures.record_for(prim);
        append_line(surface, config, image.words);
    }
}

}   // namespace

MemoryImage image_of(const std::vector<PrimData>& prims, const Config& config, Dice& dice, const char* name,
                     SurfaceStyle style) {
    if (config.has_instances()) return placed_image(prims, config, dice, name, style);
    Textures textures(config, dice, style);
    const std::vector<PrimData> numbered = numbered_of(prims, textures);
    MemoryImage image = compile_triangles(numbered, config, name);
    image.lattice.coord_bits = config.coord_bits;
    append_surfaces(numbered, textures, config, dice, style, image);
    check_lines(image.lines(), config, name);
    return image;
}

namespace {

/// Draws a plane of a node, in any direction if the engine's planes have one.
template <class Engine> void set_plane(typename Engine::Node& node, std::size_t plane, Dice& dice) {
    space_cells::Cell cell;
    if constexpr (requires { node.normal; }) {
        const std::int32_t most = max_of(normal_step_bits);
        cell.normal = dice.percent(50) ? dice.point(most) : dice.near({}, 3, most);
        for (std::size_t k = 0; k < 3; ++k) cell.at += cell.normal[k] * dice.between(node.lo[k], node.hi[k]);
    } else {
        const std::uint32_t axis = cell.axis = std::uint32_t(dice.below(3));
        cell.at = dice.between(node.lo[axis], node.hi[axis]);
        cell.lower = std::make_unique<space_cells::Cell>(),
        cell.upper = std::make_unique<space_cells::Cell>();
        cell.lower->bounds.hi[axis] = cell.at;   // the second of a pair of planes makes a gap or an overlap
        cell.upper->bounds.lo[axis] = node.lo[axis] + node.hi[axis] - cell.at;
    }
    Engine::put(cell, plane, node);
}

template <class Engine> void cut_lines_anew(MemoryImage& image, const Config& config, Dice& dice) {
    std::vector<std::uint32_t> pending{0};
    Words scratch;
    while (!pending.empty()) {
        std::uint32_t* const at = &image.words[std::size_t(pending.back()) * words_per_line];
        pending.pop_back();
        auto node = unpack<typename Engine::Node>(at, config);
        node.open = dice.percent(20);
        for (std::size_t k = 0; k < 3; ++k)
            node.lo[k] = dice.between(-3, 1), node.hi[k] = node.lo[k] + dice.between(0, 4);
        for (std::size_t i = 0; i < std::size_t(config.planes_of_node()); ++i)
            set_plane<Engine>(node, i, dice);
        std::fill_n(at, words_per_line, 0u);
        write_payload(node, config, at, scratch);
        std::uint32_t next = node.base;
        for (const std::uint32_t kind : node.kind)
            if (kind == 1) {   // with two levels the line may hold an instance
                if (!config.has_instances() || line_kind(image.line(next)) == LineKind::scene_node)
                    pending.push_back(next);
                ++next;
            }
    }
}

}   // namespace

void cut_anew(MemoryImage& image, const Config& config, Dice& dice) {
    with_engine(config.engine(), [&]<class E>(E) {
        if constexpr (E::has_cells) cut_lines_anew<E>(image, config, dice);
    });
}

void move_nodes(std::vector<std::uint32_t>& words, std::uint32_t root, Structure engine,
                const Config& config) {
    with_engine(engine, [&]<class E>(E) {
        using Line = typename E::Node;
        std::vector<std::uint32_t> pending{root};
        Words scratch;
        while (!pending.empty()) {
            std::uint32_t* const at = &words[std::size_t(pending.back()) * words_per_line];
            pending.pop_back();
            Line node = unpack<Line>(at, config);
            node.base += root;
            std::fill_n(at, words_per_line, 0u);
            write_payload(node, config, at, scratch);
            if (config.has_instances()) set_line_kind(at, LineKind::mesh_node);
            std::uint32_t next = node.base;
            for (const std::uint32_t kind : node.kind)
                if (kind == 1) pending.push_back(next++);
        }
    });
}

MemoryImage image_at_the_end(const std::vector<PrimData>& prims, const Config& config, Dice& dice,
                             const char* name, std::uint32_t& root) {
    Textures textures(config, dice, SurfaceStyle::any);
    const std::vector<PrimData> numbered = numbered_of(prims, textures);
    MemoryImage image = compile_triangles(numbered, config, name);
    image.lattice.coord_bits = config.coord_bits;
    const std::vector<std::uint32_t> made = std::move(image.words);
    image.words.clear();
    append_surfaces(numbered, textures, config, dice, SurfaceStyle::any, image);
    const std::uint32_t all = 1u << config.addr_bits, page = page_lines(config.node_width);
    const std::uint32_t lines =
        config.is_list() ? (image.listed_primitives + 1) / 2 : std::uint32_t(made.size() / words_per_line);
    root = config.is_list() ? (all - lines) / page * page : all - lines;
    check_lines(image.lines() + all - root, config, name);
    image.words.resize(std::size_t(all) * words_per_line, 0);
    std::copy_n(made.begin(), lines * words_per_line,
                image.words.begin() + std::ptrdiff_t(root * words_per_line));
    if (config.is_list())
        image.listed_primitives += 2 * root;
    else
        move_nodes(image.words, root, config.engine(), config);
    return image;
}

std::vector<PrimData> coarse(const Config& config, Dice& dice, int count) {
    const std::int32_t most = max_of(config.coord_bits);
    return many(count, config, [&] {
        PrimData t = random_triangle(dice, most);
        const int step = dice.below(7);
        for (Vec3i* corner : {&t.b, &t.c})
            for (std::size_t k = 0; k < 3; ++k)
                (*corner)[k] = t.a[k] + ((*corner)[k] - t.a[k]) / (1 << step) * (1 << step);
        return t;
    });
}

}   // namespace rayclock::torture
