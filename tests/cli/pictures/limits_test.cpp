// The distance of a picture from the reference: every command that compares prints it in one sentence, and
// verify fails.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;

namespace {

/// In this frame 14 of 432 pixels are on edges that rings share: 3.2 % hold another primitive, and PSNR is 76
/// dB.
const std::vector<std::string> frame{"rings:3", "--size", "24x18"};
const std::string sentence =
    "FAR FROM THE REFERENCE: 3.24 % of the pixels hold another primitive (limit 1 %, --max-other)";

ProgramRun run(const std::string& command, std::vector<std::string> more) {
    std::vector<std::string> arguments{command};
    arguments.insert(arguments.end(), frame.begin(), frame.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
bool begins(const std::string& text, const std::string& part) { return text.rfind(part, 0) == 0; }

}   // namespace

TEST_CASE("verify fails beyond a limit, also beyond one that was not typed") {
    struct Typed {
        std::vector<std::string> limits;
        std::string sentence;   ///< empty: within the limits
    };
    const auto typed = GENERATE(
        Typed{{}, sentence}, Typed{{"--max-other", "3.3%"}, {}},
        Typed{{"--max-other", "3.3%", "--min-psnr", "60"}, {}},
        Typed{
            {"--max-other", "3.2%", "--min-psnr", "200"},
            "FAR FROM THE REFERENCE: 3.24 % of the pixels hold another primitive (limit 3.2 %, --max-other); "
            "PSNR 76.2 dB (limit 200 dB, --min-psnr)"});
    const ProgramRun outcome = run("verify", typed.limits);
    INFO(outcome.out);
    CHECK(outcome.code == (typed.sentence.empty() ? 0 : 1));
    CHECK(has(outcome.out, "FAR") == !typed.sentence.empty());
    CHECK(begins(outcome.out, typed.sentence.empty() ? "rings" : typed.sentence + "\n"));
    CHECK(has(outcome.out, typed.sentence.empty()
                               ? "  VERIFIED in"
                               : "  FAILED: model and RTL agree, and are far from the reference in"));
}

TEST_CASE("all commands that compare begin with the same sentence") {
    const TestFolder folder;
    const std::string picture = folder.name("p.png"), report = folder.name("r.json"),
                      page = folder.name("r.html");
    struct Command {
        std::string name;
        std::vector<std::string> more;
    };
    const auto command =
        GENERATE(Command{"simulate", {}}, Command{"explain", {"12,9"}}, Command{"render", {"--compare"}},
                 Command{"sweep", {"--axis", "contexts=8,16", "--no-netlist", "--clock", "66"}});
    std::vector<std::string> more = command.more;
    if (command.name == "render") more.insert(more.end(), {"-o", picture});
    more.insert(more.end(), {"--json", report});
    if (command.name != "render") more.insert(more.end(), {"--report", page});
    const ProgramRun far = run(command.name, more);
    INFO(command.name << far.out << far.err);
    CHECK(far.code == 0);
    CHECK(begins(far.out, sentence));
    const auto limits = nlohmann::json::parse(content_of(report)).at("limits");
    CHECK(limits.at("far") == true);
    CHECK(begins(limits.at("sentence").get<std::string>(), sentence));
    if (command.name != "render") CHECK(has(content_of(page), "<header><p class=\"far\">" + sentence));

    more.insert(more.end(), {"--max-other", "4%"});
    const ProgramRun within = run(command.name, more);
    CHECK(within.code == 0);
    CHECK(!has(within.out, "FAR"));
    CHECK(nlohmann::json::parse(content_of(report)).at("limits").at("sentence").is_null());
    if (command.name != "render") CHECK(!has(content_of(page), "class=\"far\""));
}

TEST_CASE("a sweep says which of its points is farthest, and which points are far") {
    const TestFolder folder;
    const std::string report = folder.name("r.json");
    const ProgramRun swept = run_program({"sweep", "tetra:2", "--size", "24x18", "--axis", "contexts=8,16",
                                          "--axis", "coord_bits=12,18", "--no-netlist", "--clock", "66",
                                          "--max-depth-error", "0.01%", "--json", report});
    INFO(swept.out << swept.err);
    CHECK(begins(swept.out, "FAR FROM THE REFERENCE: a pixel's depth is off by "));
    CHECK(has(swept.out,
              "(limit 0.01 %, --max-depth-error) (contexts 8, coord_bits 12; 2 of 4 points are far)"));
    CHECK(nlohmann::json::parse(content_of(report)).at("limits").at("points") ==
          nlohmann::json{true, false, true, false});
}

TEST_CASE("every frame of a film is held against the limits, and the farthest is named", "[long]") {
    const TestFolder folder;
    // The last frame shows only background and equals the reference's.
    const std::vector<std::string> frames{"--frames", "3", "--pan", "90"};
    const std::string told = sentence + " (frame 1; 1 of 3 frames are far)";
    const auto command = GENERATE("simulate", "verify", "render");
    std::vector<std::string> more = frames;
    const std::string report = folder.name("r.json");
    more.insert(more.end(), {"--json", report});
    if (std::string(command) == "render") more.insert(more.end(), {"--compare", "-o", folder.name("film")});
    const ProgramRun far = run(command, more);
    INFO(command << far.out << far.err);
    CHECK(far.code == (std::string(command) == "verify" ? 1 : 0));
    CHECK(begins(far.out, told + "\n"));
    const auto limits = nlohmann::json::parse(content_of(report)).at("limits");
    CHECK(limits.at("sentence") == told);
    CHECK(limits.at("beyond_other") == true);
    more.insert(more.end(), {"--max-other", "4%"});
    if (std::string(command) == "render") more[more.size() - 3] = folder.name("other");
    const ProgramRun within = run(command, more);
    INFO(within.out << within.err);
    CHECK(within.code == 0);
    CHECK(!has(within.out, "FAR"));
}

TEST_CASE("compare says which of its reports are far from the reference") {
    const TestFolder folder;
    const std::string a = folder.name("a.json"), b = folder.name("b.json"), page = folder.name("page.html"),
                      json = folder.name("c.json");
    REQUIRE(run("simulate", {"--json", a}).code == 0);
    REQUIRE(run("simulate", {"--json", b, "--max-other", "4%"}).code == 0);
    const std::string told = sentence + " (A: " + a + ")";
    const ProgramRun both = run_program({"compare", a, b, "--report", page, "--json", json});
    INFO(both.out << both.err);
    CHECK(begins(both.out, told + "\n"));
    CHECK(has(content_of(page), "<p class=\"far\">" + told + "</p>"));
    CHECK(nlohmann::json::parse(content_of(json)).at("far") == nlohmann::json{told, nullptr});
    CHECK(!has(run_program({"compare", b, b}).out, "FAR"));
}

TEST_CASE("a depth that is far off is reported, and has a separate limit") {
    // The eye is as close to the surface as the lattice is coarse.
    std::vector<std::string> close{"simulate", "square",       "--size", "24x18",
                                   "--eye",    "0,0,0.000006", "--at",   "0,0,-1"};
    const ProgramRun far = run_program(close);
    CHECK(far.code == 0);
    CHECK(begins(far.out,
                 "FAR FROM THE REFERENCE: a pixel's depth is off by 26.7 % (limit 1 %, --max-depth-error)"));
    close.insert(close.end(), {"--max-depth-error", "27%"});
    CHECK(begins(run_program(close).out, "square"));
    close.front() = "verify", close.back() = "26%";
    CHECK(run_program(close).code == 1);
}

TEST_CASE("the report has the limits and what is beyond them") {
    const ProgramRun outcome = run(
        "verify", {"--min-psnr", "200", "--max-other", "3.3%", "--max-depth-error", "200%", "--json", "-"});
    CHECK(outcome.code == 1);
    const auto report = nlohmann::json::parse(outcome.out);
    nlohmann::json limits = report["limits"];
    CHECK(begins(limits["sentence"].get<std::string>(), "FAR FROM THE REFERENCE: PSNR 76"));
    limits.erase("sentence");
    CHECK(limits == nlohmann::json{{"max_other_percent", 3.3},
                                   {"min_psnr_db", 200.0},
                                   {"max_depth_error_percent", 200.0},
                                   {"beyond_other", false},
                                   {"beyond_psnr", true},
                                   {"beyond_depth", false},
                                   {"far", true}});
}

TEST_CASE("limits that are no percentages or numbers are refused") {
    check_refused(run("verify", {"--max-other", "many"}), {"--max-other", "many"});
    check_refused(run("simulate", {"--max-other", "-1%"}), {"--max-other", "-1"});
    check_refused(run("explain", {"1,1", "--max-other", "3\xd4" + std::string(500, '7')}),
                  {"--max-other: '3\\xd477", "...", "is not a percentage"});
    check_refused(run("verify", {"--min-psnr", "nan"}), {"--min-psnr", "nan"});
    check_refused(run("sweep", {"--axis", "contexts=8", "--max-depth-error", "0.1"}),
                  {"--max-depth-error", "0.1"});
    check_refused(run("render", {"--compare", "--engine", "reference", "-o", "never.png"}), {"--compare"});
}
