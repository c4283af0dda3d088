// Looks for a material, or for a few triangles, that make a scene large.
#include "sim/explore/fit/dominant.hpp"
#include "model/base/quote.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace rayclock::fit {

namespace {

struct Box {
    glm::dvec3 lo, hi;
    void add(const glm::dvec3& p) { lo = glm::min(lo, p), hi = glm::max(hi, p); }
    double extent() const { return std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z}); }
};

/// Returns the extent of the kept triangles and the eye.
double extent(const Scene& scene, const std::function<bool(std::size_t)>& kept) {
    Box box{scene.camera->eye, scene.camera->eye};
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        if (kept(i))
            for (const std::uint32_t v : scene.triangles[i].vertex) box.add(scene.vertices[v]);
    return box.extent();
}

double extent_of(const Scene& scene, std::size_t triangle) {
    const auto& v = scene.triangles[triangle].vertex;
    Box box{scene.vertices[v[0]], scene.vertices[v[0]]};
    box.add(scene.vertices[v[1]]);
    box.add(scene.vertices[v[2]]);
    return box.extent();
}

std::optional<Dominant> leave_out(const Scene& scene, std::string what,
                                  const std::function<bool(std::size_t)>& kept) {
    Dominant part{std::move(what), scene, 0, 1};
    part.without.triangles.clear(), part.without.coordinates.clear();
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        if (kept(i)) {
            part.without.triangles.push_back(scene.triangles[i]);
            if (!scene.coordinates.empty()) part.without.coordinates.push_back(scene.coordinates[i]);
        }
    part.triangles = scene.triangles.size() - part.without.triangles.size();
    if (part.without.triangles.empty() || part.triangles == 0) return {};
    const double all = extent(scene, [](std::size_t) { return true; }), rest = extent(scene, kept);
    part.ratio = rest > 0 ? all / rest : all;
    if (part.ratio < 2) return {};
    return part;
}

std::optional<Dominant> material(const Scene& scene) {
    std::vector<Box> boxes(scene.materials.size(), Box{scene.camera->eye, scene.camera->eye});
    for (const Triangle& t : scene.triangles)
        for (const std::uint32_t v : t.vertex) boxes[t.material].add(scene.vertices[v]);
    const auto largest = std::max_element(boxes.begin(), boxes.end(),
                                          [](const Box& a, const Box& b) { return a.extent() < b.extent(); });
    const auto m = std::uint32_t(largest - boxes.begin());
    const std::string& name = scene.materials[m].name;
    auto part = leave_out(scene, name.empty() ? fmt::format("material {}", m) : "material " + shown(name),
                          [&](std::size_t i) { return scene.triangles[i].material != m; });
    if (part) part->what += fmt::format(" ({} triangle{})", part->triangles, part->triangles == 1 ? "" : "s");
    return part;
}

/// Returns the triangles above the widest gap between neighbouring extents, within the larger half.
std::optional<Dominant> triangles(const Scene& scene) {
    std::vector<std::size_t> order(scene.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<double> size(order.size());
    for (const std::size_t i : order) size[i] = extent_of(scene, i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
    double widest = 0, limit = 0;
    for (std::size_t i = 0; i + 1 < order.size() && i <= order.size() / 2; ++i) {
        const double above = size[order[i]], beneath = size[order[i + 1]];
        if (above <= widest * beneath) continue;
        widest = above / beneath;
        limit = beneath;
    }
    auto part = leave_out(scene, fmt::format("triangle {}", order[0]),
                          [&](std::size_t i) { return size[i] <= limit; });
    if (part && part->triangles > 1)
        part->what = fmt::format("the {} largest triangles ({} first)", part->triangles, order[0]);
    return part;
}

}   // namespace

std::optional<Dominant> dominant_part(const Scene& scene) {
    if (scene.triangles.empty()) return {};   // spheres, planes or instances alone
    if (std::optional<Dominant> part = material(scene)) return part;
    return triangles(scene);
}

}   // namespace rayclock::fit
