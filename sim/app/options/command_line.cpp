// Stores the command line and quotes it for reports.
#include "sim/app/options/command_line.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace rayclock {

std::string shell_word(const std::string& word) {
    constexpr const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=.,:/@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string out = "'";
    for (const char c : word)
        if (c == '\'')
            out += "'\\''";
        else
            out += c;
    return out + "'";
}

namespace {

std::vector<std::string> typed;

std::string shell_line(const std::vector<std::string>& words) {
    std::string line = "rayclock";
    for (const std::string& word : words) line += " " + shell_word(word);
    return line;
}

}   // namespace

void keep_command_line(int argc, char** argv) { typed.assign(argv + std::min(argc, 1), argv + argc); }

std::string command_line() { return shell_line(typed); }

std::string explain_line(int khz) {
    // options of simulate that explain lacks; each takes a value
    constexpr std::array others{"--clock", "--engine", "--json", "--report", "-o", "--output"};
    std::vector<std::string> words{"explain"};
    for (std::size_t i = 1; i < typed.size(); ++i) {
        const std::string name = typed[i].substr(0, typed[i].find('='));
        if (std::find(others.begin(), others.end(), name) != others.end())
            i += name == typed[i];
        else
            words.push_back(typed[i]);
    }
    return shell_line(words) + fmt::format(" --clock {:g} PIXEL", khz / 1e3);
}

std::vector<std::pair<std::string, std::string>> versions() {
    return {{"rayclock", RAYCLOCK_VERSION}, {"compiler", __VERSION__}};
}

}   // namespace rayclock
