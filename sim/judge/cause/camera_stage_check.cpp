// Checks the machine's camera ray, its hit and its colour with the reference tracer.
#include "sim/judge/cause/camera_stage_check.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "sim/judge/cause/tie.hpp"
#include "sim/judge/paths/arithmetic.hpp"
#include "sim/judge/reference/whitted.hpp"

namespace rayclock {

namespace {

constexpr double float_step = 0x1p-23;   // of a hit's u, v and depth, above their rounding

/// Gives the tracer a hit, and omits shadows and bounces.
class LocalLight final : public RefSteer {
public:
    LocalLight(const RefPath& path, const RefClosest& hit) : path_(path), hit_(hit) {}
    bool faces_away = false, is_open = false;

    void begin_sample(std::uint32_t, RefPath& path) override { path = path_; }
    bool ends_sampling(std::uint32_t, double, bool own) override { return own; }
    RefClosest choose_hit(const RefPath&, const RefClosest&) override { return hit_; }
    void round_corners(RefClosest&, std::array<glm::dvec3, 3>&, bool open) override { is_open = open; }
    glm::dvec3 plane_colour(const RefClosest&, const Material&, const glm::dvec3& own) override {
        return own;
    }
    void texel(const RefClosest&, const RefSurface&, RefTexel&) override {}
    void move_ray_origin(RefSurface& surface) override {
        faces_away = glm::dot(surface.normal, path_.direction) > 0;
    }
    bool light_counts(std::size_t, double, double lambert) override { return lambert > 0; }
    bool is_blocked(std::size_t, const RefPath&, double, bool) override { return false; }
    bool is_total(const RefSurface&, double, double, bool own) override { return own; }
    bool accept_bounce(RefBounce&) override { return false; }
    void enter(RefBounce::Interaction) override {}
    void leave() override {}

private:
    RefPath path_;
    RefClosest hit_;
};

std::string name_of(bool found, std::uint32_t primitive) {
    return found ? "primitive " + std::to_string(primitive) : "nothing";
}

/// Returns a scene as large as the lattice, which contains the scene and the eye.
Scene corners_of(const Lattice& lattice) {
    const glm::dvec3 reach = std::exp2(lattice.coord_bits - 1) * lattice.pitch;
    Scene scene;
    scene.vertices = {lattice.centre - reach, lattice.centre + reach};
    scene.triangles = {{{0, 1, 1}, 0}};
    return scene;
}

std::optional<InstancedTriangles> triangles_of(const Scene& scene) {
    return is_folded(scene) ? std::make_optional<InstancedTriangles>(*scene.placed) : std::nullopt;
}

}   // namespace

CameraStageCheck::CameraStageCheck(const FrameInputs& inputs, const Scene& steps, const Reference& tracer,
                                   const PlacedWorld* placed, const SeamFinder* seams)
    : inputs_(inputs),
      steps_(steps),
      tracer_(tracer),
      placed_(placed),
      seams_(seams),
      rays_(pixel_rays(inputs.camera, {int(inputs.frame.width), int(inputs.frame.height)})),
      bound_(inputs, rays_),
      light_space_(corners_of(inputs.lattice)),
      scale_(inputs.frame, inputs.lattice, inputs.config),
      given_triangles_(triangles_of(inputs.scene)),
      steps_triangles_(triangles_of(steps)) {}

PlacedTriangle CameraStageCheck::triangle(const Scene& scene,
                                          const std::optional<InstancedTriangles>& instanced,
                                          std::uint32_t i) const {
    if (instanced) return (*instanced)(i);
    PlacedTriangle out;
    out.is_smooth = !scene.normals.empty();
    out.material = scene.triangles[i].material;
    if (!scene.coordinates.empty()) out.coordinates = scene.coordinates[i];
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = scene.triangles[i].vertex[k];
        out.vertices[k] = scene.vertices[vertex];
        if (out.is_smooth) out.normals[k] = scene.normals[vertex];
    }
    return out;
}

CameraFinding CameraStageCheck::judge(int x, int y, const Vec3i& d, const Closest& answer) const {
    if (!bound_.goes_through(rays_.direction(x, y), d))
        return {"the camera ray does not go through its pixel"};
    const glm::dvec3 from = vector_of(inputs_.frame.eye);
    const Hit own = tracer_.trace(from, vector_of(d));
    const std::uint32_t met = answer.found ? answer.prim : no_primitive;
    CameraFinding finding;
    if (own.primitive != met) {
        finding.is_tie = is_tie(from, vector_of(d), answer, own);
        Ray ray;
        ray.o = inputs_.frame.eye, ray.d = d;
        if (!finding.is_tie && !(seams_ && seams_->explain(ray, answer) != RayFinding::none)) {
            finding.fault = "the camera ray meets " + name_of(answer.found, answer.prim) +
                            ", and by the reference's rules " +
                            name_of(own.primitive != no_primitive, own.primitive);
            return finding;
        }
    }
    if (answer.found && !holds_point(x, y, d, answer))
        finding.fault = "the distance or the weights of a camera ray's hit are not those of its point";
    return finding;
}

