// Writes all faults of a file into one source. A number selects the fault that is active.
#include "tests/meta/campaign/schema.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include <fmt/format.h>

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

std::string on_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// To the compiler the next line is the first of a file named after the mutant, so that its messages name the
/// mutant.
std::string begin_of(const Mutant& m, Language language) {
    return language == Language::verilog ? fmt::format("\n`line 1 \"rc_mutant_{}\" 0\n", m.number)
                                         : fmt::format("\n#line 1 \"rc_mutant_{}\"\n", m.number);
}
std::string back_in(const std::string& file, int line, Language language) {
    return language == Language::verilog ? fmt::format("\n`line {} \"{}\" 0\n", line, file)
                                         : fmt::format("\n#line {} \"{}\"\n", line, file);
}

/// What takes the place of a region: the sound expression unless a number is called.
std::string guarded(const std::string& plain, const std::vector<const Mutant*>& mutants,
                    const std::string& file, Language language) {
    const char* const number = language == Language::verilog ? "rc_mut::id" : "::rc_fault";
    const Region& region = mutants[0]->region;
    std::string text = "(";
    for (const Mutant* m : mutants) {
        const std::string fault =
            m->fault.late ? fmt::format("$signed(rc_late_{})", m->number) : on_one_line(m->fault.text);
        text += begin_of(*m, language) + fmt::format("{} == {} ? ({}) :", number, m->number, fault);
    }
    text += back_in(file, line_of(plain, region.begin), language);
    return text + "(" + plain.substr(region.begin, region.end - region.begin) + "))";
}

/// The items of a module that a mutant needs: the register of a value that is latched late, or what a row
/// brings along.
std::string items_of(const std::string& plain, const Mutant& m, const std::string& file, std::size_t at) {
    const std::string value = on_one_line(plain.substr(m.region.begin, m.region.end - m.region.begin));
    const std::string items =
        !m.fault.late
            ? on_one_line(m.added)
            : fmt::format(
                  "logic [$bits({0})-1:0] rc_late_{1}; always_ff @(posedge clk_i) rc_late_{1} <= ({2});",
                  m.region.target, m.number, value);
    return begin_of(m, Language::verilog) + items + back_in(file, line_of(plain, at), Language::verilog);
}

struct Edit {
    std::size_t size = 0;   ///< characters that go
    std::string text;       ///< what comes
};

std::string with_mutants(const std::string& text, const std::vector<Mutant>& mutants, const std::string& file,
                         Language language) {
    const std::string plain = blanked(text, language);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<const Mutant*>> by_region;
    for (const Mutant& m : mutants)
        if (m.file == file) by_region[{m.region.begin, m.region.end}].push_back(&m);
    std::map<std::size_t, Edit> edits;
    std::size_t last_end = 0;
    for (const auto& [place, there] : by_region) {
        if (place.first < last_end)
            throw std::logic_error(
                fmt::format("{}:{}: expressions overlap", file, line_of(plain, place.first)));
        last_end = place.second;
        edits[place.first] = {place.second - place.first, guarded(plain, there, file, language)};
        for (const Mutant* m : there) {
            const std::size_t at = m->fault.late ? m->region.outside : m->added_at;
            if (m->fault.late || !m->added.empty())
                edits[at].text = items_of(plain, *m, file, at) + edits[at].text;
        }
    }
    std::string out = text;
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
        out.replace(edit->first, edit->second.size, edit->second.text);
    return out;
}

/// Modules that can be built alone read the number.
constexpr const char* tops[] = {"rc_top", "rc_dispatch", "rc_sched",       "rc_raygen",     "rc_trav",
                                "rc_box", "rc_tri",      "rc_list",        "rc_node_cache", "rc_prim_cache",
                                "rc_l2",  "rc_shade",    "rc_unit_vector", "rc_pass",       "rc_power",
                                "rc_tex", "rc_log",      "rc_path_length"};

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

void finish_rtl(const fs::path& to, const Caller& caller) {
    write(to / "a_first/rc_mut.sv", "package rc_mut;\n  int id;\nendpackage\n");
    std::string rules;
    for (const char* rule : {"WIDTH", "UNUSED", "UNUSEDSIGNAL", "UNUSEDPARAM", "CMPCONST", "UNSIGNED",
                             "UNOPTFLAT", "SELRANGE", "VARHIDDEN", "BLKSEQ", "CASEINCOMPLETE", "DECLFILENAME",
                             "MULTIDRIVEN", "ALWCOMBORDER", "LATCH", "PROCASSWIRE", "UNDRIVEN"})
        rules += fmt::format("lint_off -rule {}\n", rule);
    write(to / "lint.vlt", text_of(to / "lint.vlt") + rules);
    for (const auto& entry : fs::recursive_directory_iterator(to))
        for (const char* top : tops) {
            if (entry.path().filename() != std::string(top) + ".sv") continue;
            std::string text = text_of(entry.path());
            const std::string read = fmt::format(
                "  initial begin : rc_mut_read\n    int from, got;\n    from = $fopen(\"{}\", \"r\");\n"
                "    got = $fscanf(from, \"%d\", rc_mut::id);\n    $fclose(from);\n  end\n",
                caller.file().string());
            write(entry.path(), text.insert(text.rfind("endmodule"), read));
        }
}

}   // namespace

void Caller::call(int number) const { write(file_, std::to_string(number) + "\n"); }

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

int line_of(const std::string& text, std::size_t at) {
    return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(std::min(at, text.size())), '\n'));
}

std::vector<Mutant> all_faults(const fs::path& source, const std::string& folder, Language language) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
        const std::string ending = entry.path().extension();
        const bool is_source = language == Language::verilog
                                   ? ending == ".sv" && entry.path().filename() != "rc_pkg.sv"
                                   : ending == ".cpp" || ending == ".hpp" || ending == ".inl";
        if (is_source) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<Mutant> all;
    for (const fs::path& path : files) {
        const std::string text = text_of(path), plain = blanked(text, language);
        for (const Region& region : regions(text, language))
            for (Fault& fault : faults(plain, region, language))
                all.push_back({0, fs::relative(path, source).string(), line_of(text, region.begin), region,
                               std::move(fault), "", 0});
    }
    return all;
}

void write_schema(const fs::path& source, const std::string& folder, const fs::path& to,
                  const std::vector<Mutant>& mutants, Language language, const Caller& caller) {
    fs::remove_all(to);
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
        if (!entry.is_regular_file()) continue;
        const std::string file = fs::relative(entry.path(), source).string();
        write(to / fs::relative(entry.path(), source / folder),
              with_mutants(text_of(entry.path()), mutants, file, language));
    }
    if (language == Language::verilog) finish_rtl(to, caller);
}

std::set<int> named_in(const std::string& said) {
    static const std::regex name("rc_mutant_(\\d+)");
    std::set<int> numbers;
    for (std::sregex_iterator it(said.begin(), said.end(), name), end; it != end; ++it)
        numbers.insert(std::stoi((*it)[1].str()));
    return numbers;
}

}   // namespace rayclock::campaign
