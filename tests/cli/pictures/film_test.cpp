// Films: numbered frames, one animated picture, and invalid options of time.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;
using nlohmann::json;

namespace {

using Words = std::vector<std::string>;

Words film_of(Words more, int frames = 3) {
    Words all{"simulate",       "crowd:2", "--set",    "levels=2",
              "--size",         "32x24",   "--frames", std::to_string(frames),
              "--no-reference", "--clock", "66"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Returns the number of pictures in an animated PNG (its chunk acTL); 0 for any other file.
std::uint32_t pictures_of(const std::string& png) {
    const std::size_t at = png.find("acTL");
    if (at == std::string::npos || at + 8 > png.size()) return 0;
    std::uint32_t count = 0;
    for (std::size_t i = 4; i < 8; ++i) count = count << 8 | std::uint8_t(png[at + i]);
    return count;
}

json frames_of(const Words& words) {
    const ProgramRun outcome = run_program(words);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out)["film"]["clocks"][0]["frames"];
}

}   // namespace

TEST_CASE("a film is numbered frames that differ, and one picture that plays them all") {
    const TestFolder folder;
    const std::string out = folder.name("film");
    const ProgramRun outcome = run_program(film_of({"--fps", "4", "-o", out}));
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const std::string first = content_of(out + "/frame_0000.png"),
                      second = content_of(out + "/frame_0001.png");
    CHECK(first.starts_with("\x89PNG"));
    CHECK(first != second);
    CHECK(second != content_of(out + "/frame_0002.png"));
    CHECK(pictures_of(content_of(out + "/film.png")) == 3);
    // A shorter film in the same folder leaves no file of the longer one.
    REQUIRE(run_program(film_of({"--fps", "4", "-o", out}, 2)).code == 0);
    CHECK(pictures_of(content_of(out + "/film.png")) == 2);
    CHECK(folder.contents().count("film/frame_0002.png") == 0);
    CHECK(content_of(out + "/frame_0001.png") == second);
}

TEST_CASE("a film that does not show its frames is refused") {
    const TestFolder folder;
    const std::string out = folder.name("film"), tools = folder.name("tools");
    std::filesystem::create_directory(tools);
    // Films with a wrong second frame, or a wrong frame rate.
    const std::pair<std::string, std::string> faults[] = {
        {"cp \"$d/frame_0000.png\" \"$d/frame_0001.png\"", "frame 1 differs"},
        {"set -- \"$1\" \"$2\" 7 1000 -kc", "frame 0 is shown for 7/1000 s"},
        {"rm \"$d/frame_0002.png\"", "it has 2 frames instead of 3"}};
    for (const auto& [fault, words] : faults) {
        CAPTURE(fault);
        folder.write("tools/apngasm",
                     "#!/bin/sh\nd=$(mktemp -d)\ncp frame_*.png \"$d\"\n" + fault +
                         "\nfilm=$1\nshift\n(cd \"$d\" && /usr/bin/apngasm film.png \"$@\")\n"
                         "cp \"$d/film.png\" \"$film\"\nrm -r \"$d\"\n");
        std::filesystem::permissions(tools + "/apngasm", std::filesystem::perms::owner_all);
        const ProgramRun outcome =
            run_program(film_of({"--fps", "4", "-o", out}), {"PATH=" + tools + ":/usr/bin:/bin"});
        CHECK_THAT(outcome.out + outcome.err, Catch::Contains("read back, " + words));
        CHECK_FALSE(std::filesystem::exists(out + "/film.png"));
    }
}

TEST_CASE("without the program that makes films there are frames, and a sentence") {
    const TestFolder folder;
    const std::string out = folder.name("film");
    const ProgramRun outcome = run_program(film_of({"-o", out}), {"PATH=" + folder.name("nothing")});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("no film: the program apngasm is not installed"));
    const auto left = folder.contents();
    CHECK(left.count("film/frame_0002.png") == 1);
    CHECK(left.count("film/film.png") == 0);
    CHECK_THAT(run_program({"doctor"}, {"PATH=" + folder.name("nothing")}).out,
               Catch::Contains("films stay separate frames"));
}

