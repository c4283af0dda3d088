// Samplers, surfaces and images of COLLADA 1.4 and 1.5.
#include "sim/load/dae/texture.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "sim/files/text.hpp"

namespace rayclock {
namespace {

/// Returns the word inside a sampler's child, or an empty word if the child is missing.
std::string word_of(const XmlElement& sampler, const char* name) {
    const XmlElement* const child = sampler.find(name);
    return child ? joined_words(child->text) : std::string();
}

/// Returns the file that a URI names. An absolute URI belongs to the author's machine, see portable_name().
std::string file_of_uri(std::string uri) {
    constexpr std::string_view scheme = "file:";
    if (lower(uri).starts_with(scheme)) uri.erase(0, scheme.size());
    return portable_name(decode_percent(uri));
}

}   // namespace

std::optional<std::uint32_t> DaeTextures::texture(const XmlElement& in, const DaeParams& params) {
    if (!document_.loading().draws_textures()) return std::nullopt;
    const Source source = this->source(in, params);
    if (!source.file) return std::nullopt;
    Texture made{.name = printable(*source.file, 80), .pyramid = files_.pyramid(folder_, *source.file)};
    if (!made.pyramid) return std::nullopt;
    if (source.sampler) sample(*source.sampler, made);
    const Key key{*source.file, made.wrap_s, made.wrap_t, made.nearest, made.mipmaps};
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(all_.size()));
    if (is_new) all_.push_back(std::move(made));
    return found->second;
}

std::optional<glm::vec3> DaeTextures::average(const XmlElement& in, const DaeParams& params) {
    if (document_.loading().draws_textures()) return std::nullopt;
    const Source source = this->source(in, params);
    const auto mean = source.file ? files_.average(folder_, *source.file) : std::nullopt;
    return mean ? std::optional(glm::vec3(*mean)) : std::nullopt;
}

DaeTextures::Source DaeTextures::source(const XmlElement& in, const DaeParams& params) {
    Source made;
    std::string name = in.attribute("texture");
    const XmlElement* image = nullptr;
    const auto param = [&](const char* kind) -> const XmlElement* {
        const auto found = params.find(name);
        return found != params.end() && found->second->name == kind ? found->second : nullptr;
    };
    if (made.sampler = param("sampler2D"); made.sampler) {
        name = word_of(*made.sampler, "source");
        if (const XmlElement* const instance = made.sampler->find("instance_image"))
            image = document_.find(instance->attribute("url"));
    }
    if (const XmlElement* const surface = param("surface")) name = word_of(*surface, "init_from");
    if (!image) image = document_.with_id(name);
    if (!image || image->name != "image")
        warnings_.count("texture", "that names no image of the file, not drawn", in.line,
                        in.attribute("texture"));
    else
        made.file = file_of(*image);
    return made;
}

/// Returns the name of an image's file: the text of <init_from>, or in COLLADA 1.5 the text of its <ref>.
std::optional<std::string> DaeTextures::file_of(const XmlElement& image) {
    const XmlElement* const from = image.find("init_from");
    const XmlElement* const ref = from ? from->find("ref") : nullptr;
    const std::string uri = from ? joined_words(ref ? ref->text : from->text) : std::string();
    if (!uri.empty()) return file_of_uri(uri);
    warnings_.count("image", "without the name of a file, not drawn", image.line, image.attribute("id"));
    return std::nullopt;
}

Wrap DaeTextures::wrap(const XmlElement& sampler, const char* name) {
    const std::string word = word_of(sampler, name);
    if (word.empty() || word == "WRAP") return Wrap::repeat;
    if (word == "CLAMP") return Wrap::clamp;
    if (word == "MIRROR") return Wrap::mirror;
    if (word == "MIRROR_ONCE") {   // COLLADA 1.5
        warnings_.count("sampler", "that mirrors its picture once, drawn mirrored everywhere", sampler.line);
        return Wrap::mirror;
    }
    if (word != "BORDER" && word != "NONE")
        document_.refuse(
            *sampler.find(name),
            fmt::format("{} is {} instead of WRAP, MIRROR, CLAMP, BORDER or NONE", name, shown(word)));
    warnings_.count("sampler", "with a border around its picture, drawn clamped to the picture's edge",
                    sampler.line);
    return Wrap::clamp;
}

/// Mip levels follow from `minfilter` in COLLADA 1.4, and from `mipfilter` in 1.5.
void DaeTextures::sample(const XmlElement& sampler, Texture& out) {
    out.wrap_s = wrap(sampler, "wrap_s"), out.wrap_t = wrap(sampler, "wrap_t");
    const auto filter = [&](const char* name) {
        constexpr std::array<std::string_view, 9> known{"",
                                                        "NONE",
                                                        "NEAREST",
                                                        "LINEAR",
                                                        "NEAREST_MIPMAP_NEAREST",
                                                        "LINEAR_MIPMAP_NEAREST",
                                                        "NEAREST_MIPMAP_LINEAR",
                                                        "LINEAR_MIPMAP_LINEAR",
                                                        "ANISOTROPIC"};
        std::string word = word_of(sampler, name);
        if (std::find(known.begin(), known.end(), word) == known.end())
            document_.refuse(*sampler.find(name),
                             fmt::format("{} is {}, which COLLADA does not define", name, shown(word)));
        return word;
    };
    const std::string smaller = filter("minfilter"), levels = filter("mipfilter");
    out.nearest = filter("magfilter").starts_with("NEAREST");
    const bool has_one_level =
        levels.empty() ? smaller == "NEAREST" || smaller == "LINEAR" : levels == "NONE";
    out.mipmaps = !has_one_level || smaller.find("MIPMAP") != smaller.npos;
}

}   // namespace rayclock
