// Hostile and unusual pictures: each is drawn correctly, or causes one sentence, in time and memory
// proportional to its size.
#include <catch2/catch.hpp>

#include <ctime>

#include <nlohmann/json.hpp>

#include "sim/files/image/average.hpp"
#include "tests/support/scenes/picture_files.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::hostile_pictures_test {

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

using Texels = std::vector<std::array<std::uint8_t, 4>>;
using Notes = std::vector<std::string>;

std::string bytes_of(std::initializer_list<int> list) {
    std::string text;
    for (const int x : list) text += static_cast<char>(x);
    return text;
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Returns the reason why a picture cannot be read, or an empty string. Requires the time of a small file.
std::string refusal(const std::string& bytes) {
    const double start = processor_seconds();
    std::string reason;
    try {
        decoded_picture(bytes);
    } catch (const std::runtime_error& error) {
        reason = error.what();
    }
    CHECK(processor_seconds() - start < 1);   // a hundred times the usual
    return reason;
}

/// Replaces bytes by a number, with the lowest byte first or the highest byte first.
template <class Number>
std::string with(std::string bytes, std::size_t at, Number value, bool is_big_endian = false) {
    return bytes.replace(at, sizeof value, raw(value, is_big_endian));
}

/// The frame header of a JPEG file begins with the bytes ff c0. The height follows 5 bytes after its start.
std::size_t jpeg_size_at(const std::string& jpeg) { return jpeg.find("\xff\xc0") + 5; }

/// Pictures in every format whose headers claim these sides. Their data has only a few texels.
std::vector<std::pair<std::string, std::string>> claiming(std::uint32_t side) {
    const auto s16 = static_cast<std::uint16_t>(std::min(side, 65'500u));   // what the format can claim
    const std::string jpeg = small_jpeg({200});
    // The first two entries of a TIFF file at 26 and 38 are the sides: tag, type, count and value. Here they
    // become numbers of 32 bits.
    const std::uint16_t wide = 4;
    const std::string tiff = with(with(small_tiff(2), 28, wide), 40, wide);
    std::string hdr = small_hdr();
    hdr.replace(hdr.find("-Y 1 +X 2"), 9, "-Y " + std::to_string(side) + " +X " + std::to_string(side));
    return {{"png", png_of(side, side, 8, 2, std::string(100, '\0'))},
            {"bmp", with(with(small_bmp(), 18, side), 22, side)},
            {"tga", with(with(small_tga(), 12, s16), 14, s16)},
            {"tiff", with(with(tiff, 34, side), 46, side)},
            {"hdr", hdr},
            {"jpeg", with(with(jpeg, jpeg_size_at(jpeg), s16, true), jpeg_size_at(jpeg) + 2, s16, true)}};
}

/// An OBJ file of a triangle with the picture p.
std::string obj_with(const SceneFolder& folder, const std::string& bytes) {
    folder.write("p", bytes);
    folder.write("a.mtl", "newmtl a\nmap_Kd p\n");
    return folder.write("a.obj",
                        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                        "usemtl a\nf 1/1 2/2 3/3\n");
}

}   // namespace

TEST_CASE("pictures: a small file that claims 65,536 texels a side is refused by its header") {
    for (const auto& [format, bytes] : claiming(65'536)) {
        INFO(format);
        const std::string reason = refusal(bytes);
        CHECK_THAT(reason, Contains("65536") || Contains("65500"));
    }
    const std::string png = png_of(65'536, 65'536, 8, 2, "");
    CHECK_FALSE(refusal(png.substr(0, 33)).empty());   // the header alone
}

TEST_CASE("pictures: a picture without texels is refused") {
    for (const auto& [format, bytes] : claiming(0)) {
        INFO(format);
        CHECK_FALSE(refusal(bytes).empty());
    }
}

TEST_CASE("pictures: a small file must not hold 2^28 texels") {
    // 2^28 black texels of 1 bit take 33 kB when compressed. Here the data is cut, because the size decides.
    for (const int depth : {1, 8}) {
        const std::string reason = refusal(png_of(16'384, 16'384, depth, 0, std::string(1 << 20, '\0')));
        CHECK_THAT(reason, Contains("16384x16384 texels in a file of ") && Contains("bytes are too many"));
    }
    // A decoder of interlaced rows would allocate memory for all texels first.
    CHECK_THAT(refusal(png_of(16'384, 8'192, 16, 6, std::string(100, '\0'), {}, true)),
               Contains("16384x8192 texels in a file of "));
    // The largest texture always fits.
    std::string rows;
    for (int y = 0; y < 4096; ++y) rows += std::string(513, '\0');
    CHECK(decoded_picture(png_of(4096, 4096, 1, 0, rows)).texels.size() == std::size_t(1) << 24);
}

TEST_CASE("pictures: each beginning of a file is refused, or has all the texels") {
    const std::string png = png_of(2, 1, 8, 6, bytes_of({0, 1, 2, 3, 4, 250, 251, 252, 253}));
    for (const std::string& whole :
         {png, small_bmp(), small_tga(), small_tiff(2), small_hdr(), small_jpeg({200, 90, 160})}) {
        INFO(whole.substr(0, 4));
        const TexelLevel picture = decoded_picture(whole);
        std::size_t refused = 0;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            CAPTURE(length);
            try {
                const TexelLevel part = decoded_picture(whole.substr(0, length));
                CHECK(part.texels == picture.texels);
            } catch (const std::runtime_error&) {
                ++refused;
            }
        }
        CHECK(refused > whole.size() / 2);
    }
}

TEST_CASE("pictures: CMYK becomes red, green and blue") {
    // Adobe stores 255 for no ink: no cyan, half of the magenta, all of the yellow, no black.
    const std::array<std::uint8_t, 4> texel = decoded_picture(small_jpeg({255, 128, 0, 255})).texels.at(0);
    CHECK(texel == std::array<std::uint8_t, 4>{255, 128, 0, 255});
    CHECK(decoded_picture(small_jpeg({200})).texels.at(63) ==
          std::array<std::uint8_t, 4>{200, 200, 200, 255});
}

TEST_CASE("pictures: interlaced rows, palettes with alpha, and 16 bits with alpha are decoded") {
    // The passes of 3 x 2 texels: a, c, b, then the second row.
    CHECK(decoded_picture(png_of(3, 2, 8, 0, bytes_of({0, 10, 0, 30, 0, 20, 0, 40, 50, 60}), {}, true))
              .texels ==
          decoded_picture(png_of(3, 2, 8, 0, bytes_of({0, 10, 20, 30, 0, 40, 50, 60}))).texels);
    const std::string palette = png_chunk("PLTE", bytes_of({10, 20, 30, 40, 50, 60})),
                      alpha = png_chunk("tRNS", bytes_of({77}));
    CHECK(decoded_picture(png_of(2, 1, 1, 3, bytes_of({0, 0x40}), palette + alpha)).texels ==
          Texels{{10, 20, 30, 77}, {40, 50, 60, 255}});
    CHECK(decoded_picture(png_of(1, 1, 16, 6, bytes_of({0, 1, 1, 0x80, 0x80, 0xff, 0xff, 0x40, 0x40})))
              .texels == Texels{{1, 128, 255, 64}});
    CHECK_FALSE(refusal(png_of(2, 1, 8, 3, bytes_of({0, 0, 0}))).empty());   // no palette
}

TEST_CASE("pictures: an animated PNG shows its first picture, and a GIF is refused") {
    const std::string frame = raw(std::uint32_t{0}) + raw(std::uint32_t{1}, true) +
                              raw(std::uint32_t{1}, true) + std::string(8, '\0') +
                              bytes_of({0, 1, 0, 10, 0, 0});
    const std::string animation =
        png_chunk("acTL", raw(std::uint32_t{2}, true) + raw(std::uint32_t{0})) + png_chunk("fcTL", frame);
    CHECK(decoded_picture(png_of(1, 1, 8, 2, bytes_of({0, 9, 8, 7}), animation)).texels ==
          Texels{{9, 8, 7, 255}});
    CHECK_THAT(refusal("GIF89a and so on"), Contains("it is not PNG, JPEG"));
}

TEST_CASE("pictures: a hostile picture gives one sentence of one line, and a grey surface") {
    for (const auto& [format, bytes] : claiming(65'536)) {
        INFO(format);
        const SceneFolder folder;
        Notes notes;
        const Scene scene = load_scene(obj_with(folder, bytes), {}, Primitives::triangles, &notes);
        CHECK(scene.textures.empty());
        REQUIRE(notes.size() == 1);
        CHECK_THAT(notes[0], Contains("a.obj: the picture ") && Contains("p is not drawn: "));
        CHECK_THAT(notes[0], !Contains("\n") && !Contains("\\x0a"));
    }
    const SceneFolder folder;
    folder.write("p", png_of(65'536, 65'536, 8, 2, ""));
    CHECK_THAT(complaint(folder.write(
                   "a.json", R"({"materials":{"m":{"texture":"p"}},"meshes":{"c":{"builtin":"cube"}},)"
                             R"("objects":[{"mesh":"c","material":"m"}]})")),
               Contains("a.json: materials.m.texture names 'p', which cannot be drawn: 65536x65536 texels"));
}

TEST_CASE("pictures: a hundred thousand materials with one picture load in linear time") {
    const SceneFolder folder;
    const std::string file = obj_with(folder, png_of(2, 2, 8, 0, bytes_of({0, 1, 2, 0, 3, 4})));
    std::string mtl, obj = "mtllib a.mtl\nvt 0 0\nvt 1 0\nvt 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    constexpr int count = 100'000;
    for (int i = 0; i < count; ++i) {
        const std::string name = std::to_string(i);
        mtl += "newmtl " + name + "\nmap_Kd p\n";
        obj += "usemtl " + name + "\nf 1/1 2/2 3/3\n";
    }
    folder.write("a.mtl", mtl), folder.write("a.obj", obj);
    const double start = processor_seconds();
    const Scene scene = load_scene(file);
    CHECK(processor_seconds() - start < 3);   // ten times the usual, for slow machines
    CHECK(scene.coordinates.size() == count);
    CHECK(scene.textures.size() == count);
    CHECK(scene.textures.back().pyramid == scene.textures.front().pyramid);
}

}   // namespace rayclock::test::hostile_pictures_test