TEST_CASE("an incomplete film keeps the old film and its frames") {
    const TestFolder folder;
    const std::string out = folder.name("film"),
                      path = "PATH=" + folder.name("bin") + ":" + std::getenv("PATH");
    REQUIRE(run_program(film_of({"--fps", "4", "-o", out})).code == 0);
    const auto before = folder.contents();
    std::filesystem::create_directory(folder.name("bin"));
    // Each leaves what a full disk leaves; the last one reports no error.
    for (const std::string then :
         {"echo 'ERROR: disk'; exit 1", "rm film.png", "truncate -s -1 film.png", "truncate -s 60 film.png",
          "printf x | dd of=film.png bs=1 seek=99 conv=notrunc"}) {
        INFO(then);
        const std::string fake =
            folder.write("bin/apngasm", "#!/bin/sh\n/usr/bin/apngasm \"$@\"\n" + then + "\n");
        std::filesystem::permissions(fake, std::filesystem::perms::owner_all);
        const ProgramRun outcome =
            run_program(film_of({"--fps", "4", "-o", out, "--set", "coord_bits=12"}), {path});
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.err, Catch::Contains("film.png"));
        auto after = folder.contents();
        after.erase("bin"), after.erase("bin/apngasm");
        CHECK(after == before);
    }
}

TEST_CASE("times of frames are what --fps and --time say, and a second buffer draws the same") {
    const json between = frames_of(film_of({"--fps", "4", "--json", "-"}));
    REQUIRE(between.size() == 3);
    CHECK(between[2]["time"] == 0.5);
    CHECK(between[1]["upload_cycles"].get<int>() > 0);
    const json twice = frames_of(film_of({"--fps", "4", "--uploads", "double", "--json", "-"}));
    for (std::size_t f = 0; f < 3; ++f) {
        INFO("frame " << f);
        CHECK(twice[f]["node_steps"] == between[f]["node_steps"]);
        CHECK(twice[f]["triangle_tests"] == between[f]["triangle_tests"]);
        if (f > 0) CHECK(twice[f]["upload_cycles"] == 0);
    }
    const json later = frames_of(film_of({"--time", "0.25:0.75", "--json", "-"}));
    CHECK(later[0]["time"] == 0.25);
    CHECK(later[1]["time"].get<double>() > 0.25);
    CHECK(later[2]["time"].get<double>() <= 0.75);
}

