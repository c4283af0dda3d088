// Computes digests of scenes and films.
#include "sim/explore/sweep/key.hpp"

#include <bit>

#include <fmt/format.h>

#include "model/trace/hits.hpp"

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
    digest.add(m.checkered);
    add(digest, m.other);
    digest.add(m.schlick);
    if (m.texture) digest.add(*m.texture);
}
// Textures and coordinates contribute to a digest only if the scene has them.
void add(Digest& digest, const CornerCoordinates& corners) {
    for (const glm::dvec2& st : corners) add(digest, st.x), add(digest, st.y);
}
void add(Digest& digest, const Texture& texture) {
    digest.add(std::uint64_t(texture.wrap_s)), digest.add(std::uint64_t(texture.wrap_t));
    digest.add(texture.nearest), digest.add(texture.mipmaps);
    const TexelLevel& picture = texture.pyramid->levels.front();   // the others follow from it
    digest.add(std::uint64_t(picture.width)), digest.add(std::uint64_t(picture.height));
    for (const auto& [r, g, b, alpha] : picture.texels)
        digest.add(r | std::uint64_t(g) << 8 | std::uint64_t(b) << 16 | std::uint64_t(alpha) << 24);
}
void add(Digest& digest, const Light& light) {
    add(digest, light.position);
    add(digest, light.colour);
}
void add(Digest& digest, const Triangle& t) {
    for (const std::uint32_t v : t.vertex) digest.add(v);
    digest.add(t.material);
}
void add(Digest& digest, const Sphere& s) {
    add(digest, s.centre);
    add(digest, s.radius);
    digest.add(s.material);
}
void add(Digest& digest, const Plane& p) {
    for (const glm::dvec3& v : {p.point, p.u, p.v}) add(digest, v);
    digest.add(p.material);
}
void add(Digest& digest, const Camera& camera) {
    for (const glm::dvec3& v : {camera.eye, camera.at, camera.up}) add(digest, v);
    add(digest, camera.fov_degrees);
    digest.add(camera.window.has_value());
    if (const auto& w = camera.window)
        for (const int n : {w->x, w->y, w->whole_width, w->whole_height}) digest.add(std::uint32_t(n));
}
void add(Digest& digest, const SharedMesh& mesh);
void add(Digest& digest, const Instance& instance);
template <class Item> void add_all(Digest& digest, const std::vector<Item>& items) {
    digest.add(items.size());
    for (const Item& item : items) add(digest, item);
}
void add(Digest& digest, const SharedMesh& mesh) {
    add_all(digest, mesh.vertices);
    add_all(digest, mesh.normals);
    add_all(digest, mesh.triangles);
    if (!mesh.coordinates.empty()) add_all(digest, mesh.coordinates);
}
void add(Digest& digest, const Instance& instance) {
    digest.add(instance.mesh);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) add(digest, instance.place[column][row]);
    digest.add(instance.material.has_value());
    digest.add(instance.material.value_or(0));
}

void add_scene(Digest& digest, const Scene& scene) {
    add_all(digest, scene.vertices);
    add_all(digest, scene.normals);
    add_all(digest, scene.triangles);
    add_all(digest, scene.spheres);
    add_all(digest, scene.planes);
    add_all(digest, scene.materials);
    add_all(digest, scene.lights);
    digest.add(scene.camera.has_value());
    if (scene.camera) add(digest, *scene.camera);
    add(digest, scene.background);
    if (!scene.coordinates.empty()) add_all(digest, scene.coordinates);
    if (scene.textures.empty()) return;
    add_all(digest, scene.textures);
    for (const Plane& plane : scene.planes) add(digest, plane.coordinates);
}

std::string text_of(const Digest& digest) { return fmt::format("{:016x}", digest.value()); }

}   // namespace

std::string scene_digest(const Scene& scene) {
    Digest digest;
    add_scene(digest, scene);
    digest.add(scene.placed != nullptr);
    if (scene.placed) {
        add_scene(digest, scene.placed->own);
        add_all(digest, scene.placed->meshes);
        add_all(digest, scene.placed->instances);
    }
    return text_of(digest);
}

std::string film_digest(PlacedScene scene, const std::vector<double>& times) {
    Digest digest;
    for (const double time : times) {
        pose(scene, time);
        add_all(digest, scene.instances);
        for (const Deforming& deforming : scene.motion.deforming) add(digest, scene.meshes[deforming.mesh]);
        add_all(digest, scene.own.lights);
        if (scene.own.camera) add(digest, *scene.own.camera);
    }
    return text_of(digest);
}

}   // namespace rayclock::sweep
