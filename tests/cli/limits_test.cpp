// How far a picture may be from the reference's: said by default, and a failure if the limit was typed.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace rayclock::test;

namespace {

/// In this frame 14 of 432 pixels lie on edges that rings share: 3.2 % hold another primitive, and PSNR is 76
/// dB.
Outcome verify(std::vector<std::string> limits) {
    std::vector<std::string> arguments{"verify", "rings:3", "--size", "24x18"};
    arguments.insert(arguments.end(), limits.begin(), limits.end());
    return run_program(arguments);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}   // namespace

TEST_CASE("a picture beyond the limits is said to be far, and fails only if a limit was typed") {
    const Outcome untyped = verify({});
    INFO(untyped.out);
    CHECK(untyped.code == 0);
    CHECK(has(untyped.out,
              "FAR FROM THE REFERENCE: 3.24 % of the pixels hold another primitive, and 1 % is the limit "
              "(--max-other)"));
    CHECK(has(untyped.out, "VERIFIED, but far from the reference in"));

    struct Typed {
        std::vector<std::string> limits;
        int code;
        std::vector<std::string> words;
    };
    const auto typed =
        GENERATE(Typed{{"--max-other", "3.2%"},
                       1,
                       {"3.24 % of the pixels", "3.2 % is the limit (--max-other)", "FAILED in"}},
                 Typed{{"--min-psnr", "200"},
                       1,
                       {"3.24 % of the pixels", "200 dB is the limit (--min-psnr)", "FAILED in"}},
                 Typed{{"--max-other", "3.3%"}, 0, {"VERIFIED in"}},
                 Typed{{"--max-other", "3.3%", "--min-psnr", "60"}, 0, {"VERIFIED in"}});
    const Outcome outcome = verify(typed.limits);
    INFO(outcome.out);
    CHECK(outcome.code == typed.code);
    for (const std::string& words : typed.words) {
        INFO(words);
        CHECK(has(outcome.out, words));
    }
    CHECK(has(outcome.out, "FAR") == (typed.code == 1));
}

TEST_CASE("the report has the limits and what is beyond them") {
    const Outcome outcome = verify({"--min-psnr", "200", "--max-other", "3.3%", "--json", "-"});
    CHECK(outcome.code == 1);
    const auto report = nlohmann::json::parse(outcome.out);
    CHECK(report["limits"] == nlohmann::json{{"max_other_percent", 3.3},
                                             {"min_psnr_db", 200.0},
                                             {"fails", true},
                                             {"beyond_other", false},
                                             {"beyond_psnr", true}});
}

TEST_CASE("limits that are none are refused") {
    check_refused(verify({"--max-other", "many"}), {"--max-other", "many"});
    check_refused(verify({"--max-other", "-1%"}), {"--max-other", "-1"});
    check_refused(verify({"--max-other", "3\xd4" + std::string(500, '7')}),
                  {"--max-other: '3\\xd477", "...", "is not a percentage"});
    check_refused(verify({"--min-psnr", "nan"}), {"--min-psnr", "nan"});
}
