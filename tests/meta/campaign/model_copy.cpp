// A copy of the sources whose model contains all drawn faults, and a switch that chooses one.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>

#include <fmt/format.h>

#include "tests/meta/campaign/copies.hpp"
#include "tests/meta/campaign/draw.hpp"
#include "tests/meta/campaign/rows.hpp"
#include "tests/meta/campaign/state.hpp"

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

/// Where the machine's arithmetic is. Faults are drawn from its sources, not its headers.
constexpr const char* arithmetic[] = {"model/unit/tri/",  "model/engine/bvh/",  "model/engine/node_answer",
                                      "model/unit/list/", "model/unit/raygen/", "model/unit/shade/",
                                      "model/fixed/"};
/// Primitive tests that no RTL has, and pictures of hits alone: no machine runs them.
constexpr const char* not_in_a_machine[] = {
    "model/unit/tri/baselines/moller.cpp", "model/unit/tri/baselines/woop.cpp",
    "model/unit/tri/baselines/unit24.cpp", "model/unit/tri/baselines/truncated.cpp",
    "model/scene/hit_shading.cpp"};

/// What model and RTL share: memory images, memory's timing, pictures to compare with. A fault there changes
/// both alike.
constexpr const char* shared[] = {"model/compile/", "model/mem/dram",    "model/mem/memport",
                                  "model/core/",    "sim/judge/oracle/", "sim/judge/reference/",
                                  "model/scene/"};

bool is_shared(const Mutant& m) {
    const auto begins = [&](const char* folder) { return m.file.starts_with(folder); };
    return std::any_of(std::begin(shared), std::end(shared), begins);
}

bool is_drawn(const Mutant& m) {
    const auto begins = [&](const char* folder) { return m.file.starts_with(folder); };
    const auto is = [&](const char* file) { return m.file == file; };
    return !m.file.ends_with(".hpp") && std::any_of(std::begin(arithmetic), std::end(arithmetic), begins) &&
           std::none_of(std::begin(not_in_a_machine), std::end(not_in_a_machine), is);
}

/// Compiles what holds faults. `units`: what each source of the model includes.
class Compiler {
public:
    Compiler(fs::path source, fs::path folder) : source_(std::move(source)), folder_(std::move(folder)) {
        fs::create_directories(folder_ / "objects");
        std::ofstream(folder_ / "fault.hpp") << "extern int rc_fault;\n";
        for (const auto& entry : fs::recursive_directory_iterator(source_ / "model"))
            if (entry.path().extension() == ".cpp")
                units_[fs::relative(entry.path(), source_).string()] = included(entry.path());
    }

    /// Numbers of the mutants that the compiler refuses; none if all objects are made.
    std::set<int> refused(const std::vector<Mutant>& mutants) {
        write_schema(source_, "model", folder_ / "model", mutants, Language::cpp, caller_of(folder_));
        std::set<int> out;
        for (const auto& [unit, files] : units_) {
            std::set<int> numbers;
            for (const Mutant& m : mutants)
                if (files.contains(m.file)) numbers.insert(m.number);
            if (numbers.empty() || compiled_[unit] == numbers) continue;
            const std::set<int> some = compile(unit);
            if (some.empty()) compiled_[unit] = numbers;
            out.insert(some.begin(), some.end());
        }
        return out;
    }

private:
    std::set<std::string> included(const fs::path& unit) const {
        const fs::path list = folder_ / "included";
        if (shell(fmt::format("c++ -std=c++20 -MM -I'{}' '{}' > '{}'", source_.string(), unit.string(),
                              list.string())) != 0)
            throw std::runtime_error(unit.string() + " cannot be read");
        std::set<std::string> files;
        std::ifstream in(list);
        for (std::string word; in >> word;)
            if (word.starts_with(source_.string())) files.insert(fs::relative(word, source_).string());
        return files;
    }

