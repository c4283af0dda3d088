// Picture files: a written file reads back exactly. Failures give one sentence and leave no file.
#include <csignal>
#include <cstring>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>

#include <OpenImageIO/imageio.h>

#include "sim/files/output.hpp"
#include "sim/files/image/codec.hpp"
#include "sim/files/image/srgb.hpp"
#include "tests/image/pictures.hpp"
#include "tests/support/files/complaint.hpp"
#include "tests/support/files/test_folder.hpp"

using namespace rayclock;
namespace fs = std::filesystem;

/// For the leak sanitizer: at the end of a truncated file OpenImageIO 2.4's png reader creates a string, then
/// libpng jumps over its destructor.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:OpenImageIO_v2_4::ImageInput::geterror\n";
}

namespace {

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// Requires one sentence that names the file, without a line break.
void check_sentence(const std::string& text, const std::string& path, const std::string& part) {
    CAPTURE(text);
    CHECK(text.find('\n') == std::string::npos);
    CHECK(text.rfind(path, 0) == 0);
    CHECK(text.find(part) != std::string::npos);
}

}   // namespace

TEST_CASE("png holds the clamped sRGB bytes of the picture", "[image]") {
    const test::TestFolder folder;
    Picture picture{{16, 17}, {}};
    for (int i = 0; i < 16 * 17; ++i) {
        const float v = static_cast<float>(linear_from_srgb(std::min(i, 255) / 255.0));
        picture.pixels.emplace_back(v, 1 - v, i % 2 ? -3.0f : 7.0f);
    }
    write_picture(folder.name("a.png"), picture, no_hits(picture.size));
    CHECK(folder.files() == 1);
    const auto file = OIIO::ImageInput::open(folder.name("a.png"));
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
    const test::TestFolder folder;
    Picture picture{{256, 1}, {}};
    for (int i = 0; i < 256; ++i)
        picture.pixels.emplace_back(static_cast<float>(linear_from_srgb(i / 255.0)));
    write_picture(folder.name("a.png"), picture, no_hits(picture.size));
    const Picture read = read_picture(folder.name("a.png"));
    CHECK(read.size == picture.size);
    CHECK(compare(picture, read).largest == 0);
    write_picture(folder.name("b.PNG"), read, no_hits(read.size));
    CHECK(contents(folder.name("a.png")) == contents(folder.name("b.PNG")));
}

