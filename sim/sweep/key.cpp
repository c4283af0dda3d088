#include "sim/sweep/key.hpp"

#include <bit>

#include <fmt/format.h>

#include "model/hits.hpp"

namespace rayclock::sweep {

namespace {

void add(Digest& digest, double x) { digest.add(std::bit_cast<std::uint64_t>(x)); }
void add(Digest& digest, const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) add(digest, v[k]);
}
void add(Digest& digest, const Material& m) {
    add(digest, m.colour);
    for (const double x : {m.ambient, m.diffuse, m.highlight, m.shine, m.mirror, m.transmit, m.index})
        add(digest, x);
}
void add(Digest& digest, const Light& light) {
    add(digest, light.position);
    add(digest, light.colour);
}
void add(Digest& digest, const Triangle& t) {
    for (const std::uint32_t v : t.vertex) digest.add(v);
    digest.add(t.material);
}
template <class Item> void add_all(Digest& digest, const std::vector<Item>& items) {
    digest.add(items.size());
    for (const Item& item : items) add(digest, item);
}

}   // namespace

std::string scene_digest(const Scene& scene) {
    Digest digest;
    add_all(digest, scene.vertices);
    add_all(digest, scene.normals);
    add_all(digest, scene.triangles);
    add_all(digest, scene.materials);
    add_all(digest, scene.lights);
    digest.add(scene.camera.has_value());
    if (scene.camera) {
        for (const glm::dvec3& v : {scene.camera->eye, scene.camera->at, scene.camera->up}) add(digest, v);
        add(digest, scene.camera->fov_degrees);
    }
    add(digest, scene.background);
    return fmt::format("{:016x}", digest.value());
}

}   // namespace rayclock::sweep
