#pragma once
// A scene file with instances of one textured cube: moved, scaled, turned, mirrored and stretched.
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test {

/// A PNG file of 8 bits per channel: red, green, blue and alpha. Its pixels are not compressed, and there are
/// at most 16,000 of them.
class SmallPng {
public:
    SmallPng(std::uint32_t width, std::uint32_t height,
             const std::vector<std::array<std::uint8_t, 4>>& pixels) {
        std::string rows;
        for (std::size_t y = 0; y < height; ++y) {
            rows += '\0';
            for (std::size_t x = 0; x < width; ++x)
                for (const std::uint8_t code : pixels[y * width + x]) rows += static_cast<char>(code);
        }
        const auto size = std::uint16_t(rows.size());
        bytes_ = "\x89PNG\r\n\x1a\n" +
                 png_chunk("IHDR", raw(width, true) + raw(height, true) + "\x08\x06" + std::string(3, '\0')) +
                 png_chunk("IDAT", "\x78\x01\x01" + raw(size) + raw(std::uint16_t(~size)) + rows +
                                       raw(adler_32(rows), true)) +
                 png_chunk("IEND", "");
    }
    const std::string& bytes() const { return bytes_; }

private:
    static std::string png_chunk(const std::string& kind, const std::string& data) {
        const std::string sealed = kind + data;
        return raw(std::uint32_t(data.size()), true) + sealed + raw(crc_32(sealed), true);
    }
    static std::uint32_t crc_32(const std::string& data) {
        std::uint32_t rest = ~0u;
        for (const char byte : data) {
            rest ^= std::uint8_t(byte);
            for (int i = 0; i < 8; ++i) rest = rest >> 1 ^ (rest & 1 ? 0xedb88320u : 0);
        }
        return ~rest;
    }
    static std::uint32_t adler_32(const std::string& data) {
        std::uint32_t low = 1, high = 0;
        for (const char byte : data) low = (low + std::uint8_t(byte)) % 65521, high = (high + low) % 65521;
        return high << 16 | low;
    }

    std::string bytes_;
};

/// The files of a textured cube, and scenes with it.
class TexturedCubes {
public:
    TexturedCubes() {
        std::vector<std::array<std::uint8_t, 4>> pixels;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                pixels.push_back({std::uint8_t(16 * x), std::uint8_t(16 * y), 128,
                                  std::uint8_t((x / 2 + y / 2) % 3 == 0 ? 0 : 255)});
        folder_.write("p.png", SmallPng(16, 16, pixels).bytes());
        write_net();
        folder_.write("m.mtl", "newmtl painted\nKd 1 1 1\nmap_Kd p.png\n");
        folder_.write("m.obj",
                      "mtllib m.mtl\nusemtl painted\n"
                      "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                      "f 5/1 6/2 7/3 8/4\nf 2/1 1/2 4/3 3/4\nf 6/1 2/2 3/3 7/4\n"
                      "f 1/1 5/2 8/3 4/4\nf 8/1 7/2 3/3 4/4\nf 1/1 2/2 6/3 5/4\n");
    }

    /// Six instances: plain; twice as large and turned; mirrored; stretched by 3, 1/2 and 1; with its own
    /// untextured material; far away and eight times as large. If the scene has holes, a square with holes
    /// stands in front of them.
    std::string still(bool has_holes) const {
        return scene("still.json",
                     R"({"mesh": "cube", "instances": [{"translate": [-2, 0, 0]},
                {"translate": [1, 0, 1], "scale": 2, "rotate": {"axis": [0, 1, 0], "degrees": 30}},
                {"matrix": [-1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 2,  0, 0, 0, 1]},
                {"matrix": [3, 0, 0, -3,  0, 0.5, 0, 1.5,  0, 0, 1, -2,  0, 0, 0, 1]},
                {"translate": [0, 0, 3], "rotate": {"axis": [1, 1, 0], "degrees": 50}, "material": "clay"},
                {"translate": [0, 0, -40], "scale": 8}]})" +
                         std::string(has_holes ? R"(, {"mesh": "net", "translate": [1, 1.2, 4], "scale": 1.5,
                                              "rotate": {"axis": [1, 0, 0], "degrees": -20}})"
                                               : ""));
    }
    /// A turning instance in front of one that stands still. One second.
    std::string turning() const {
        return scene("turning.json", R"({"mesh": "cube", "instances": [{"translate": [-2, 0, 0]},
            {"keyframes": [{"time": 0, "translate": [1, 0, 1], "rotate": {"axis": [0, 1, 0], "degrees": 0}},
                           {"time": 1, "translate": [1, 1, 1],
                            "rotate": {"axis": [0, 1, 0], "degrees": 120}}]}]})");
    }

    /// A film of one second: a band of four squares grows to four times its length and turns. With
    /// `instance_paints` the material with the texture belongs to an instance, otherwise to the band's file.
    std::string waving(bool instance_paints) const {
        const auto band = [&](double step, double rise) {
            std::ostringstream out;
            out << "mtllib m.mtl\nusemtl painted\n";
            for (int i = 0; i <= 4; ++i)
                for (const int z : {-1, 1})
                    out << "v " << i * step << ' ' << i % 2 * rise << ' ' << z << "\nvt " << i << ' ' << z
                        << '\n';
            for (int i = 1; i < 9; i += 2)
                out << "f " << i << '/' << i << ' ' << i + 1 << '/' << i + 1 << ' ' << i + 3 << '/' << i + 3
                    << ' ' << i + 2 << '/' << i + 2 << '\n';
            return out.str();
        };
        folder_.write("flat.obj", band(0.25, 0));
        folder_.write("long.obj", band(1, 0.5));
        return scene(
            "waving.json",
            std::string(R"({"mesh": "band", "translate": [-1, 0, 0]})") +
                (instance_paints ? R"(, {"mesh": "band", "material": "painted",
                                                                 "translate": [-1, 1, 0]})"
                                 : ""),
            R"(, "band": {"shapes": [{"time": 0, "file": "flat.obj"}, {"time": 1, "file": "long.obj"}]})");
    }

