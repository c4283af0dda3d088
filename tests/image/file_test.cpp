// Picture files: what is written is what is read back, exactly; failures are one sentence and leave nothing behind.
#include <cstring>
#include <fstream>

#include <OpenImageIO/imageio.h>

#include "sim/image/output_file.hpp"
#include "sim/image/srgb.hpp"
#include "tests/image/folder.hpp"

using namespace rayclock;
namespace fs = std::filesystem;

/// For the leak sanitizer: at the end of a cut file OpenImageIO 2.4's png reader makes a string and then has libpng
/// jump over its destructor.
extern "C" const char* __lsan_default_suppressions() { return "leak:OpenImageIO_v2_4::ImageInput::geterror\n"; }

namespace {

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// One sentence: no line break, names the file.
void check_sentence(const std::string& text, const std::string& path, const std::string& part) {
    CAPTURE(text);
    CHECK(text.find('\n') == std::string::npos);
    CHECK(text.rfind(path, 0) == 0);
    CHECK(text.find(part) != std::string::npos);
}

} // namespace

TEST_CASE("png holds the clamped sRGB bytes of the picture", "[image]") {
    const TestFolder folder;
    Picture picture{{16, 17}, {}};
    for (int i = 0; i < 16 * 17; ++i) {
        const float v = static_cast<float>(linear_from_srgb(std::min(i, 255) / 255.0));
        picture.pixels.emplace_back(v, 1 - v, i % 2 ? -3.0f : 7.0f);
    }
    write_picture(folder / "a.png", picture, no_hits(picture.size));
    CHECK(folder.files() == 1);
    const auto file = OIIO::ImageInput::open(folder / "a.png");
    REQUIRE(file);
    CHECK(file->spec().nchannels == 3);
    CHECK(file->spec().format == OIIO::TypeUInt8);
    std::vector<std::uint8_t> bytes(16 * 17 * 3);
    REQUIRE(file->read_image(0, 0, 0, 3, OIIO::TypeUInt8, bytes.data()));
    for (int i = 0; i < 16 * 17; ++i) {
        CAPTURE(i);
        REQUIRE(bytes[3 * i] == std::min(i, 255));
        REQUIRE(bytes[3 * i + 1] == srgb_byte(picture.pixels[i].g));
        REQUIRE(bytes[3 * i + 2] == (i % 2 ? 0 : 255));
    }
}

TEST_CASE("a png that is read and written again keeps every byte", "[image]") {
    const TestFolder folder;
    Picture picture{{256, 1}, {}};
    for (int i = 0; i < 256; ++i) picture.pixels.emplace_back(static_cast<float>(linear_from_srgb(i / 255.0)));
    write_picture(folder / "a.png", picture, no_hits(picture.size));
    const Picture read = read_picture(folder / "a.png");
    CHECK(read.size == picture.size);
    CHECK(compare(picture, read).largest == 0);
    write_picture(folder / "b.PNG", read, no_hits(read.size));
    CHECK(contents(folder / "a.png") == contents(folder / "b.PNG"));
}

TEST_CASE("exr keeps light beyond 1, depth and primitive numbers", "[image]") {
    const TestFolder folder;
    const Picture picture{{2, 2}, {{0.5f, 0.25f, 1000}, {0, 1, 2}, {-0.5f, 0, 0.125f}, {3, 3, 3}}};
    const HitFrame hits{{2, 2},
                        {{0, 1.2345678f, 0, 0}, {no_primitive, 0, 0, 0}, {16777217, 1e-20f, 0, 0}, {7, 3, 0, 0}}};
    write_picture(folder / "a.exr", picture, hits);
    CHECK(folder.files() == 1);
    const Picture read = read_picture(folder / "a.exr");
    CHECK(read.size == picture.size);
    CHECK(read.pixels == picture.pixels);
    const auto file = OIIO::ImageInput::open(folder / "a.exr");
    REQUIRE(file);
    const OIIO::ImageSpec spec = file->spec();
    const int z = spec.channelindex("Z"), id = spec.channelindex("id");
    REQUIRE(z >= 0);
    REQUIRE(id >= 0);
    CHECK(spec.channelformat(z) == OIIO::TypeFloat);
    CHECK(spec.channelformat(id) == OIIO::TypeUInt32);
    CHECK(spec.channelformat(spec.channelindex("R")) == OIIO::TypeHalf);
    // Uniform reads go through float, which cannot hold every number: read in the file's own types.
    std::vector<char> raw(4 * spec.pixel_bytes(true));
    REQUIRE(file->read_image(0, 0, 0, 5, OIIO::TypeUnknown, raw.data()));
    for (int i = 0; i < 4; ++i) {
        const char* pixel = &raw[i * spec.pixel_bytes(true)];
        const auto at = [&](int channel) { return pixel + spec.pixel_bytes(0, channel, true); };
        float depth = 0;
        std::uint32_t primitive = 0;
        std::memcpy(&depth, at(z), 4);
        std::memcpy(&primitive, at(id), 4);
        CHECK(depth == hits.hits[i].depth);
        CHECK(primitive == hits.hits[i].primitive);
    }
}