TEST_CASE("exr keeps light beyond 1, depth and primitive numbers", "[image]") {
    const test::TestFolder folder;
    const Picture picture{{2, 2}, {{0.5f, 0.25f, 1000}, {0, 1, 2}, {-0.5f, 0, 0.125f}, {3, 3, 3}}};
    const HitFrame hits{
        {2, 2}, {{0, 1.2345678f, 0, 0}, {no_primitive, 0, 0, 0}, {16777217, 1e-20f, 0, 0}, {7, 3, 0, 0}}};
    write_picture(folder.name("a.exr"), picture, hits);
    CHECK(folder.files() == 1);
    const Picture read = read_picture(folder.name("a.exr"));
    CHECK(read.size == picture.size);
    CHECK(read.pixels == picture.pixels);
    const auto file = OIIO::ImageInput::open(folder.name("a.exr"));
    REQUIRE(file);
    const OIIO::ImageSpec spec = file->spec();
    const int z = spec.channelindex("Z"), id = spec.channelindex("id");
    REQUIRE(z >= 0);
    REQUIRE(id >= 0);
    CHECK(spec.channelformat(z) == OIIO::TypeFloat);
    CHECK(spec.channelformat(id) == OIIO::TypeUInt32);
    CHECK(spec.channelformat(spec.channelindex("R")) == OIIO::TypeHalf);
    // Uniform reads go through float, which cannot hold every number. So read in the file's own types.
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

namespace {

/// Faults of an encoder that reports success. They use the real one:
const PictureCodec* real = nullptr;

std::string last_pixel_differs(const char* plugin, const Picture& picture, const HitFrame& hits,
                               const std::function<bool()>& stop) {
    Picture wrong = picture;
    wrong.pixels.back() += 0.25f;
    return real->encode(plugin, wrong, hits, stop);
}
std::string last_number_differs(const char* plugin, const Picture& picture, const HitFrame& hits,
                                const std::function<bool()>& stop) {
    HitFrame wrong = hits;
    wrong.hits.back().primitive ^= 1;
    return real->encode(plugin, picture, wrong, stop);
}
std::string one_row_less(const char* plugin, const Picture& picture, const HitFrame& hits,
                         const std::function<bool()>& stop) {
    Picture wrong = picture;
    --wrong.size.height;
    return real->encode(plugin, wrong, hits, stop);
}
std::string half_a_file(const char* plugin, const Picture& picture, const HitFrame& hits,
                        const std::function<bool()>& stop) {
    const std::string whole = real->encode(plugin, picture, hits, stop);
    return whole.substr(0, whole.size() / 2);
}

}   // namespace

TEST_CASE("a picture that is encoded wrongly is refused, and the old file stays", "[image]") {
    const test::TestFolder folder;
    const FrameSize size{7, 131};   // two bands of rows, and part of a third
    real = &picture_codec();
    struct Fault {
        decltype(PictureCodec::encode) encode;
        std::string says;
        bool of_exr_only;
    };
    const Fault faults[] = {{last_pixel_differs, "pixel 6,130 differs", false},
                            {last_number_differs, "pixel 6,130 differs", true},
                            {one_row_less, "its header differs", false},
                            {half_a_file, "encoded it wrongly", false}};
    for (const char* name : {"a.png", "a.exr"})
        for (const Fault& fault : faults) {
            const bool is_exr = std::string(name) == "a.exr";
            if (fault.of_exr_only && !is_exr) continue;
            put(folder.name(name), "precious");
            PictureCodec codec = *real;
            codec.encode = fault.encode;
            const StandInCodec faulty(codec);
            const std::string said = test::complaint(
                [&] { write_picture(folder.name(name), grey_picture(size, 0.5f), no_hits(size)); });
            check_sentence(said, folder.name(name), "cannot be written: OpenImageIO ");
            check_sentence(said, folder.name(name), fault.says);
            CHECK(contents(folder.name(name)) == "precious");
            fs::remove(folder.name(name));
            CHECK(folder.files() == 0);
            if (!is_exr && !fault.of_exr_only)
                CHECK_THROWS_AS(png_bytes(grey_picture(size, 0.5f)), UserError);
        }
    write_picture(folder.name("a.exr"), grey_picture(size, 0.5f), no_hits(size));   // the real one again
    CHECK(folder.files() == 1);
}

TEST_CASE("an existing picture is replaced", "[image]") {
    const test::TestFolder folder;
    const FrameSize size{3, 2};
    write_picture(folder.name("a.png"), grey_picture(size, 0), no_hits(size));
    write_picture(folder.name("a.png"), grey_picture(size, 1), no_hits(size));
    CHECK(compare(read_picture(folder.name("a.png")), grey_picture(size, 1)).largest == 0);
    CHECK(folder.files() == 1);
}

TEST_CASE("writing that is stopped leaves what was there, and else every row is written", "[image]") {
    const test::TestFolder folder;
    const FrameSize size{3, 201};   // several bands of rows, and part of one
    Picture picture = grey_picture(size, 0);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = glm::vec3(static_cast<float>(linear_from_srgb(double(i / 3) / 255)));
    for (const char* name : {"a.png", "a.exr"}) {
        CAPTURE(name);
        write_picture(folder.name(name), picture, no_hits(size));
        const std::string before = contents(folder.name(name));
        CHECK(compare(picture, read_picture(folder.name(name))).largest == 0);
        int polls = 0;
        CHECK_THROWS_WITH(write_picture(folder.name(name), grey_picture(size, 1), no_hits(size),
                                        [&] { return ++polls > 1; }),
                          "interrupted: nothing is written");
        CHECK(polls == 5);   // before a band, twice before the end, before reading back, before replacing
        CHECK(contents(folder.name(name)) == before);
    }
}

TEST_CASE("pictures that cannot be written are refused in one sentence, with nothing left over", "[image]") {
    const test::TestFolder folder;
    const FrameSize size{4, 4};
    const auto refusal = [&](const std::string& path) {
        return test::complaint([&] { write_picture(path, grey_picture(size, 0.5f), no_hits(size)); });
    };
    for (const char* name : {"a.tif", "a.jpg", "a", "a.png.bak"}) {
        check_sentence(refusal(folder.name(name)), folder.name(name), ".png, .exr");
        check_sentence(test::complaint([&] { check_picture_path(folder.name(name)); }), folder.name(name),
                       ".png, .exr");
    }
    fs::create_directory(folder.name("d.png"));
    check_sentence(refusal(folder.name("d.png")), folder.name("d.png"), "is a directory");
    check_sentence(refusal(folder.name("none/a.exr")), folder.name("none/a.exr"), "does not exist");
    put(folder.name("file"), "text");
    check_sentence(refusal(folder.name("file/a.png")), folder.name("file/a.png"), "");
    // Nobody can create files here, not even root.
    check_sentence(refusal("/proc/a.png"), "/proc/a.png", "cannot be written");
    CHECK(test::complaint([&] { write_picture("", grey_picture(size, 0), no_hits(size)); }) != "");
    CHECK(folder.files() == 2);
}

/// While it lives, no file may grow beyond this size. It imitates a full disk, except for the error number.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &now);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST_CASE("a file that cannot be written to its end leaves the old one and nothing else", "[image]") {
    const test::TestFolder folder;
    const FrameSize size{40, 40};
    Picture noise = grey_picture(size, 0);
    for (std::size_t i = 0; i < noise.pixels.size(); ++i)
        noise.pixels[i] = glm::vec3(float(i * 2654435761u % 1000) / 1000);
    for (const char* name : {"a.png", "a.exr", "a.json", "none.png"}) {
        const std::string file = folder.name(name), picture = file.substr(file.size() - 3);
        const auto write = [&] {
            picture == "son" ? write_bytes(file, std::string(5000, 'x'))
                             : write_picture(file, noise, no_hits(size));
        };
        write();
        const auto whole = fs::file_size(file);
        const bool is_old = std::string(name) != "none.png";
        for (const auto room : {std::uintmax_t{0}, whole / 2, whole - 1}) {
            fs::remove(file);
            if (is_old) put(file, "precious");
            const int before = folder.files();
            {
                const FullDisk full(room);
                check_sentence(test::complaint(write), file, "cannot be written: File too large");
            }
            CHECK(folder.files() == before);
            if (is_old) CHECK(contents(file) == "precious");
        }
        const FullDisk just_enough(whole);
        CHECK(test::complaint(write).empty());
        CHECK(fs::file_size(file) == whole);
    }
    // The last bytes stay in a buffer until the file is closed; a full device accepts none.
    check_sentence(test::complaint([] { write_bytes("/dev/full", "x"); }), "/dev/full",
                   "No space left on device");
}

