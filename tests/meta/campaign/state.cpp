// The files in which a campaign keeps its faults and verdicts, so that it can go on later.
#include "tests/meta/campaign/state.hpp"

#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

std::string one_field(std::string text) {
    for (char& c : text)
        if (c == '\n' || c == '\t') c = ' ';
    return text;
}

}   // namespace

Lines lines_of(const fs::path& file) {
    Lines lines;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> parts;
        std::istringstream fields(line);
        for (std::string part; std::getline(fields, part, '\t');) parts.push_back(part);
        if (parts.size() > 1) lines[std::stoi(parts[0])] = parts;
    }
    return lines;
}

void write_list(const fs::path& file, const std::vector<Mutant>& mutants) {
    const fs::path fresh = file.string() + ".new";
    std::ofstream list(fresh);
    int last = 0;
    for (const Mutant& m : mutants) {
        if (m.number == last) continue;   // a row that changes several expressions
        last = m.number;
        list << m.number << '\t' << m.file << '\t' << m.line << '\t' << m.fault.what << '\t'
             << one_field(m.fault.shown) << '\n';
    }
    list.close();
    fs::rename(fresh, file);
}

bool is_noticed(const Lines& results, int number) {
    const auto it = results.find(number);
    return it != results.end() && it->second[1] == "noticed";
}

void append(const fs::path& file, int number, const Verdict& verdict) {
    std::ofstream results(file, std::ios::app);
    results << number << '\t' << (verdict.noticed ? "noticed" : "survived") << '\t'
            << fmt::format("{:.1f}", verdict.seconds) << '\t'
            << (verdict.noticed ? one_field(verdict.by) : "") << std::endl;
}

std::string description(const std::vector<std::string>& m) {
    return fmt::format("{}:{} {}: {}", m.at(1), m.at(2), m.at(3), m.at(4));
}

std::set<std::string> argued(const fs::path& page) {
    std::set<std::string> all;
    std::ifstream in(page);
    for (std::string line; std::getline(in, line);) {
        const std::size_t end = line.find("`: ");
        if (line.starts_with("- `") && end != std::string::npos) all.insert(line.substr(3, end - 3));
    }
    return all;
}

}   // namespace rayclock::campaign
