// rc_campaign: faults by the hundred, drawn at random or from a table, and what notices them.
//   rc_campaign rtl FOLDER SEED COUNT [ROWS]  draws faults of rtl/ and runs the torture set on each; with ROWS, where CMake has
//                                             written the rows of tests/meta/mutants_*.cmake, on those of rtl/ as well
//   rc_campaign model FOLDER SEED COUNT       the same for the model's arithmetic, beside the sound RTL
//   rc_campaign tests FOLDER COMMAND...       runs commands on what the torture set did not notice, until one fails
//   rc_campaign report FOLDER ARGUMENTS PERCENT  counts; the page ARGUMENTS says what is equivalent, and why
// FOLDER keeps all that is done; started again, a run goes on where it was.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

#include "model/core/rng.hpp"
#include "sim/rtl/builder.hpp"
#include "tests/meta/campaign/judge.hpp"
#include "tests/meta/campaign/schema.hpp"

namespace {

using namespace rayclock;
using namespace rayclock::campaign;
namespace fs = std::filesystem;

const fs::path source = RAYCLOCK_SOURCE_DIR;
constexpr int most_seconds = 60;    // of a torture run, on the processor
constexpr int first_row = 1000;     // numbers beyond are rows of a table

/// Parts of the model that a source includes.
const std::pair<std::string, std::string> parts_of_model[] = {{"model/trav/slab.inl", "model/trav/box.cpp"}};
/// Primitive tests that no RTL has, and pictures of hits alone: the torture set does not ask for them.
const std::string not_in_a_machine[] = {"model/isect/moller.cpp", "model/isect/woop.cpp", "model/isect/unit24.cpp", "model/isect/truncated.cpp", "model/shade/shade.cpp"};

/// COUNT of them, the operators in turn.
std::vector<Mutant> drawn(std::vector<Mutant> all, std::uint64_t seed, int count) {
    Rng rng(seed);
    std::map<std::string, std::vector<Mutant>> by_operator;
    for (Mutant& m : all) by_operator[m.fault.what].push_back(std::move(m));
    std::vector<Mutant> chosen;
    while (int(chosen.size()) < count && !by_operator.empty()) {
        for (auto it = by_operator.begin(); it != by_operator.end() && int(chosen.size()) < count;) {
            auto& list = it->second;
            const auto at = std::size_t(rng.below(int(list.size())));
            chosen.push_back(std::move(list[at]));
            list.erase(list.begin() + std::ptrdiff_t(at));
            it = list.empty() ? by_operator.erase(it) : std::next(it);
        }
    }
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i].number = int(i) + 1;
    return chosen;
}

/// A row of the table as a fault of one expression; none if it changes more than that.
std::optional<Mutant> of_row(const fs::path& row) {
    Mutant m;
    m.name = row.filename().string();
    m.file = text_of(row / "file");
    const std::string old = text_of(row / "old"), fresh = text_of(row / "new"), text = text_of(source / m.file);
    if (old.empty() || !m.file.starts_with("rtl/")) return {};
    std::size_t at = text.find(old), same = 0, tail = 0;
    while (same < std::min(old.size(), fresh.size()) && old[same] == fresh[same]) ++same;
    while (tail < std::min(old.size(), fresh.size()) - same && old[old.size() - 1 - tail] == fresh[fresh.size() - 1 - tail]) ++tail;
    m.line = line_of(text, at + same);
    m.fault = {"row", "", m.name};
    for (const Region& region : regions(text, Language::verilog)) {
        if (region.begin > at + same || region.end < at + old.size() - tail) continue;
        if (m.fault.text.empty() || region.end - region.begin < m.region.end - m.region.begin) {
            m.region = region;
            m.fault.text = blanked(text.substr(region.begin, at + same - region.begin) + fresh.substr(same, fresh.size() - tail - same) +
                                   text.substr(at + old.size() - tail, region.end - (at + old.size() - tail)), Language::verilog);
        }
    }
    return m;
}

void set_rtl(const fs::path& folder) {
    setenv("RAYCLOCK_RTL", (folder / "rtl").c_str(), 1);
    setenv("RAYCLOCK_CACHE", (folder / "cache").c_str(), 1);
}