private:
    std::string scene(const std::string& name, const std::string& objects,
                      const std::string& meshes = {}) const {
        return folder_.write(name, R"({"meshes": {"cube": {"file": "m.obj"}, "net": {"file": "net.gltf"})" +
                                       meshes +
                                       R"(},
            "camera": {"eye": [3, 3, 7], "at": [0, 0.5, 0], "fov_degrees": 45},
            "materials": {"clay": {"colour": [0.8, 0.3, 0.2]},
                          "painted": {"colour": [1, 1, 0.5], "texture": "p.png"}},
            "lights": [{"position": [4, 8, 6], "colour": [1, 1, 1]}],
            "objects": [)" + objects + "]}");
    }

    /// A square of two triangles, whose material has holes where alpha is below 1/2.
    void write_net() const {
        std::string bin;
        for (const int x : {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}) bin += raw(float(x));   // positions
        for (const int x : {0, 1, 1, 1, 1, 0, 0, 0}) bin += raw(float(x));                   // coordinates
        for (const int i : {0, 1, 2, 0, 2, 3}) bin += raw(std::uint16_t(i));
        folder_.write("net.bin", bin);
        folder_.write("net.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}], "images": [{"uri": "p.png"}], "textures": [{"source": 0}],
            "materials": [{"alphaMode": "MASK", "alphaCutoff": 0.5,
                           "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "meshes": [{"primitives": [{"material": 0, "indices": 2,
                                        "attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}],
            "buffers": [{"uri": "net.bin", "byteLength": 92}],
            "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                            {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                           "min": [-1, -1, 0], "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                          {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
    }

    SceneFolder folder_;
};

}   // namespace rayclock::test