TEST_CASE("the report lists refitted and rebuilt trees of every frame") {
    const TestFolder folder;
    // Strips that are first next to each other and then cross each other.
    std::ostringstream a, b, faces;
    for (int i = 0; i < 40; ++i) {
        a << "v " << i << " 0 0\nv " << i << " 1 0\nv " << i << " 0 1\n";
        b << "v " << i * 7 % 40 << " 0 0\nv " << i * 11 % 40 << " 1 0\nv " << i * 13 % 40 << " 0 1\n";
        faces << "f " << 3 * i + 1 << ' ' << 3 * i + 2 << ' ' << 3 * i + 3 << '\n';
    }
    folder.write("a.obj", a.str() + faces.str());
    folder.write("b.obj", b.str() + faces.str());
    const std::string scene = folder.write("s.json", R"({"meshes": {"m": {"shapes": [
        {"time": 0, "file": "a.obj"}, {"time": 1, "file": "b.obj"}]}}, "objects": [{"mesh": "m"}]})");
    for (const char* levels : {"levels=1", "levels=2"}) {
        INFO(levels);
        const auto film = [&](Words more) {
            Words all{"simulate", scene, "--set",  levels, "--size",         "32x24",   "--time", "0:1.2",
                      "--fps",    "5",   "--json", "-",    "--no-reference", "--clock", "66"};
            all.insert(all.end(), more.begin(), more.end());
            return frames_of(all);
        };
        const json usual = film({}), never = film({"--rebuild", "1e9"}), always = film({"--rebuild", "0"});
        REQUIRE(usual.size() == 6);
        int refitted = 0, rebuilt = 0;
        for (std::size_t f = 1; f < usual.size(); ++f) {
            refitted += usual[f]["host_refitted"].get<int>();
            rebuilt += usual[f]["host_rebuilt"].get<int>();
            CHECK(usual[f]["host_cost"].get<double>() <= 1.5);
            CHECK(never[f]["host_refitted"] == 1);
            CHECK(never[f]["host_rebuilt"] == 0);
            CHECK(always[f]["host_rebuilt"] == 1);
            CHECK(usual[f]["bytes_written"].get<int>() > 0);
            CHECK(usual[f]["host_whole"] == false);
        }
        CHECK(refitted > 0);
        CHECK(rebuilt > 0);
        CHECK(never[5]["host_cost"].get<double>() > 1.5);
        CHECK(never[5]["node_steps"].get<int>() > always[5]["node_steps"].get<int>());
    }
    const ProgramRun said = run_program({"simulate", scene, "--frames", "2", "--fps", "2", "--size", "8x6",
                                         "--no-reference", "--clock", "66"});
    CHECK_THAT(said.out, Catch::Contains("refitted") && Catch::Contains("refit or rebuild its trees"));
}

TEST_CASE("illegal options of a film are refused") {
    const std::vector<std::pair<Words, Words>> bad{{{"--fps", "0"}, {"--fps", "0.001..10000", "0"}},
                                                   {{"--fps", "nan"}, {"--fps", "nan"}},
                                                   {{"--fps", "x"}, {"--fps", "x"}},
                                                   {{"--time", "2:1"}, {"--time", "2:1"}},
                                                   {{"--time", "1:1"}, {"--time", "1:1", "length 0"}},
                                                   {{"--time", "1e99"}, {"--time", "1e99"}},
                                                   {{"--uploads", "never"}, {"--uploads", "never"}},
                                                   {{"--rebuild", "-1"}, {"--rebuild", "-1"}},
                                                   {{"--rebuild", "nan"}, {"--rebuild", "nan"}},
                                                   {{"--rebuild", "x"}, {"--rebuild", "x"}}};
    for (const auto& [options, words] : bad) check_refused(run_program(film_of(options)), words);
    const ProgramRun still = run_program(
        {"simulate", "teapot:3", "--size", "8x6", "--frames", "2", "--fps", "5", "--no-reference"});
    CHECK(still.code == 0);
    CHECK_THAT(still.err, Catch::Contains("nothing moves in this scene"));
}

namespace {

/// Returns the report of a simulation of 320x256 pixels at 66 MHz.
json film_report(Words more) {
    more.insert(more.begin(), "simulate");
    more.insert(more.end(), {"--size", "320x256", "--no-reference", "--clock", "66", "--json", "-"});
    const ProgramRun outcome = run_program(more);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return json::parse(outcome.out);
}

void require_same_keys(const json& one, const json& other) {
    for (const auto& [key, value] : one.items()) {
        INFO(key);
        REQUIRE(other.contains(key));
        if (value.is_object() && other[key].is_object()) require_same_keys(value, other[key]);
        if (value.is_array() && other[key].is_array() && !value.empty()) {
            REQUIRE(value.size() == other[key].size());
            if (value[0].is_object()) require_same_keys(value[0], other[key][0]);
        }
    }
}

}   // namespace