bool CameraStageCheck::is_tie(const glm::dvec3& from, const glm::dvec3& d, const Closest& answer,
                              const Hit& own) const {
    const std::uint32_t met = answer.found ? answer.prim : no_primitive;
    if (is_folded(steps_)) {   // its tracer returns hits as floats, and cannot trace one primitive alone
        RefPath path;
        path.from = from, path.direction = glm::normalize(d);
        if (any_moved(path, [&](const RefPath& moved) {
                return tracer_.trace(from, moved.direction).primitive == met;
            }))
            return true;
        if (!answer.found || own.primitive == no_primitive) return false;
        const double depth = std::ldexp(double(answer.t),
                                        1 - inputs_.config.dir_bits - inputs_.config.t_frac_bits),
                     tick = std::ldexp(1.0, 1 - inputs_.config.dir_bits - inputs_.config.t_frac_bits);
        return std::abs(depth * glm::length(d) - double(own.depth)) <=
               tick * glm::length(d) + float_step * double(own.depth);
    }
    const RefGeometry& geometry = tracer_.geometry();
    RefPath path;
    if (!geometry.find_path(from, d, path)) return false;
    const auto closest = [&](const RefPath& moved) { return geometry.closest(moved).primitive == met; };
    if (any_moved(path, closest)) return true;
    if (met == no_primitive) return false;
    const RefClosest first = geometry.closest(path);
    const auto as_deep = [&](const RefPath& moved) {
        const RefClosest hit = geometry.only(moved, met);
        return hit.primitive == met && std::abs(hit.depth - first.depth) <= 4 * tie_size * (1 + first.depth);
    };
    return as_deep(path) || any_moved(path, as_deep);
}

/// Returns the largest distance at t between an instance's ray and the scene's ray, in steps of the scene:
/// rho (docs/machine/motion.md, Boxes) on each axis of the mesh, mapped back to the scene.
double CameraStageCheck::instance_error(std::uint32_t place, double t) const {
    if (!placed_ || placed_->is_same(place)) return 0;
    glm::dmat3 map(1);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            map[k][i] = std::ldexp(double(placed_->solids().places()[place].a[std::size_t(3 * i + k)]),
                                   -inputs_.config.map_frac());
    const glm::dmat3 back = glm::inverse(map);
    double square = 0;
    for (int i = 0; i < 3; ++i) square += glm::dot(back[i], back[i]);
    return std::sqrt(3 * square) * (0.5 + 0.5 * t);
}

/// The machine rounds u and v down by less than a unit, and t up by less than a tick. A Hit then rounds them
/// to floats.
bool CameraStageCheck::holds_point(int x, int y, const Vec3i& d, const Closest& answer) const {
    const std::uint32_t place = placed_ ? placed_->place_of(answer.prim) : oracle::PlacedRay::nowhere;
    const PlacedTriangle t = triangle(steps_, steps_triangles_, answer.prim);
    Hit hit = scale_({std::uint32_t(x), std::uint32_t(y), answer});
    if (placed_ && placed_->is_mirrored(place))
        std::swap(hit.u, hit.v);   // the flat scene's order of corners
    const glm::dvec3 e1 = t.vertices[1] - t.vertices[0], e2 = t.vertices[2] - t.vertices[0],
                     direction = vector_of(d), way = glm::normalize(direction),
                     at = t.vertices[0] + double(hit.u) * e1 + double(hit.v) * e2 -
                          vector_of(inputs_.frame.eye);
    const double along = glm::dot(at, way),
                 tick = std::exp2(1 - inputs_.config.dir_bits - inputs_.config.t_frac_bits),
                 unit = std::exp2(-inputs_.config.bary_bits) + float_step,
                 off = unit * (glm::length(e1) + glm::length(e2)) +
                       instance_error(place, along / glm::length(direction)) + Range::slack * glm::length(at);
    if (glm::length(at - along * way) > off) return false;
    if (answer.t == (std::uint64_t(1) << inputs_.config.t_bits()) - 1) return true;   // the largest t
    const double scale = glm::length(way * inputs_.lattice.pitch);   // of lengths along the ray
    return std::abs(double(hit.depth) - along * scale) <=
           (tick * glm::length(direction) + off) * scale + float_step * double(hit.depth);
}

/// Uses a scene of that one triangle. LocalLight gives the hit to the tracer, which does not search for one.
std::optional<glm::dvec3> CameraStageCheck::local_light(const Hit& hit, int x, int y) const {
    if (hit.primitive == no_primitive) return inputs_.scene.background;
    const PlacedTriangle t = triangle(inputs_.scene, given_triangles_, hit.primitive);
    Scene scene;
    scene.materials = {inputs_.scene.materials[t.material]}, scene.lights = inputs_.scene.lights;
    scene.background = inputs_.scene.background;
    scene.vertices.assign(t.vertices.begin(), t.vertices.end());
    if (t.is_smooth) scene.normals.assign(t.normals.begin(), t.normals.end());
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.coordinates = {t.coordinates}, scene.textures = inputs_.scene.textures;
    const double u = hit.u, v = hit.v;
    const glm::dvec3 at = (1 - u - v) * t.vertices[0] + u * t.vertices[1] + v * t.vertices[2];
    RefPath path;
    if (!light_space_.find_path(inputs_.camera.eye, at - inputs_.camera.eye, path)) return std::nullopt;
    LocalLight steer(path, {hit.depth * light_space_.space().scale, u, v, 0});
    Whitted settings;
    settings.depth = 0;
    const FrameSize size{int(inputs_.frame.width), int(inputs_.frame.height)};
    const WhittedPixel pixel = ref_pixel(light_space_, scene, inputs_.camera, size, settings,
                                         std::uint32_t(x), std::uint32_t(y), &steer);
    return steer.faces_away || steer.is_open ? std::nullopt : std::make_optional(pixel.colour);
}

}   // namespace rayclock