TEST_CASE("links, pipes and devices are no place for a picture", "[image]") {
    const test::TestFolder folder;
    put(folder.name("real.png"), "precious");
    fs::create_symlink("real.png", folder.name("link.png"));
    fs::create_symlink("nowhere.png", folder.name("dangling.png"));
    REQUIRE(::mkfifo((folder.name("pipe.png")).c_str(), 0600) == 0);
    const auto refusal = [&](const std::string& name) {
        return test::complaint([&] {
            write_picture(folder.name(name), grey_picture({2, 2}, 0), no_hits({2, 2}));
        });
    };
    check_sentence(refusal("link.png"), folder.name("link.png"), "symbolic link");
    check_sentence(refusal("dangling.png"), folder.name("dangling.png"), "symbolic link");
    check_sentence(refusal("pipe.png"), folder.name("pipe.png"), "pipe");
    check_sentence(test::complaint([&] { write_bytes(folder.name("link.png"), "x"); }),
                   folder.name("link.png"), "symbolic link");
    check_sentence(test::complaint([&] { write_bytes(folder.name("pipe.png"), "x"); }),
                   folder.name("pipe.png"),
                   "nobody reads");   // and does not wait
    CHECK(test::complaint([&] { write_bytes("/dev/null", "x"); }).empty());
    CHECK(contents(folder.name("real.png")) == "precious");
    CHECK(fs::is_symlink(folder.name("link.png")));
    CHECK(folder.files() == 4);
}

