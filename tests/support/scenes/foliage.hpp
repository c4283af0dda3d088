#pragma once
// Scene files with leaves that have holes, in front of lights on all sides.
#include <sstream>
#include <string>

#include "tests/support/cases/draw.hpp"
#include "tests/support/scenes/textured_cubes.hpp"

namespace rayclock::test {

/// Draws a scene: a floor, leaves at random places and sizes, some mirrored, and a sphere; with `planes` also
/// a plane. One light lies within the lattice, the other beyond it. The leaves have a texture with the
/// bilinear filter, or a mirrored texture with the nearest texel. With `own_materials` some leaves have a
/// material of their own without a texture.
class Foliage {
public:
    explicit Foliage(unsigned seed) : draw_(seed) {
        write_picture("soft.png", 16, 16);
        write_picture("hard.png", 8, 32);
    }

    std::string file(int leaves, bool planes, bool own_materials) {
        std::ostringstream out;
        out << R"({"camera": {"eye": [0, 3, 9], "at": [0, 1.2, 0], "fov_degrees": 42},
            "lights": [{"position": [3, 7, 4], "colour": [0.7, 0.7, 0.7]},
                       {"position": [-900, 1500, 400], "colour": [0.5, 0.5, 0.4]}],
            "materials": {
                "soft": {"colour": [1, 1, 1], "texture": "soft.png", "cutoff": 0.5},
                "hard": {"colour": [1, 0.9, 0.9], "mirror": 0.2, "cutoff": 0.2,
                         "texture": {"file": "hard.png", "filter": "nearest", "wrap": "mirror"}},
                "bare": {"colour": [0.3, 0.7, 0.3]}, "floor": {"colour": [0.8, 0.8, 0.8]},
                "glass": {"colour": [1, 1, 1], "diffuse": 0.1, "transmit": 0.8, "index": 1.4}},
            "meshes": {
                "leaf": {"vertices": [[-1, 0, 0], [1, 0, 0], [1, 2, 0], [-1, 2, 0]],
                         "triangles": [[0, 1, 2], [0, 2, 3]],
                         "coordinates": [[[0, 1], [1.3, 1], [1.3, 0]], [[0, 1], [1.3, 0], [0, 0]]]},
                "floor": {"vertices": [[-9, 0, -9], [9, 0, -9], [9, 0, 9], [-9, 0, 9]],
                          "triangles": [[0, 2, 1], [0, 3, 2]]}},
            "spheres": [{"centre": [1, 1, 1], "radius": 0.6, "material": ")"
            << (draw_.coin() ? "glass" : "floor") << R"("}],)";
        if (planes)
            out << R"("planes": [{"point": [0, -0.2, 0], "u": [1, 0, 0], "v": [0, 0, -1],
                                  "material": "floor"}],)";
        out << R"("objects": [{"mesh": "floor", "material": "floor"},
                              {"mesh": "leaf", "material": "soft", "instances": [)";
        for (int i = 0; i < leaves; ++i) {
            out << (i > 0 ? ", " : "") << R"({"translate": [)" << part(3) << ", " << 1.2 + part(1.2) << ", "
                << part(3) << R"(], "scale": [)" << size() << ", " << size() << ", " << size()
                << R"(], "rotate": {"axis": [)" << part(1) << ", 1, " << part(1) << R"(], "degrees": )"
                << draw_.below(360) << "}";
            if (draw_.percent(30))
                out << R"(, "material": "hard")";
            else if (own_materials && draw_.percent(20))
                out << R"(, "material": "bare")";
            out << "}";
        }
        out << "]}]}";
        return folder_.write("foliage.json", out.str());
    }

private:
    double part(double most) { return most * draw_.between(-100, 100) / 100; }
    double size() { return (0.4 + 0.01 * draw_.below(100)) * (draw_.percent(30) ? -1 : 1); }
    void write_picture(const std::string& name, std::uint32_t width, std::uint32_t height) {
        std::vector<std::array<std::uint8_t, 4>> pixels;
        for (std::uint32_t i = 0; i < width * height; ++i) {
            const std::array<std::uint8_t, 5> alphas{0, 0, 255, 128, 60};
            pixels.push_back({std::uint8_t(draw_.below(256)), std::uint8_t(draw_.below(256)), 90,
                              alphas[std::size_t(draw_.below(5))]});
        }
        folder_.write(name, SmallPng(width, height, pixels).bytes());
    }

    SceneFolder folder_;
    Draw draw_;
};

}   // namespace rayclock::test
