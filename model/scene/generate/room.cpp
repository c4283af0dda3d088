// A textured room: a tiled floor, wallpaper, a framed picture, a box with large pixels, a plant with holes,
// and a mirror. Its textures cover every wrap mode and filter. Formulas generate the pictures. The meshes
// have no vertex normals.
#include "model/scene/generate/generate.hpp"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/scene/generate/mesh_writer.hpp"

namespace rayclock {
namespace {

using Colour = std::array<std::uint8_t, 3>;

/// Returns a texture with the sRGB colours of paint(x, y). It is opaque where is_there(x, y) holds.
template <class Paint, class IsThere>
Texture painted(const char* name, int width, int height, const Paint& paint, const IsThere& is_there) {
    TexelLevel picture{width, height, {}};
    picture.texels.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto [r, g, b] = paint(x, y);
            picture.texels.push_back({r, g, b, std::uint8_t(is_there(x, y) ? 255 : 0)});
        }
    return {.name = name, .pyramid = std::make_shared<const Pyramid>(make_pyramid(std::move(picture)))};
}

template <class Paint> Texture painted(const char* name, int width, int height, const Paint& paint) {
    return painted(name, width, height, paint, [](int, int) { return true; });
}

std::uint8_t code(double value) { return std::uint8_t(std::lround(std::fmin(std::fmax(value, 0), 255))); }
Colour shaded(const Colour& colour, double factor) {
    return {code(colour[0] * factor), code(colour[1] * factor), code(colour[2] * factor)};
}
/// Returns a brightness factor around 1 that depends only on the texel.
double grain(int x, int y, double depth) { return 1 + depth * (chance(std::uint32_t(1000 * y + x)) - 0.5); }

/// Four by four tiles in two colours, each with its own shade, and light joints.
Texture tiles() {
    return painted("tiles", 256, 256, [](int x, int y) -> Colour {
        if (x % 64 < 3 || y % 64 < 3) return shaded({200, 196, 186}, grain(x, y, 0.1));
        const int column = x / 64, row = y / 64;
        const Colour base = (column + row) % 2 ? Colour{150, 62, 44} : Colour{228, 208, 170};
        return shaded(base, grain(x, y, 0.12) * grain(column, row + 999, 0.3));
    });
}

/// Wallpaper: waves that continue smoothly into their mirror images, with a bud in one corner.
Texture paper() {
    return painted("paper", 128, 128, [](int x, int y) -> Colour {
        const double wave = std::sin(0.098 * x + 2 * std::sin(0.049 * y));
        const int from_bud = (x - 30) * (x - 30) + (y - 96) * (y - 96);
        if (from_bud < 196) return shaded({214, 120, 44}, from_bud < 64 ? 1 : 0.7);
        return wave > 0.72 ? Colour{54, 110, 70} : shaded({196, 214, 180}, grain(x, y, 0.05));
    });
}

/// A landscape: sky, sun, two hills and a border of four colours. The clamp mode extends the border outwards.
Texture landscape() {
    return painted("landscape", 256, 256, [](int x, int y) -> Colour {
        if (x < 3) return {170, 40, 40};
        if (x > 252) return {40, 60, 170};
        if (y < 3) return {230, 190, 60};
        if (y > 252) return {40, 110, 60};
        const double far_hill = 150 - 26 * std::sin(0.021 * x + 0.6),
                     near_hill = 196 + 22 * std::sin(0.03 * x);
        if (y > near_hill) return shaded({70, 120, 48}, grain(x, y, 0.3));
        if (y > far_hill) return shaded({86, 104, 128}, grain(x, y, 0.1));
        if ((x - 190) * (x - 190) + (y - 62) * (y - 62) < 576) return {252, 226, 130};
        return {code(110 + 0.5 * y), code(160 + 0.35 * y), 226};
    });
}

/// A face of 16 x 16 texels.
Texture face() {
    return painted("face", 16, 16, [](int x, int y) -> Colour {
        if (x == 0 || y == 0 || x == 15 || y == 15) return {60, 44, 30};
        const bool is_eye = (y == 5 || y == 6) && (x == 4 || x == 5 || x == 10 || x == 11);
        const bool is_mouth = (y == 11 && x > 3 && x < 12) || (y == 10 && (x == 3 || x == 12));
        if (is_eye) return {20, 40, 140};
        if (is_mouth) return {150, 30, 36};
        return (x + y) % 2 ? Colour{236, 200, 90} : Colour{222, 184, 76};
    });
}

/// A long band of lozenges between two lines.
Texture frieze() {
    return painted("frieze", 512, 64, [](int x, int y) -> Colour {
        if (y < 6 || y > 57) return {92, 60, 30};
        const int across = std::abs(x % 64 - 32), down = std::abs(y - 32);
        if (across + down < 20) return x / 64 % 2 ? Colour{30, 90, 130} : Colour{160, 50, 40};
        return shaded({226, 214, 190}, grain(x, y, 0.06));
    });
}

/// A fern: nine fronds that start at the middle of the lower edge, with holes between their leaves.
Texture fern() {
    const auto is_there = [](int x, int y) {
        const double along = 127 - y, across = x - 63.5, angle = std::atan2(across, along),
                     length = std::hypot(across, along);
        const double frond = std::round(angle / 0.3) * 0.3, off = (angle - frond) * length;
        const bool is_stem = std::fabs(off) < 1.2;
        const bool is_leaf =
            std::fabs(off) < 0.09 * (118 - length) && std::fmod(length + std::fabs(off), 9) < 5.5;
        return std::fabs(frond) < 1.3 && length < 118 && (is_stem || is_leaf);
    };
    return painted(
        "fern", 128, 128,
        [](int x, int y) {
            return shaded({66, 132, 50}, (0.7 + 0.004 * (128 - y)) * grain(x, y, 0.2));
        },
        is_there);
}

/// A rectangle of texture coordinates: s from `left` to `right`, t from `top` to `bottom`.
struct Extract {
    double left = 0, top = 0, right = 1, bottom = 1;
};

class RoomWriter {
public:
    explicit RoomWriter(Scene& scene) : scene_(scene), mesh_(scene) {
        mesh_.reserve(64, {.triangles = room_triangles(1)}, false);
    }