TEST_CASE("an existing picture is replaced", "[image]") {
    const TestFolder folder;
    const FrameSize size{3, 2};
    write_picture(folder / "a.png", grey_picture(size, 0), no_hits(size));
    write_picture(folder / "a.png", grey_picture(size, 1), no_hits(size));
    CHECK(compare(read_picture(folder / "a.png"), grey_picture(size, 1)).largest == 0);
    CHECK(folder.files() == 1);
}

TEST_CASE("pictures that cannot be written are refused in one sentence, with nothing left over", "[image]") {
    const TestFolder folder;
    const FrameSize size{4, 4};
    const auto refusal = [&](const std::string& path) {
        return complaint([&] { write_picture(path, grey_picture(size, 0.5f), no_hits(size)); });
    };
    for (const char* name : {"a.tif", "a.jpg", "a", "a.png.bak"}) {
        check_sentence(refusal(folder / name), folder / name, ".png, .exr");
        check_sentence(complaint([&] { check_picture_path(folder / name); }), folder / name, ".png, .exr");
    }
    fs::create_directory(folder / "d.png");
    check_sentence(refusal(folder / "d.png"), folder / "d.png", "is a directory");
    check_sentence(refusal(folder / "none/a.exr"), folder / "none/a.exr", "does not exist");
    put(folder / "file", "text");
    check_sentence(refusal(folder / "file/a.png"), folder / "file/a.png", "");
    // No one may create files here, not even root.
    check_sentence(refusal("/proc/a.png"), "/proc/a.png", "cannot be written");
    CHECK(complaint([&] { write_picture("", grey_picture(size, 0), no_hits(size)); }) != "");
    CHECK(folder.files() == 2);
}

TEST_CASE("an output file that is not published, or cannot be, leaves nothing and alters nothing", "[image]") {
    const TestFolder folder;
    put(folder / "old", "precious");
    {
        const OutputFile file(folder / "old");
        put(file.temporary().string(), "half of");
        CHECK(folder.files() == 2);
    }
    CHECK(folder.files() == 1);
    CHECK(contents(folder / "old") == "precious");
    {
        OutputFile file(folder / "late");
        put(file.temporary().string(), "whole");
        fs::create_directory(folder / "late");   // after the checks, before the end
        check_sentence(complaint([&] { file.publish(); }), folder / "late", "cannot be written");
    }
    CHECK(folder.files() == 2);
    OutputFile file(folder / "old");
    put(file.temporary().string(), "new");
    file.publish();
    CHECK(contents(folder / "old") == "new");
    CHECK(folder.files() == 2);
}

TEST_CASE("a picture whose hits have another size is refused", "[image]") {
    const TestFolder folder;
    check_sentence(complaint([&] { write_picture(folder / "a.exr", grey_picture({4, 4}, 0), no_hits({4, 3})); }),
                   folder / "a.exr", "size");
    CHECK(folder.files() == 0);
}

TEST_CASE("files that are not pictures are refused in one sentence", "[image]") {
    const TestFolder folder;
    const auto refusal = [](const std::string& path) { return complaint([&] { read_picture(path); }); };
    check_sentence(refusal(folder / "a.png"), folder / "a.png", "no such file");
    check_sentence(refusal(folder.path().string()), folder.path().string(), "directory");
    put(folder / "text.png", "not a picture at all");
    check_sentence(refusal(folder / "text.png"), folder / "text.png", "not a picture");
    put(folder / "empty.exr", "");
    check_sentence(refusal(folder / "empty.exr"), folder / "empty.exr", "not a picture");
    Picture noise = grey_picture({64, 64}, 0);
    for (std::size_t i = 0; i < noise.pixels.size(); ++i) noise.pixels[i].g = static_cast<float>(i * i % 251) / 251;
    for (const std::string ending : {".png", ".exr"})
        for (double part : {0.01, 0.5, 0.9}) {
            write_picture(folder / "whole" + ending, noise, no_hits(noise.size));
            const std::string whole = contents(folder / "whole" + ending);
            const auto kept = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
            put(folder / "cut" + ending, whole.substr(0, kept));
            CAPTURE(part);
            check_sentence(refusal(folder / "cut" + ending), folder / "cut" + ending, "not a picture");
        }
}

TEST_CASE("check_writable neither creates nor alters a file", "[image]") {
    const TestFolder folder;
    CHECK(complaint([&] { check_writable(folder / "new.json"); }) == "");
    CHECK(folder.files() == 0);
    put(folder / "old.png", "precious");
    const auto before = fs::last_write_time(folder / "old.png");
    CHECK(complaint([&] { check_writable(folder / "old.png"); }) == "");
    CHECK(contents(folder / "old.png") == "precious");
    CHECK(fs::last_write_time(folder / "old.png") == before);
    CHECK(folder.files() == 1);
    check_sentence(complaint([&] { check_writable(folder.path().string()); }), folder.path().string(), "directory");
    check_sentence(complaint([&] { check_writable(folder / "none/x"); }), folder / "none/x", "does not exist");
    CHECK(complaint([&] { check_picture_path(folder / "new.png"); }) == "");
    CHECK(folder.files() == 1);
    check_sentence(complaint([&] { check_picture_path(folder / "none/x.exr"); }), folder / "none/x.exr", "does not exist");
    check_sentence(complaint([&] { check_writable("/proc/x.png"); }), "/proc/x.png", "cannot be written");
    CHECK(complaint([&] { check_writable(""); }) != "");
}