    std::set<int> compile(const std::string& unit) const {
        const fs::path log = folder_ / "log";
        std::string object = unit;
        std::replace(object.begin(), object.end(), '/', '_');
        const std::string command = fmt::format(
            "c++ -std=c++20 -O2 -DNDEBUG -ffp-contract=off -w -include '{0}/fault.hpp' -I'{0}' -I'{1}' -c "
            "'{0}/{2}' "
            "-o '{0}/objects/{3}.o' 2> '{4}'",
            folder_.string(), source_.string(), unit, object, log.string());
        if (shell(command) == 0) return {};
        const std::string said = text_of(log);
        std::string errors;
        for (std::size_t at = said.find(" error: "); at != std::string::npos;
             at = said.find(" error: ", at + 1))
            errors += said.substr(said.rfind('\n', at) + 1, at - said.rfind('\n', at)) + "\n";
        const std::set<int> out = named_in(errors);
        if (!out.empty()) return out;
        if (const std::set<int> all = named_in(said); !all.empty()) return all;
        throw std::runtime_error("the copy of the model cannot be built:\n" + said.substr(0, 2000));
    }

    fs::path source_, folder_;
    std::map<std::string, std::set<std::string>> units_;
    std::map<std::string, std::set<int>> compiled_;
};

std::string objects_of(const fs::path& folder) {
    std::string objects;
    for (const auto& entry : fs::directory_iterator(folder / "objects"))
        objects += fmt::format(" '{}'", entry.path().string());
    return objects;
}

}   // namespace

int shell(const std::string& command) { return std::system(command.c_str()); }

void make_model_copy(const fs::path& source, const Order& order) {
    fs::create_directories(order.folder);
    std::vector<Mutant> all = all_faults(source, "model", Language::cpp);
    std::erase_if(all, [](const Mutant& m) { return !is_drawn(m); });
    Draw draw(std::move(all), order.seed);
    std::vector<std::string> others;
    std::vector<Mutant> rows, mutants, out;
    if (!order.rows.empty()) rows = all_rows(source, order.rows, "model/", others);
    fmt::print("{} rows are in what model and RTL share\n", std::erase_if(rows, is_shared));
    Compiler compiler(source, order.folder);
    for (;;) {
        while (int(mutants.size()) < order.count) {
            std::optional<Mutant> m = draw.next();
            if (!m) break;
            mutants.push_back(std::move(*m));
        }
        std::vector<Mutant> both = mutants;
        both.insert(both.end(), rows.begin(), rows.end());
        const std::set<int> numbers = compiler.refused(both);
        if (numbers.empty()) {
            write_list(order.folder / "refused", out);
            write_list(order.folder / "mutants", both);
            break;
        }
        for (const Mutant& m : both)
            if (numbers.contains(m.number)) out.push_back(m);
        for (std::vector<Mutant>* list : {&mutants, &rows})
            std::erase_if(*list, [&](const Mutant& m) { return numbers.contains(m.number); });
    }
    fmt::print("{} faults drawn, {} cannot be built; rows that one copy cannot hold: {}\n", mutants.size(),
               out.size(), others.size());
    for (const std::string& name : others) fmt::print("  {}\n", name);
    std::ofstream(order.folder / "fault.cpp")
        << "#include <cstdlib>\nint rc_fault = std::getenv(\"RC_FAULT\") ? "
           "std::atoi(std::getenv(\"RC_FAULT\")) : 0;\n";
}

void link_with_faults(const fs::path& folder, const fs::path& build, const std::string& program) {
    const fs::path list = folder / "commands";
    if (shell(fmt::format("ninja -C '{}' -t commands '{}' > '{}'", build.string(), program, list.string())) !=
        0)
        throw std::runtime_error("ninja does not know " + program);
    const std::string all = text_of(list), output = " -o " + program + " ";
    const std::size_t at = all.find(output);
    if (at == std::string::npos) throw std::runtime_error("ninja does not say how " + program + " is linked");
    const std::size_t line = all.rfind('\n', at) + 1, from = std::max(line, all.rfind("&& ", at) + 3);
    std::string command = all.substr(from, std::min(all.find(" && ", at), all.find('\n', at)) - from);
    const fs::path target = folder / fs::path(program).filename();
    command.replace(
        command.find(output), output.size(),
        fmt::format(" -o '{}' '{}/fault.cpp'{} ", target.string(), folder.string(), objects_of(folder)));
    if (shell(fmt::format("cd '{}' && {}", build.string(), command)) != 0)
        throw std::runtime_error(program + " with the model's faults cannot be linked");
}

}   // namespace rayclock::campaign