TEST_CASE("a sampled film has the keys of an exact one, and its means and sums are those of its frames") {
    const Words film{"crowd:2", "--frames", "3", "--fps", "2"};
    Words with_sample = film;
    with_sample.insert(with_sample.end(), {"--sample", "5%", "--seed", "7"});
    const json exact = film_report(film), sampled = film_report(with_sample);
    require_same_keys(exact, sampled);
    const json &sampling = sampled["sampling"], &frames = sampling["frames"],
               &whole = exact["clocks"][0]["frames"];
    REQUIRE(frames.size() == 3);
    REQUIRE(sampled["clocks"][0]["frames"].size() == 3);
    for (const auto& [key, figure] : sampling["film"][0]["figures"].items()) {
        INFO(key);
        double sum = 0, widest = 0, all = 0;
        for (const json& frame : frames) {
            const json& one = frame["clocks"][0]["figures"][key];
            sum += one["estimate"].get<double>();
            widest = std::max(widest, one["half_width"].get<double>());
            all += one["half_width"].get<double>();
        }
        CHECK(figure["mean"].get<double>() == Approx(sum / 3));
        CHECK(figure["mean_half_width"].get<double>() <= Approx(all / 3));
        const bool is_rate = key == "fps" || key.ends_with("rate");
        CHECK(figure.contains("sum") != is_rate);
        if (!is_rate) CHECK(figure["sum"].get<double>() == Approx(sum));
        // The errors of the frames are independent, so they partly cancel in the sum.
        if (key == "cycles") CHECK(figure["sum_half_width"].get<double>() < 0.9 * all);
    }
    for (std::size_t f = 0; f < 3; ++f) {
        CHECK(frames[f]["seed"] == 7 + f);
        CHECK(frames[f]["time"] == exact["film"]["clocks"][0]["frames"][f]["time"]);
        const json& frame = sampled["clocks"][0]["frames"][f];
        CHECK(frame["cycles"].get<double>() ==
              Approx(frames[f]["clocks"][0]["figures"]["cycles"]["estimate"].get<double>()).margin(1));
        CHECK(frame["reset_cycles"] == whole[f]["reset_cycles"]);
        CHECK(frame["bytes_written"] == whole[f]["bytes_written"]);
        // All writes are simulated, but the memory's refreshes have another phase.
        CHECK(frame["upload_cycles"].get<double>() ==
              Approx(whole[f]["upload_cycles"].get<double>()).epsilon(0.02).margin(60));
        CHECK(frame["fps"].get<double>() == Approx(whole[f]["fps"].get<double>()).epsilon(0.1));
    }
}

TEST_CASE("a frame of a sampled film is the sample of this frame alone, with its own seed") {
    const json film = film_report(
        {"crowd:2", "--frames", "2", "--time", "0.5:1.5", "--sample", "5%", "--seed", "7"})["sampling"];
    for (const auto& [time, seed] : {std::pair{"0.5", 7}, {"1", 8}}) {
        const json alone = film_report(
            {"crowd:2", "--time", time, "--sample", "5%", "--seed", std::to_string(seed)})["sampling"];
        const json& frame = film["frames"][std::size_t(seed) - 7]["clocks"][0]["figures"];
        for (const auto& [key, figure] : alone["clocks"][0]["figures"].items()) {
            INFO(key);
            if (key != "fps") CHECK(frame[key] == figure);   // which includes the host's writes
        }
    }
}

TEST_CASE("the caches of a sampled film with a still scene are warm from the second frame on") {
    const auto bytes_of_last = [](Words more) {
        more.insert(more.end(), {"--sample", "5%", "--set", "node_sets=1024", "--set", "prim_sets=1024"});
        return film_report(more)["sampling"]["clocks"][0]["figures"]["dram_bytes"]["estimate"].get<double>();
    };
    // The same parts with the same warm-up, except that the first part of a single frame starts cold. This
    // part reads few lines.
    const double cold = bytes_of_last({"mount:5", "--fov", "20", "--seed", "8"}),
                 warm = bytes_of_last({"mount:5", "--fov", "20", "--frames", "2", "--seed", "7"});
    CHECK(warm < cold - 128);
}