    void material(Material material, std::optional<Texture> texture) {
        if (texture) {
            material.texture = std::uint32_t(scene_.textures.size());
            scene_.textures.push_back(std::move(*texture));
        }
        mesh_.material(material);
    }

    /// Appends a rectangle. Seen from outside, its corners run anticlockwise from the lower left.
    void wall(const std::array<glm::dvec3, 4>& p, const Extract& e = {}) {
        mesh_.flat({p[0], p[1], p[2], p[3]});
        const glm::dvec2 a{e.left, e.bottom}, b{e.right, e.bottom}, c{e.right, e.top}, d{e.left, e.top};
        scene_.coordinates.push_back({a, b, c});
        scene_.coordinates.push_back({a, c, d});
    }

    /// Appends the four sides and the top of a block over its footprint, which is anticlockwise seen from
    /// above.
    void block(const std::array<glm::dvec3, 4>& foot, double height) {
        std::array<glm::dvec3, 4> head = foot;
        for (glm::dvec3& corner : head) corner.y += height;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            wall({foot[i], foot[next], head[next], head[i]});
        }
        wall(head);
    }

private:
    Scene& scene_;
    MeshWriter mesh_;
};

/// Returns the footprint of a block around a point, rotated about the vertical.
std::array<glm::dvec3, 4> foot(const glm::dvec3& middle, double width, double depth, double radians) {
    const glm::dvec3 x = 0.5 * width * glm::dvec3(std::cos(radians), 0, -std::sin(radians)),
                     z = 0.5 * depth * glm::dvec3(std::sin(radians), 0, std::cos(radians));
    return {middle - x + z, middle + x + z, middle + x - z, middle - x - z};
}

}   // namespace

std::uint64_t room_triangles(int) { return 2 * 5 + 2 * 2 * 5 + 2 * 2; }

Scene make_room(int) {
    Scene scene;
    scene.background = glm::dvec3(0.35, 0.55, 0.8);
    scene.camera = Camera{{0.4, 1.7, 5}, {-0.2, 1.25, -2}, {0, 1, 0}, 52};
    scene.lights = white_lights({{-1.5, 5.5, 3}, {2.5, 6, -6}});
    RoomWriter room(scene);
    constexpr double left = -3.5, right = 3.5, near = 7, far = -57, height = 3.2;
    const auto named = [](const char* name) {
        return Material{.name = name, .colour = glm::dvec3(1), .ambient = 0.15, .diffuse = 0.8};
    };

    room.material(named("floor"), tiles());
    room.wall({{{left, 0, near}, {right, 0, near}, {right, 0, far}, {left, 0, far}}}, {0, 0, 3.5, 32});
    Texture papered = paper();
    papered.wrap_s = papered.wrap_t = Wrap::mirror;
    room.material(named("papered wall"), papered);
    room.wall({{{left, 0, near}, {left, 0, far}, {left, height, far}, {left, height, near}}},
              {0, 0, 64, 3.2});
    Material plaster = named("plaster");
    plaster.colour = {0.75, 0.68, 0.55};
    room.material(plaster, std::nullopt);
    room.wall({{{right, 0, far}, {right, 0, near}, {right, height, near}, {right, height, far}}});
    room.material(named("frieze"), frieze());
    room.wall({{{right - 0.01, 2.6, far},
                {right - 0.01, 2.6, near},
                {right - 0.01, 3.1, near},
                {right - 0.01, 3.1, far}}},
              {0, 0, 16, 1});
    Texture framed = landscape();
    framed.wrap_s = framed.wrap_t = Wrap::clamp;
    room.material(named("picture"), framed);
    room.wall({{{right - 0.05, 0.7, -2.4},
                {right - 0.05, 0.7, 0.2},
                {right - 0.05, 2.3, 0.2},
                {right - 0.05, 2.3, -2.4}}},
              {-0.1, -0.1, 1.1, 1.1});
    Texture pixels = face();
    pixels.nearest = true;
    room.material(named("box"), pixels);
    room.block(foot({0.9, 0, 0.3}, 1, 1, 0.5), 1);
    Texture plant = fern();
    plant.wrap_s = plant.wrap_t = Wrap::clamp;
    Material cut = named("plant");
    cut.cutoff = 0.5;
    room.material(cut, plant);
    for (const double turn : {0.4, 1.97}) {
        const auto at = foot({-0.75, 0, 1.3}, 1.3, 0, turn);
        room.wall({at[0], at[1], at[1] + glm::dvec3(0, 1.3, 0), at[0] + glm::dvec3(0, 1.3, 0)});
    }
    room.material({.name = "mirror",
                   .colour = glm::dvec3(0.8, 0.85, 0.9),
                   .ambient = 0.1,
                   .diffuse = 0.1,
                   .highlight = 0.4,
                   .shine = 60,
                   .mirror = 0.8},
                  std::nullopt);
    room.block(foot({-1.5, 0.05, -1.6}, 2.2, 0.12, 0.6), 2.1);
    return scene;
}

}   // namespace rayclock
