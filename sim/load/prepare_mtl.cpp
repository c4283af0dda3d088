// MTL: the statements that our surface model has a use for, checked with their line and written anew.
#include <array>

#include <fmt/format.h>

#include "sim/load/file.hpp"
#include "sim/load/prepare.hpp"
#include "sim/load/text.hpp"

namespace rayclock {
namespace {

/// "Kd r g b" or "Kd r"; the spectral and CIE forms name a curve, which we do not have, and are skipped.
std::string colour(std::string_view key, std::string_view rest, const Place& at) {
    std::array<double, 3> rgb{};
    int count = 0;
    for (std::string_view word = take_word(rest); !word.empty() && count < 3; word = take_word(rest), ++count) {
        if (word == "spectral" || word == "xyz") return {};
        rgb[static_cast<std::size_t>(count)] = finite_number(word, at);
    }
    if (count != 1 && count != 3) at.refuse(fmt::format("{} needs 3 numbers and has {}", key, count));
    if (count == 1) rgb[1] = rgb[2] = rgb[0];
    return fmt::format("{} {} {} {}\n", key, rgb[0], rgb[1], rgb[2]);
}

double single(std::string_view rest, const Place& at) {
    std::string_view word = take_word(rest);
    if (word == "-halo") word = take_word(rest);
    return finite_number(word, at);
}

std::string plain(std::string_view key, std::string_view rest, const Place& at) {
    if (key == "Kd" || key == "Ks") return colour(key, rest, at);
    if (key == "Ns" || key == "Ni" || key == "d") return fmt::format("{} {}\n", key, single(rest, at));
    if (key == "Tr") return fmt::format("d {}\n", 1 - single(rest, at));
    if (key == "illum") return fmt::format("illum {}\n", whole_number(take_word(rest), at));
    return {};  // textures, bump maps, ambient light and the extensions of many programs
}

} // namespace

std::vector<MtlBlock> read_mtl(const std::filesystem::path& path) {
    std::vector<MtlBlock> blocks;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return blocks;
    const std::string text = read_file(path);
    Place at{path.string()};
    for (std::string_view rest = without_mark(text); !rest.empty();) {
        const std::string_view whole = take_line(rest);
        ++at.line;
        check_text(whole, at, "MTL");
        std::string_view line = whole.substr(0, whole.find('#'));
        const std::string_view key = take_word(line);
        if (key == "newmtl") {
            std::string name;
            for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) (name += name.empty() ? "" : " ") += word;
            if (name.empty()) at.refuse("newmtl without a name");
            blocks.push_back({std::move(name), {}});
        } else if (!blocks.empty()) {
            blocks.back().text += plain(key, line, at);
        }
    }
    return blocks;
}

} // namespace rayclock