/// Takes out what Verilator refuses, until it refuses nothing.
void write_legal(const fs::path& folder, std::vector<Mutant>& mutants, const Caller& caller) {
    const std::regex place("%Error[^:]*: ([^:]+):(\\d+):");
    for (bool again = true; again;) {
        again = false;
        write_schema(source, "rtl", folder / "rtl", mutants, Language::verilog, caller);
        for (const std::string& chip : torture_chips()) {
            const std::string said = lint_rtl(torture_chip(chip));
            std::set<int> out;
            for (std::sregex_iterator it(said.begin(), said.end(), place), end; it != end; ++it) {
                const std::string file = "rtl/" + fs::relative((*it)[1].str(), folder / "rtl").string();
                const int line = std::stoi((*it)[2].str());
                const std::string text = text_of(source / file);
                for (const Mutant& m : mutants)
                    if (m.file == file && line >= line_of(text, m.fault.late ? m.region.outside : m.region.begin) && line <= line_of(text, m.region.end)) out.insert(m.number);
            }
            for (const int number : out) fmt::print("cannot be built: {}\n", number);
            if (out.empty() && said.find("%Error") != std::string::npos) throw std::runtime_error("the copy of the RTL cannot be built:\n" + said.substr(0, 2000));
            if (out.empty() && said.find("%Warning") != std::string::npos) fmt::print("{}\n", said.substr(0, 600));
            std::erase_if(mutants, [&](const Mutant& m) { return out.contains(m.number); });
            if (!out.empty()) {
                again = true;
                break;
            }
        }
    }
}

/// number, file, line, operator, what it does
void write_list(const fs::path& folder, const std::vector<Mutant>& mutants) {
    std::ofstream list(folder / "mutants.new");
    for (const Mutant& m : mutants)
        list << m.number << '\t' << m.file << '\t' << m.line << '\t' << m.fault.what << '\t' << std::regex_replace(m.fault.shown, std::regex("[\n\t]"), " ") << '\n';
    list.close();
    fs::rename(folder / "mutants.new", folder / "mutants");
}

std::map<int, std::vector<std::string>> lines_of(const fs::path& file) {
    std::map<int, std::vector<std::string>> lines;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> parts;
        std::istringstream fields(line);
        for (std::string part; std::getline(fields, part, '\t');) parts.push_back(part);
        if (parts.size() > 1) lines[std::stoi(parts[0])] = parts;
    }
    return lines;
}

/// Runs the torture set on every mutant of FOLDER that was not judged before. `judge` is given its number, 0 for none.
int torture_all(const fs::path& folder, const std::function<Verdict(int)>& judge) {
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    if (const Verdict sound = judge(0); sound.noticed) throw std::runtime_error("with every fault asleep the torture set fails: " + sound.by);
    const auto mutants = lines_of(folder / "mutants"), done = lines_of(folder / "torture");
    std::ofstream results(folder / "torture", std::ios::app);
    int noticed = 0;
    for (const auto& [number, line] : mutants) {
        if (const auto it = done.find(number); it != done.end()) {
            noticed += it->second[1] == "noticed";
            continue;
        }
        const Verdict v = judge(number);
        noticed += v.noticed;
        results << number << '\t' << (v.noticed ? "noticed" : "survived") << '\t' << fmt::format("{:.1f}", v.seconds) << '\t' << (v.noticed ? v.by : "") << std::endl;
        if (!v.noticed) fmt::print("survived: {} {}:{} {}: {}\n", number, line[1], line[2], line[3], line[4]);
        std::fflush(stdout);
    }
    fmt::print("{} of {} noticed by the torture set\n", noticed, mutants.size());
    return 0;
}

/// The table's rows that change one expression, numbered from 1001 on.
void add_rows(const fs::path& rows, std::vector<Mutant>& mutants) {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(rows))
        if (fs::exists(entry.path() / "old")) all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    int number = first_row;
    for (const fs::path& row : all) {
        std::optional<Mutant> m = of_row(row);
        if (!m) continue;
        m->number = ++number;
        if (m->fault.text.empty()) fmt::print("more than an expression: {}\n", m->name);
        else mutants.push_back(*m);
    }
}

