// MTL: reads the statements that rayclock's surface model uses. A wrong value becomes a fault of its block.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/text.hpp"
#include "sim/load/mesh/mesh_file.hpp"

namespace rayclock {
namespace {

/// Reads "Kd r g b" or "Kd r". The spectral and CIE forms name a curve, which rayclock does not support; they
/// change nothing.
void colour(std::string_view key, std::string_view rest, const SourcePosition& at, glm::vec3& out) {
    std::array<double, 3> rgb{};
    int count = 0;
    for (std::string_view word = take_word(rest); !word.empty() && count < 3;
         word = take_word(rest), ++count) {
        if (word == "spectral" || word == "xyz") return;
        rgb[static_cast<std::size_t>(count)] = finite_number(word, at);
    }
    if (count != 1 && count != 3) at.refuse(fmt::format("{} needs 3 numbers and has {}", key, count));
    if (count == 1) rgb[1] = rgb[2] = rgb[0];
    out = glm::vec3(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
}

double single(std::string_view rest, const SourcePosition& at) {
    std::string_view word = take_word(rest);
    if (word == "-halo") word = take_word(rest);
    return finite_number(word, at);
}

double number_of(std::string_view& rest, const SourcePosition& at) {
    return finite_number(take_word(rest), at);
}

/// Reads one to three numbers. Keeps the first two.
void pair_of(std::string_view& rest, const SourcePosition& at, glm::dvec2& out) {
    out.x = number_of(rest, at);
    for (int k = 1; k < 3; ++k) {
        std::string_view after = rest;
        const std::optional<float> value = float_of(take_word(after));
        if (!value) return;
        if (k == 1) out.y = double(*value);
        rest = after;
    }
}

/// Reads "map_Kd -s 2 2 1 -clamp on wood.png". Options come first; a name may contain blanks.
MtlPicture picture_of(std::string_view rest, const SourcePosition& at) {
    MtlPicture picture;
    for (;;) {
        std::string_view after = rest;
        const std::string_view option = take_word(after);
        if (option == "-s") {
            pair_of(after, at, picture.scale);
        } else if (option == "-o") {
            pair_of(after, at, picture.offset);
        } else if (option == "-clamp") {
            picture.clamps = take_word(after) == "on";
        } else if (option == "-t") {
            glm::dvec2 turbulence{0};
            pair_of(after, at, turbulence);
            picture.ignored.emplace_back(option);
        } else if (option == "-mm") {
            number_of(after, at), number_of(after, at);
            picture.ignored.emplace_back(option);
        } else if (option == "-bm" || option == "-boost" || option == "-texres" || option == "-blendu" ||
                   option == "-blendv" || option == "-cc" || option == "-imfchan" || option == "-type") {
            take_word(after);
            picture.ignored.emplace_back(option);
        } else {
            break;
        }
        rest = after;
    }
    picture.file = joined_words(rest);
    std::replace(picture.file.begin(), picture.file.end(), '\\', '/');
    if (picture.file.empty()) at.refuse("map_Kd names no picture");
    return picture;
}

void statement(std::string_view key, std::string_view rest, const SourcePosition& at, bool draws_textures,
               MtlBlock& block) {
    MtlSurface& surface = block.surface;
    if (key == "map_Kd" && draws_textures) {
        block.picture = picture_of(rest, at);
        return;
    }
    block.has_diffuse = block.has_diffuse || key == "Kd";
    if (key == "Kd")
        colour(key, rest, at, surface.diffuse);
    else if (key == "Ks")
        colour(key, rest, at, surface.specular);
    else if (key == "Ke")
        colour(key, rest, at, surface.emission);
    else if (key == "Ns")
        surface.shine = static_cast<float>(single(rest, at));
    else if (key == "Ni")
        surface.index = static_cast<float>(single(rest, at));
    else if (key == "d")
        surface.opacity = static_cast<float>(single(rest, at));
    else if (key == "Tr")
        surface.opacity = static_cast<float>(1 - single(rest, at));
    else if (key == "illum")
        surface.illumination =
            static_cast<int>(std::clamp<std::int64_t>(whole_number(take_word(rest), at), -1, 11));
    else if (key.starts_with("map_") || key == "bump" || key == "disp" || key == "decal" || key == "refl")
        block.has_textures = true;
    // All other statements are ignored: ambient light, and extensions of many programs.
}

}   // namespace

std::vector<MtlBlock> read_mtl(const std::filesystem::path& path, std::string_view text, Loading& loading) {
    std::vector<MtlBlock> blocks;
    SourcePosition at{path.string()};
    Warnings warnings(at.file);
    for (std::string_view rest = without_mark(text); !rest.empty();) {
        const std::string_view whole = take_line(rest);
        ++at.line;
        check_text(whole, at, "MTL");
        std::string_view line = whole.substr(0, whole.find('#'));
        const std::string_view key = take_word(line);
        if (key == "newmtl") {
            std::string name = joined_words(line);
            if (name.empty()) {   // some OBJ files have a nameless `usemtl` that refers to it
                warnings.count("material", "without a name, taken as the default", at.line);
                name = "default";
            }
            blocks.push_back({.name = std::move(name), .surface = {}, .fault = {}});
        } else if (!blocks.empty() && blocks.back().fault.empty()) {
            try {
                statement(key, line, at, loading.draws_textures(), blocks.back());
            } catch (const UserError& error) {   // an error only if a face uses the material
                blocks.back().fault = error.what();
            }
        }
    }
    warnings.say(loading);
    return blocks;
}

}   // namespace rayclock
