// Reading base textures, and tinting materials by their averages.
#include "sim/load/gltf/textures.hpp"

#include <cmath>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {

bool GltfTextures::tint(GltfMaterial& material) {
    const JsonValue textures = list("textures"), reference = *material.base_texture;
    const JsonValue texture = textures[reference.at("index").whole(textures.size())];
    const auto source = texture.find("source");
    if (!source) {   // the picture comes from an extension
        material.has_textures = true;
        return false;
    }
    const std::uint64_t image = source->whole(list("images").size());
    const auto [found, is_new] = averages_.try_emplace(image);
    if (is_new) found->second = average(image);
    if (!found->second) return false;
    material.surface.colour *= *found->second;
    count_opacity(material);
    return true;
}

/// The colour's alpha holds the opacity of the picture. It counts only in the mode BLEND.
void GltfTextures::count_opacity(GltfMaterial& material) const {
    if (material.is_masked && material.surface.colour.a < 1)
        warnings_.count("material", "with holes in its texture, drawn without them", 0, material.name);
    if (!material.blends) material.surface.colour.a = 1;
}

std::optional<std::uint32_t> GltfTextures::texture(const GltfMaterial& material) {
    if (!loading_.draws_textures()) return std::nullopt;
    const JsonValue textures = list("textures");
    const std::uint64_t number = material.base_texture->at("index").whole(textures.size());
    const JsonValue texture = textures[number];
    const auto source = texture.find("source");
    if (!source) return std::nullopt;   // the picture comes from an extension
    const std::uint64_t image = source->whole(list("images").size());
    const auto [found, is_new] = pictures_.try_emplace(image);
    if (is_new) found->second = picture(image);
    if (!found->second.pyramid) return std::nullopt;
    const auto [known, is_unknown] = numbers_.try_emplace(number, static_cast<std::uint32_t>(all_.size()));
    if (is_unknown) {
        Texture made{.name = fmt::format("textures[{}]", number), .pyramid = found->second.pyramid};
        sample(texture, made);
        all_.push_back(std::move(made));
        opacities_.push_back(found->second.opacity);
    }
    return known->second;
}

void GltfTextures::take_opacity(GltfMaterial& material, std::uint32_t texture) const {
    material.surface.colour.a *= opacities_[texture];
    if (!material.blends) material.surface.colour.a = 1;   // a MASK has holes instead
}

/// Applies the sampler, which has the numbers of OpenGL.
void GltfTextures::sample(const JsonValue& texture, Texture& out) const {
    const auto reference = texture.find("sampler");
    if (!reference) return;
    const JsonValue samplers = list("samplers"), sampler = samplers[reference->whole(samplers.size())];
    const auto wrap = [&](std::string_view key) {
        const auto given = sampler.find(key);
        if (!given || given->raw() == 10497) return Wrap::repeat;
        if (given->raw() == 33071) return Wrap::clamp;
        if (given->raw() == 33648) return Wrap::mirror;
        given->expected("33071 (clamp), 33648 (mirror) or 10497 (repeat)");
    };
    out.wrap_s = wrap("wrapS"), out.wrap_t = wrap("wrapT");
    constexpr std::uint64_t nearest = 9728, linear = 9729, far = std::uint64_t{1} << 32;
    out.nearest = sampler.whole_or("magFilter", far, linear) == nearest;
    const std::uint64_t smaller = sampler.whole_or("minFilter", far, 0);
    out.mipmaps = smaller != nearest && smaller != linear;
}

// The README of KHR_texture_transform: translation * rotation * scale. Its rotation is anticlockwise in a
// picture whose t counts down.
glm::dvec2 GltfMapping::operator()(const glm::dvec2& st) const {
    const glm::dvec2 scaled = st * scale;
    const double c = std::cos(rotation), s = std::sin(rotation);
    return offset + glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
}

GltfMapping GltfTextures::mapping(const GltfMaterial& material) const {
    GltfMapping out;
    const JsonValue& reference = *material.base_texture;
    constexpr std::uint64_t max_sets = 1000;
    out.set = reference.whole_or("texCoord", max_sets, 0);
    const auto extensions = reference.find("extensions");
    const auto transform = extensions ? extensions->find("KHR_texture_transform") : std::nullopt;
    if (!transform) return out;
    out.set = transform->whole_or("texCoord", max_sets, out.set);
    out.rotation = transform->number_or("rotation", 0);
    const auto pair = [&](std::string_view key, glm::dvec2& pair) {
        const auto given = transform->find(key);
        if (!given) return;
        if (given->array().size() != 2) given->expected("2 numbers");
        pair = {(*given)[0].number(), (*given)[1].number()};
    };
    pair("offset", out.offset), pair("scale", out.scale);
    return out;
}

/// A picture that cannot be read gives a null pyramid without a note: average() adds one.
GltfTextures::GltfPicture GltfTextures::picture(std::uint64_t image) {
    std::string bytes, why;
    try {
        bytes = buffers_.image(image);
    } catch (const UserError&) {
        return {};
    }
    GltfPicture made{read_pyramid(bytes, file_, fmt::format("the texture images[{}]", image), loading_, why)};
    if (!made.pyramid) return made;
    double sum = 0;
    const TexelLevel& level = made.pyramid->levels.front();
    for (const auto& texel : level.texels) sum += texel[3];
    made.opacity = static_cast<float>(sum / 255 / double(level.texels.size()));
    return made;
}

std::optional<glm::vec4> GltfTextures::average(std::uint64_t image) {
    std::string why;
    std::optional<glm::vec4> made;
    const JsonValue entry = in_.at("images")[image];
    try {
        made = loading_.average(buffers_.image(image), why);
    } catch (const UserError& error) {
        if (!entry.find("uri") || leaves_folder(entry.at("uri").string())) throw;
        why = error.what();
    }
    if (!made)
        loading_.note(file_,
                      fmt::format("the texture images[{}] is not drawn: {}", image, printable(why, 300)));
    return made;
}

}   // namespace rayclock