int rtl_campaign(const fs::path& folder, std::uint64_t seed, int count, const fs::path& rows) {
    if (!fs::exists(folder / "mutants")) {
        fs::create_directories(folder);
        set_rtl(folder);
        std::vector<Mutant> mutants = drawn(all_faults(source, "rtl", Language::verilog), seed, count);
        if (!rows.empty()) add_rows(rows, mutants);
        write_legal(folder, mutants, Caller(folder / "called"));
        write_list(folder, mutants);
    }
    const Caller caller(folder / "called");
    set_rtl(folder);
    caller.call(0);
    for (const std::string& chip : torture_chips()) build_rtl(torture_chip(chip));
    const TortureJudge judge(torture_chips());
    return torture_all(folder, [&](int number) {
        caller.call(number);
        const Verdict verdict = judge(most_seconds);
        caller.call(0);
        return verdict;
    });
}

/// The files of the model with faults in them, compiled one by one; what the compiler refuses is taken out. Returns the objects.
std::string compiled(const fs::path& folder, std::vector<Mutant>& mutants) {
    std::ofstream(folder / "fault.hpp") << "extern int rc_fault;\n";
    const std::regex place("([^:\n]+):(\\d+):\\d+: error");
    std::set<std::string> units;
    for (const Mutant& m : mutants) {
        if (m.file.ends_with(".cpp")) units.insert(m.file);
        else for (const auto& [part, unit] : parts_of_model) if (m.file == part) units.insert(unit);
    }
    std::string objects;
    for (const std::string& unit : units) {
        const fs::path object = folder / (std::regex_replace(unit, std::regex("/"), "_") + ".o"), log = folder / "log";
        for (;;) {
            write_schema(source, "model", folder / "model", mutants, Language::cpp, Caller(folder / "called"));
            const std::string command = fmt::format("c++ -std=c++20 -O1 -DNDEBUG -ffp-contract=off -w -include '{0}/fault.hpp' -I'{0}' -I'{1}' -c '{0}/{2}' -o '{3}' 2> '{4}'",
                                                    folder.string(), source.string(), unit, object.string(), log.string());
            if (std::system(command.c_str()) == 0) break;
            const std::string said = text_of(log);
            std::set<int> out;
            for (std::sregex_iterator it(said.begin(), said.end(), place), end; it != end; ++it) {
                const std::string file = fs::relative((*it)[1].str(), folder).string();
                const int line = std::stoi((*it)[2].str());
                if (!fs::exists(source / file)) continue;
                const std::string text = text_of(source / file);
                for (const Mutant& m : mutants)
                    if (m.file == file && line >= m.line && line <= line_of(text, m.region.end)) out.insert(m.number);
            }
            if (out.empty()) throw std::runtime_error("the copy of the model cannot be built:\n" + said.substr(0, 2000));
            for (const int number : out) fmt::print("cannot be built: {}\n", number);
            std::erase_if(mutants, [&](const Mutant& m) { return out.contains(m.number); });
        }
        objects += fmt::format(" '{}'", object.string());
    }
    return objects;
}

/// Makes FOLDER/campaign: this program with the model's faults in it.
int model_campaign(const fs::path& folder, std::uint64_t seed, int count) {
    if (!fs::exists(folder / "mutants")) {
        fs::create_directories(folder);
        std::vector<Mutant> all = all_faults(source, "model", Language::cpp);
        std::erase_if(all, [](const Mutant& m) {
            for (const char* part : {"model/isect/", "model/trav/", "model/list/", "model/raygen/", "model/shade/"})
                if (m.file.starts_with(part)) return m.file.ends_with(".hpp") || std::find(begin(not_in_a_machine), end(not_in_a_machine), m.file) != end(not_in_a_machine);
            return true;
        });
        std::vector<Mutant> mutants = drawn(std::move(all), seed, count);
        const std::string objects = compiled(folder, mutants);
        const std::string link = fmt::format("c++ -o '{}/campaign'{} {}", folder.string(), objects, CAMPAIGN_LIBRARIES);
        if (std::system(link.c_str()) != 0) throw std::runtime_error("the model with its faults cannot be linked");
        write_list(folder, mutants);
    }
    return std::system(fmt::format("'{0}/campaign' faults '{0}'", folder.string()).c_str()) == 0 ? 0 : 1;
}

int run_faults(const fs::path& folder) {
    for (const std::string& chip : torture_chips()) build_rtl(torture_chip(chip));
    const TortureJudge judge(torture_chips());
    return torture_all(folder, [&](int number) { return judge.with_fault(number, most_seconds); });
}

