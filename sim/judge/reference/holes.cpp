// Finds what hides a light, with the alpha of textures in double precision.
#include "sim/judge/reference/holes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/scene/texture.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {
namespace {

/// Least and largest alpha near a point of a texture.
struct AlphaRange {
    double least = 2, most = -1;
};

/// Adds samples of a level's alpha within `error` of s and t. The samples are 256ths of a texel apart, as the
/// machine's places are, but at most 65 along each axis.
void add_alpha_near(const Texture& texture, int level, const glm::dvec2& st, const glm::dvec2& error,
                    AlphaRange& range) {
    const TexelLevel& picture = texture.pyramid->levels[std::size_t(level)];
    const glm::dvec2 grid = 512.0 * glm::dvec2(picture.width, picture.height) * error;
    const int columns = int(std::min(std::ceil(grid.x), 64.0)), rows = int(std::min(std::ceil(grid.y), 64.0));
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x) {
            const glm::dvec2 part(columns == 0 ? 0 : 2.0 * x / columns - 1,
                                  rows == 0 ? 0 : 2.0 * y / rows - 1);
            const double alpha = filtered_with_alpha(texture, st + part * error, level).a;
            range.least = std::min(range.least, alpha), range.most = std::max(range.most, alpha);
        }
}

/// Returns the error of s and t at a hit. It includes the machine's rounding of a place to 256ths of a texel.
glm::dvec2 error_at(const Scene& scene, const RefClosest& hit, const RefPath& path, int level,
                    const HoleSlack& slack) {
    if (slack.weight == 0 && slack.moved == 0) return glm::dvec2(0);
    const auto& [a, b, c] = scene.coordinates[hit.primitive];
    double weight = slack.weight;
    if (slack.moved > 0) {
        const auto& vertex = scene.triangles[hit.primitive].vertex;
        const auto corner = [&](std::size_t k) { return scene.vertices[vertex[k]]; };
        const glm::dvec3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), n = glm::cross(e1, e2);
        const double area = glm::length(n), cosine = std::abs(glm::dot(n, path.direction)) / area;
        weight += slack.moved * (glm::length(e1) + glm::length(e2)) / area / std::max(cosine, 0x1p-8);
    }
    const Material& material = scene.materials[scene.triangles[hit.primitive].material];
    const TexelLevel& picture = scene.textures[*material.texture].pyramid->levels[std::size_t(level)];
    return weight * (glm::abs(b - a) + glm::abs(c - a)) + 0x1p-18 +
           1.0 / (256.0 * glm::dvec2(picture.width, picture.height));
}

}   // namespace

Hidden hidden_at(const RefGeometry& geometry, const Scene& scene, const RefPath& path, double distance,
                 double spread, const HoleSlack& slack) {
    if (!geometry.is_blocked(path, distance)) return {};
    if (scene.coordinates.empty()) return {true, true};
    const auto is_opaque = [&](const RefClosest& hit) {
        if (hit.primitive >= scene.triangles.size()) return true;
        const Material& material = scene.materials[scene.triangles[hit.primitive].material];
        return !material.texture || material.cutoff <= 0;
    };
    std::size_t count = 0;   // beyond max_holes, the light is hidden in any case
    const std::vector<RefClosest> hits = geometry.hits_before(
        path, distance, [&](const RefClosest& hit) { return is_opaque(hit) || ++count > max_holes; });
    if (hits.size() > max_holes || std::ranges::any_of(hits, is_opaque)) return {true, true};
    Hidden found;
    for (const RefClosest& hit : hits) {
        const Material& material = scene.materials[scene.triangles[hit.primitive].material];
        const auto& [a, b, c] = scene.coordinates[hit.primitive];
        const Texture& texture = scene.textures[*material.texture];
        const double lod = level_of_detail(texture_detail(scene, hit.primitive),
                                           path.travelled / geometry.space().scale, spread, 1);
        AlphaRange alpha;
        for (int level = level_of(texture, lod - slack.level); level <= level_of(texture, lod + slack.level);
             ++level)
            add_alpha_near(texture, level, (1 - hit.u - hit.v) * a + hit.u * b + hit.v * c,
                           error_at(scene, hit, path, level, slack), alpha);
        found.surely |= alpha.least >= material.cutoff + slack.alpha;
        found.possibly |= alpha.most >= material.cutoff - slack.alpha;
    }
    return found;
}

}   // namespace rayclock
