#include "tests/meta/campaign/schema.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

std::string on_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// What takes the place of a region: the sound expression unless a number is called.
std::string guarded(const std::string& plain, const Region& region, const std::vector<const Mutant*>& mutants, Language language) {
    const char* const number = language == Language::verilog ? "rc_mut::id" : "::rc_fault";
    std::string text = "(";
    for (const Mutant* m : mutants)
        text += fmt::format("{} == {} ? ({}) : ", number, m->number, m->fault.late ? fmt::format("$signed(rc_late_{})", m->number) : on_one_line(m->fault.text));
    return text + "(" + plain.substr(region.begin, region.end - region.begin) + "))";
}

/// The register of a value that is latched late.
std::string late_register(const std::string& plain, const Mutant& m) {
    return fmt::format("logic [$bits({0})-1:0] rc_late_{1}; always_ff @(posedge clk_i) rc_late_{1} <= ({2}); ", m.region.target, m.number,
                       on_one_line(plain.substr(m.region.begin, m.region.end - m.region.begin)));
}

std::string with_mutants(const std::string& text, const std::vector<Mutant>& mutants, const std::string& file, Language language) {
    const std::string plain = blanked(text, language);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<const Mutant*>> by_region;
    for (const Mutant& m : mutants)
        if (m.file == file) by_region[{m.region.begin, m.region.end}].push_back(&m);
    std::map<std::size_t, std::pair<std::size_t, std::string>> edits;   // at: how many characters go, and what comes
    for (const auto& [place, there] : by_region) {
        edits[place.first] = {place.second - place.first, guarded(plain, there[0]->region, there, language)};
        for (const Mutant* m : there)
            if (m->fault.late) edits[m->region.outside].second += late_register(plain, *m);
    }
    std::string out = text;
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) out.replace(edit->first, edit->second.first, edit->second.second);
    return out;
}

/// Modules that can be built alone read the number.
constexpr const char* tops[] = {"rc_top", "rc_dispatch", "rc_sched", "rc_raygen", "rc_trav", "rc_box", "rc_tri", "rc_list", "rc_node_cache",
                                "rc_prim_cache", "rc_l2", "rc_shade", "rc_unit", "rc_pass", "rc_power"};

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

void finish_rtl(const fs::path& to, const Caller& caller) {
    write(to / "a_first/rc_mut.sv", "package rc_mut;\n  int id;\nendpackage\n");
    std::string rules;
    for (const char* rule : {"WIDTH", "UNUSED", "UNUSEDSIGNAL", "UNUSEDPARAM", "CMPCONST", "UNSIGNED", "UNOPTFLAT", "SELRANGE", "VARHIDDEN", "BLKSEQ",
                             "CASEINCOMPLETE", "DECLFILENAME", "MULTIDRIVEN", "ALWCOMBORDER", "LATCH", "PROCASSWIRE", "CMPCONST", "UNDRIVEN"})
        rules += fmt::format("lint_off -rule {}\n", rule);
    write(to / "lint.vlt", text_of(to / "lint.vlt") + rules);
    for (const auto& entry : fs::recursive_directory_iterator(to))
        for (const char* top : tops) {
            if (entry.path().filename() != std::string(top) + ".sv") continue;
            std::string text = text_of(entry.path());
            const std::string read = fmt::format("  initial begin : rc_mut_read\n    int from, got;\n    from = $fopen(\"{}\", \"r\");\n"
                                                 "    got = $fscanf(from, \"%d\", rc_mut::id);\n    $fclose(from);\n  end\n", caller.file().string());
            write(entry.path(), text.insert(text.rfind("endmodule"), read));
        }
}

} // namespace

void Caller::call(int number) const { write(file_, std::to_string(number) + "\n"); }

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

int line_of(const std::string& text, std::size_t at) { return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(std::min(at, text.size())), '\n')); }

std::vector<Mutant> all_faults(const fs::path& source, const std::string& folder, Language language) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
        const std::string ending = entry.path().extension();
        if (language == Language::verilog ? ending == ".sv" && entry.path().filename() != "rc_pkg.sv" : ending == ".cpp" || ending == ".hpp" || ending == ".inl")
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<Mutant> all;
    for (const fs::path& path : files) {
        const std::string text = text_of(path), plain = blanked(text, language);
        for (const Region& region : regions(text, language))
            for (Fault& fault : faults(plain, region, language))
                all.push_back({0, "", fs::relative(path, source).string(), line_of(text, region.begin), region, std::move(fault)});
    }
    return all;
}

void write_schema(const fs::path& source, const std::string& folder, const fs::path& to, const std::vector<Mutant>& mutants, Language language, const Caller& caller) {
    fs::remove_all(to);
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
        if (!entry.is_regular_file()) continue;
        const std::string file = fs::relative(entry.path(), source).string();
        write(to / fs::relative(entry.path(), source / folder), with_mutants(text_of(entry.path()), mutants, file, language));
    }
    if (language == Language::verilog) finish_rtl(to, caller);
}

std::string changed_text(const fs::path& source, const Mutant& m) {
    return text_of(source / m.file).replace(m.region.begin, m.region.end - m.region.begin, m.fault.text);
}

} // namespace rayclock::campaign