/// What the torture set did not notice, given to whole test programs, as many as it takes.
int tests_campaign(const fs::path& folder, const std::vector<std::string>& commands) {
    set_rtl(folder);
    const Caller caller(folder / "called");
    const auto mutants = lines_of(folder / "mutants"), tortured = lines_of(folder / "torture"), done = lines_of(folder / "tests");
    std::ofstream results(folder / "tests", std::ios::app);
    for (const auto& [number, line] : tortured) {
        if (line[1] != "survived" || done.contains(number)) continue;
        std::string by;
        for (const std::string& command : commands) {
            caller.call(number);
            const int status = std::system(("timeout 900 " + command + " > " + (folder / "log").string() + " 2>&1").c_str());
            if (status != 0) by = command;
            if (status != 0) break;
        }
        caller.call(0);
        results << number << '\t' << (by.empty() ? "survived" : "noticed") << '\t' << by << std::endl;
        const auto& m = mutants.at(number);
        fmt::print("{}: {} {}:{} {}: {} {}\n", by.empty() ? "survived" : "noticed", number, m[1], m[2], m[3], m[4], by);
        std::fflush(stdout);
    }
    return 0;
}

/// "file: what it does" of the faults that change nothing, as the page ARGUMENTS lists them, each with its reason.
std::set<std::string> equivalents(const fs::path& arguments) {
    std::set<std::string> all;
    std::ifstream in(arguments);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("- `") && line.find("`: ") != std::string::npos) all.insert(line.substr(3, line.find("`: ") - 3));
    return all;
}

/// Counts what was noticed of all that are no equivalents; fails below PERCENT.
int report(const fs::path& folder, const fs::path& arguments, double percent) {
    const auto mutants = lines_of(folder / "mutants"), tortured = lines_of(folder / "torture"), tested = lines_of(folder / "tests");
    const std::set<std::string> same = equivalents(arguments);
    const auto is_noticed = [](const auto& results, int number) { return results.contains(number) && results.at(number)[1] == "noticed"; };
    int all = 0, by_torture = 0, by_tests = 0, equivalent = 0;
    for (const auto& [number, m] : mutants) {
        if (number > first_row) continue;   // rows of the table have tests of their own
        const bool torture = is_noticed(tortured, number), noticed = torture || is_noticed(tested, number);
        if (!noticed && same.contains(m[1] + ": " + m[4])) {
            ++equivalent;
            continue;
        }
        ++all, by_torture += torture, by_tests += noticed;
        if (!noticed) fmt::print("not noticed: {} {}:{} {}: {}\n", number, m[1], m[2], m[3], m[4]);
    }
    const auto share = [&](int part) { return all > 0 ? 100.0 * part / all : 0; };
    fmt::print("{} faults, and {} that are equivalent: {} noticed by the torture set ({:.1f} %), {} with the tests ({:.1f} %)\n", all, equivalent,
               by_torture, share(by_torture), by_tests, share(by_tests));
    return share(by_tests) >= percent ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    try {
        if ((words.size() == 4 || words.size() == 5) && words[0] == "rtl")
            return rtl_campaign(fs::absolute(words[1]), std::stoull(words[2]), std::stoi(words[3]), words.size() == 5 ? fs::path(words[4]) : fs::path());
        if (words.size() == 4 && words[0] == "model") return model_campaign(fs::absolute(words[1]), std::stoull(words[2]), std::stoi(words[3]));
        if (words.size() == 2 && words[0] == "faults") return run_faults(fs::absolute(words[1]));
        if (words.size() == 4 && words[0] == "report") return report(words[1], words[2], std::stod(words[3]));
        if (words.size() >= 3 && words[0] == "tests") return tests_campaign(fs::absolute(words[1]), {words.begin() + 2, words.end()});
    } catch (const std::exception& e) {
        fmt::print(stderr, "rc_campaign: {}\n", e.what());
        return 1;
    }
    fmt::print(stderr, "rc_campaign rtl FOLDER SEED COUNT [ROWS] | model FOLDER SEED COUNT | tests FOLDER COMMAND... | report FOLDER ARGUMENTS PERCENT\n");
    return 2;
}