TEST_CASE("a picture whose hits have another size is refused", "[image]") {
    const test::TestFolder folder;
    check_sentence(test::complaint([&] {
                       write_picture(folder.name("a.exr"), grey_picture({4, 4}, 0), no_hits({4, 3}));
                   }),
                   folder.name("a.exr"), "size");
    CHECK(folder.files() == 0);
}

TEST_CASE("files that are not pictures are refused in one sentence", "[image]") {
    const test::TestFolder folder;
    const auto refusal = [](const std::string& path) { return test::complaint([&] { read_picture(path); }); };
    check_sentence(refusal(folder.name("a.png")), folder.name("a.png"), "no such file");
    check_sentence(refusal(folder.path().string()), folder.path().string(), "directory");
    put(folder.name("text.png"), "not a picture at all");
    check_sentence(refusal(folder.name("text.png")), folder.name("text.png"), "not a picture");
    put(folder.name("empty.exr"), "");
    check_sentence(refusal(folder.name("empty.exr")), folder.name("empty.exr"), "not a picture");
    Picture noise = grey_picture({64, 64}, 0);
    for (std::size_t i = 0; i < noise.pixels.size(); ++i)
        noise.pixels[i].g = static_cast<float>(i * i % 251) / 251;
    for (const std::string ending : {".png", ".exr"})
        for (double part : {0.01, 0.5, 0.9}) {
            write_picture(folder.name("whole" + ending), noise, no_hits(noise.size));
            const std::string whole = contents(folder.name("whole" + ending));
            const auto kept = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
            put(folder.name("cut" + ending), whole.substr(0, kept));
            CAPTURE(part);
            check_sentence(refusal(folder.name("cut" + ending)), folder.name("cut" + ending),
                           "not a picture");
        }
}

TEST_CASE("check_writable neither creates nor alters a file", "[image]") {
    const test::TestFolder folder;
    CHECK(test::complaint([&] { check_writable(folder.name("new.json")); }) == "");
    CHECK(folder.files() == 0);
    put(folder.name("old.png"), "precious");
    const auto before = fs::last_write_time(folder.name("old.png"));
    CHECK(test::complaint([&] { check_writable(folder.name("old.png")); }) == "");
    CHECK(contents(folder.name("old.png")) == "precious");
    CHECK(fs::last_write_time(folder.name("old.png")) == before);
    CHECK(folder.files() == 1);
    check_sentence(test::complaint([&] { check_writable(folder.path().string()); }), folder.path().string(),
                   "directory");
    check_sentence(test::complaint([&] { check_writable(folder.name("none/x")); }), folder.name("none/x"),
                   "does not exist");
    CHECK(test::complaint([&] { check_picture_path(folder.name("new.png")); }) == "");
    CHECK(folder.files() == 1);
    check_sentence(test::complaint([&] { check_picture_path(folder.name("none/x.exr")); }),
                   folder.name("none/x.exr"), "does not exist");
    check_sentence(test::complaint([&] { check_writable("/proc/x.png"); }), "/proc/x.png",
                   "cannot be written");
    CHECK(test::complaint([&] { check_writable(""); }) != "");
}
