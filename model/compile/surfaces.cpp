// Surfaces, shading registers, and the configuration that a scene needs.
#include "model/compile/surfaces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/compile/emit.hpp"
#include "model/compile/plane.hpp"
#include "model/compile/textures.hpp"
#include "model/core/settled.hpp"
#include "model/layout/words.hpp"
#include "model/unit/tri/edges.hpp"

namespace rayclock {

namespace {

std::uint32_t fixed(double value, int frac_bits, std::uint32_t most) {
    return std::uint32_t(std::clamp(std::round(std::ldexp(value, frac_bits)), 0.0, double(most)));
}
std::uint32_t share_of(double value) { return fixed(value, share_bits, 1u << share_bits); }
/// Returns the weight of a reflected or refracted ray. A value above 0 stays above 0, so that its ray is
/// sent.
std::uint32_t weight_of(double value) {
    return std::max(fixed(value, unit_bits, 1u << unit_bits), std::uint32_t(value > 0));
}
std::array<std::uint32_t, 3> shares_of(const glm::dvec3& v) {
    return {share_of(v.x), share_of(v.y), share_of(v.z)};
}

std::uint32_t material_of(const Scene& scene, std::size_t i) {
    if (i < scene.triangles.size()) return scene.triangles[i].material;
    i -= scene.triangles.size();
    return i < scene.spheres.size() ? scene.spheres[i].material
                                    : scene.planes[i - scene.spheres.size()].material;
}

void set_material(const Material& m, Surface& s) {
    s.colour = shares_of(m.colour), s.other = shares_of(m.other);
    s.checkered = m.checkered, s.schlick = m.schlick;
    s.ambient = share_of(m.ambient), s.diffuse = share_of(m.diffuse), s.highlight = share_of(m.highlight);
    s.mirror = weight_of(m.mirror), s.transmit = weight_of(m.transmit);
    // Rounded together, so that the error of their sum, the weight after a total reflection, is at most that
    // of each.
    if (m.mirror > 0 && m.transmit > 0 && m.mirror + m.transmit <= 1)
        s.transmit = std::max(weight_of(m.mirror + m.transmit) - s.mirror, 1u);
    s.shine = fixed(m.shine, shine_frac, (1u << shine_bits) - 1);
    const double index = m.index > 0 ? m.index : 1, r = (index - 1) / (index + 1);
    s.r0 = weight_of(r * r);
    s.enter = fixed(1 / index, index_frac, (1u << ratio_bits) - 1);
    s.leave = fixed(index, index_frac, (1u << ratio_bits) - 1);
}

/// Sets corner normals, turned to the side of (b - a) x (c - a) in the scene. The longest of the three fills
/// its bits.
void set_normals(const Scene& scene, std::size_t i, Surface& s) {
    if (scene.normals.empty()) return;
    const auto& vertex = scene.triangles[i].vertex;
    const glm::dvec3 a = scene.vertices[vertex[0]];
    const glm::dvec3 flat = glm::cross(scene.vertices[vertex[1]] - a, scene.vertices[vertex[2]] - a);
    glm::dvec3 sum{0};
    double longest = 0;
    for (const std::uint32_t v : vertex)
        sum += scene.normals[v], longest = std::max(longest, glm::length(scene.normals[v]));
    const double turn = (glm::dot(sum, flat) < 0 ? -1 : 1) / (longest > 0 ? longest : 1),
                 most = (1 << (corner_bits - 1)) - 1;
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (int k = 0; k < 3; ++k)
            s.normal[3 * corner + std::size_t(k)] = std::int32_t(
                std::round(std::clamp(turn * scene.normals[vertex[corner]][k], -1.0, 1.0) * most));
    s.smooth = 1;
}

/// Returns the number of low zero bits common to all components of a triangle's edges, at most max_fine.
std::uint32_t fine_of(const PrimData& t, const Config& config) {
    std::uint32_t bits = 1u << std::clamp(config.bary_bits - config.origin_bits, 0, max_fine);
    for (std::size_t k = 0; k < 3; ++k)
        bits |= std::uint32_t(t.b[k] - t.a[k]) | std::uint32_t(t.c[k] - t.a[k]);
    return std::uint32_t(std::countr_zero(bits));
}

/// Returns for each vertex the number of low bits to clear: 2^bits is at most 2^-13 of the shortest edge of
/// all triangles of the vertex.
std::vector<std::uint8_t> coarseness(const Scene& scene, const Lattice& lattice) {
    std::vector<std::uint8_t> coarse(scene.vertices.size(), max_fine);
    std::vector<bool> used(scene.vertices.size());
    for (const Triangle& t : scene.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t.vertex[i], to = t.vertex[(i + 1) % 3];
            const double steps = glm::length((scene.vertices[to] - scene.vertices[from]) / lattice.pitch);
            const auto bits = std::uint8_t(std::clamp(steps >= 1 ? std::ilogb(steps) - 13 : 0, 0, max_fine));
            for (const std::uint32_t v : t.vertex) coarse[v] = std::min(coarse[v], bits), used[v] = true;
        }
    for (std::size_t v = 0; v < coarse.size(); ++v)
        if (!used[v]) coarse[v] = 0;
    return coarse;
}

/// True if the lattice point lies inside a sphere that is not visible from inside, so that none of its light
/// comes out.
bool is_walled_in(const Scene& scene, const Lattice& lattice, const std::int32_t* at) {
    std::vector<PrimData> spheres;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        spheres.push_back(snap_primitive(scene, lattice, scene.triangles.size() + i));
    drop_coincident_spheres(spheres);
    for (const PrimData& sphere : spheres) {
        if (sphere.b[2] != 0) continue;   // its material transmits
        std::int64_t square = 0;
        for (std::size_t k = 0; k < 3; ++k)
            square += std::int64_t(at[k] - sphere.a[k]) * (at[k] - sphere.a[k]);
        if (square < std::int64_t(radius_squared(sphere, lattice.coord_bits))) return true;
    }
    return false;
}

bool coincide(const PlaneOnLattice& one, const PlaneOnLattice& other) {
    const Vec3l n = cross(minus(one.b, one.a), minus(one.c, one.a));
    return std::ranges::all_of(std::array{other.a, other.b, other.c},
                               [&](const Vec3i& p) { return dot<Int128>(n, minus(p, one.a)) == 0; });
}

/// Returns the bit of each plane in a cell. The first planes that transmit have one. Planes that coincide
/// with one of them share its bit, because no ray meets them.
std::vector<std::uint32_t> panes_of(const Scene& scene, const Config& config, const Lattice& lattice) {
    std::vector<std::uint32_t> bits;
    std::vector<PlaneOnLattice> panes;
    for (const Plane& plane : scene.planes) {
        const PlaneOnLattice on = plane_on_lattice(plane, lattice);
        auto pane = std::ranges::find_if(panes, [&](const PlaneOnLattice& p) { return coincide(p, on); });
        if (pane == panes.end() && scene.materials[plane.material].transmit > 0 &&
            int(panes.size()) < config.panes)
            pane = panes.insert(pane, on);
        bits.push_back(pane == panes.end() ? 0 : 1u << (pane - panes.begin()));
    }
    return bits;
}

/// The planes between the camera's eye and a lattice point, exactly. An eye in a plane sees both sides of it.
struct PlanesBetween {
    bool clear = true;        ///< only panes lie between, and no plane holds the eye
    std::uint32_t cell = 0;   ///< the panes between them
};
PlanesBetween between(const Scene& scene, const Config& config, const Lattice& lattice,
                      const std::int32_t* place) {
    PlanesBetween found;
    if (!scene.camera) return found;
    const Vec3i eye = lattice.snap(scene.camera->eye);
    const std::vector<std::uint32_t> panes = panes_of(scene, config, lattice);
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        const PlaneOnLattice on = plane_on_lattice(scene.planes[i], lattice);
        const Vec3l n = cross(minus(on.b, on.a), minus(on.c, on.a));
        const Int128 seen = dot<Int128>(n, minus(eye, on.a)),
                     lit = dot<Int128>(n, minus({place[0], place[1], place[2]}, on.a));
        const bool other = seen > 0 ? lit < 0 : lit > 0;
        if (other) found.cell |= panes[i];
        found.clear = found.clear && seen != 0 && !(other && panes[i] == 0);
    }
    return found;
}

}   // namespace

std::optional<Scene> align_large_triangles(const Scene& scene, const Lattice& lattice) {
    const std::vector<std::uint8_t> coarse = coarseness(scene, lattice);
    const auto first = std::find_if(coarse.begin(), coarse.end(), [](std::uint8_t bits) { return bits > 0; });
    if (first == coarse.end()) return std::nullopt;
    // The origin of the multiples.
    const Vec3i start = lattice.snap(scene.vertices[std::size_t(first - coarse.begin())]);
    const std::int32_t most = (1 << (lattice.coord_bits - 1)) - 1;
    Scene moved = scene;
    for (std::size_t v = 0; v < coarse.size(); ++v) {
        if (coarse[v] == 0) continue;
        const std::int32_t step = 1 << coarse[v];
        const Vec3i at = lattice.snap(scene.vertices[v]);
        for (std::size_t k = 0; k < 3; ++k) {
            std::int32_t away = std::int32_t(std::lround(double(at[k] - start[k]) / step)) * step;
            if (start[k] + away > most) away -= step;
            if (start[k] + away < -most) away += step;
            moved.vertices[v][int(k)] = lattice.centre[int(k)] + lattice.pitch[int(k)] * (start[k] + away);
        }
    }
    return moved;
}

PrimData snap_primitive(const Scene& scene, const Lattice& lattice, std::size_t i) {
    PrimData prim;
    prim.prim = std::uint32_t(i);
    if (i < scene.triangles.size()) {
        const auto corner = [&](std::size_t k) {
            return lattice.snap(scene.vertices[scene.triangles[i].vertex[k]]);
        };
        prim.a = corner(0), prim.b = corner(1), prim.c = corner(2);
        return prim;
    }
    const int n = lattice.coord_bits;
    if (i - scene.triangles.size() < scene.spheres.size()) {
        const Sphere& sphere = scene.spheres[i - scene.triangles.size()];
        prim.kind = PrimKind::sphere;
        prim.a = lattice.snap(sphere.centre);
        const double radius = sphere.radius / lattice.pitch.x;
        const auto square = std::uint64_t(std::min(std::round(radius * radius), std::ldexp(1.0, 2 * n) - 1));
        const auto field = [n](std::uint64_t bits) {
            return std::int32_t(std::int64_t(bits << (64 - n)) >> (64 - n));
        };
        prim.b = {field(square), field(square >> n), scene.materials[sphere.material].transmit > 0};
        return prim;
    }
    const Plane& plane = scene.planes[i - scene.triangles.size() - scene.spheres.size()];
    prim.kind = PrimKind::plane;
    const PlaneOnLattice on = plane_on_lattice(plane, lattice);
    prim.a = on.a, prim.b = on.b, prim.c = on.c;
    return prim;
}

void mark_cutouts(const std::vector<Triangle>& triangles, const std::vector<CornerCoordinates>& coordinates,
                  const std::vector<Material>& materials, const Config& config,
                  std::vector<PrimData>& prims) {
    if (!config.has_textures() || coordinates.empty()) return;
    for (PrimData& prim : prims) {
        if (prim.kind != PrimKind::triangle) continue;
        const Material& material = materials[triangles[prim.prim].material];
        if (material.texture && material.cutoff > 0) prim.kind = PrimKind::cutout;
    }
}

std::size_t drop_coincident_spheres(std::vector<PrimData>& prims) {
    std::set<std::array<std::int32_t, 5>> seen;
    return std::erase_if(prims, [&](const PrimData& p) {
        return p.kind == PrimKind::sphere && !seen.insert({p.a[0], p.a[1], p.a[2], p.b[0], p.b[1]}).second;
    });
}

Surface surface_of(const Scene& scene, const Lattice& lattice, const Config& config, std::size_t i) {
    const PrimData prim = snap_primitive(scene, lattice, i);
    Surface s;
    s.kind = prim.kind, s.a = prim.a, s.b = prim.b, s.c = prim.c;
    if (i < scene.triangles.size()) s.fine = fine_of(prim, config);
    if (config.smooth && i < scene.triangles.size()) set_normals(scene, i, s);
    set_material(scene.materials[material_of(scene, i)], s);
    const std::size_t planes = scene.triangles.size() + scene.spheres.size();
    if (i >= planes) {
        set_checkers(plane_on_lattice(scene.planes[i - planes], lattice), config, s);
        s.normal[4] = std::int32_t(panes_of(scene, config, lattice)[i - planes]);
    } else {
        s.checkered = 0;   // only planes have squares
    }
    return s;
}

void check_units(const Scene& scene, const Config& config, const std::string& name) {
    const auto refuse = [&](const std::string& what, const char* unit) {
        throw UserError(name + ": the scene has " + what + ", and the configuration's " + unit + " is 0");
    };
    if (!scene.spheres.empty() && !config.spheres) refuse("spheres", "spheres");
    if (!scene.planes.empty() && !config.planes) refuse("planes", "planes");
    if (!config.has_shade()) return;
    if (!scene.normals.empty() && !config.smooth) refuse("corner normals", "smooth");
    if (shows_textures(scene) && !config.textures) refuse("textures", "textures");
    for (const Material& m : scene.materials)
        if (m.transmit > 0 && !config.refraction) refuse("a material that transmits", "refraction");
}

void write_surfaces(const Scene& scene, const std::vector<std::uint32_t>& records, const Config& config,
                    const std::string& name, MemoryImage& image) {
    const std::size_t first = image.lines(), count = primitive_count(scene);
    check_lines(first + count, config, name);
    image.first_surface_line = std::uint32_t(first);
    image.first_plane = std::uint32_t(count - scene.planes.size());
    image.first_plane_surface_line = image.first_surface_line + image.first_plane;
    image.words.resize((first + count) * words_per_line, 0);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        Words scratch;
        Surface surface = surface_of(scene, image.lattice, config, i);
        if (i < records.size()) surface.record = records[i];
        write_payload(surface, config, &image.words[(first + i) * words_per_line], scratch);
    });
    image.report.bytes = image.words.size() * sizeof(std::uint32_t);
}

Config fitted_config(const Scene& scene, const Whitted& settings, Config config) {
    config.shading = 1;
    config.spheres = !scene.spheres.empty();
    config.planes = !scene.planes.empty();
    config.smooth = !scene.normals.empty();
    config.textures = shows_textures(scene);
    config.refraction = std::any_of(scene.materials.begin(), scene.materials.end(),
                                    [](const Material& m) { return m.transmit > 0; });
    config.supersampling = settings.aa > 1 || settings.jitter;
    // tri then has 34 stages, and its credit gate must not close.
    if (config.spheres) config.tri_queue = std::max(config.tri_queue, 64);
    // Rounded up, so that scenes that differ by a light share their RTL.
    config.lights = std::clamp(int(std::bit_ceil(scene.lights.size())), 4, max_lights);
    config.bounces = std::max(config.bounces, settings.depth);
    int transmitting = 0, mirroring = 0;
    for (const Plane& plane : scene.planes) {
        transmitting += scene.materials.at(plane.material).transmit > 0;
        mirroring += scene.materials[plane.material].mirror > 0;
    }
    config.panes = std::min(max_panes, transmitting);
    config.horizon = scene.planes.size() > 1 && transmitting + mirroring > 0;
    return settled(config);
}

ShadeFrame make_shade_frame(const Scene& scene, const Whitted& settings, const MemoryImage& image,
                            std::uint32_t height, const Config& config) {
    const std::string name = scene.name.empty() ? "the scene" : scene.name;
    const auto refuse = [&](const std::string& what, int there, const char* key, int value) {
        throw UserError(name + ": " + what + ", and the configuration has " + std::to_string(there) +
                        ": --set " + key + "=" + std::to_string(value));
    };
    const int lights = int(scene.lights.size()), samples = settings.aa * settings.aa;
    if (lights > config.lights)
        refuse("it has " + std::to_string(lights) + " lights", config.lights, "lights", lights);
    if (config.refraction && settings.depth > config.bounces)
        refuse("depth " + std::to_string(settings.depth) + " was asked for", config.bounces, "bounces",
               settings.depth);
    if ((samples > 1 || settings.jitter) && !config.supersampling)
        refuse(std::to_string(samples) + " samples per pixel were requested", 1, "supersampling", 1);
    const double one = 1 << unit_bits;
    ShadeFrame frame;
    frame.first_surface_line = image.first_surface_line;
    frame.depth = std::uint32_t(settings.depth);
    frame.threshold = std::uint32_t(std::floor(std::clamp(settings.threshold, 0.0, 1.0) * 2 * one));
    frame.side = std::uint32_t(settings.aa);
    frame.stride = sample_stride(settings.aa);
    frame.jitter = settings.jitter;
    frame.contrast = std::uint32_t(std::ceil(std::clamp(settings.contrast, 0.0, 1.0) * one));
    frame.share = std::uint32_t(std::round(one / samples));
    frame.first_share = std::uint32_t(std::round(one / std::min(int(first_samples), samples)));
    frame.seed = settings.seed;
    frame.background = {fixed(scene.background.x, unit_bits, 1u << unit_bits),
                        fixed(scene.background.y, unit_bits, 1u << unit_bits),
                        fixed(scene.background.z, unit_bits, 1u << unit_bits)};
    if (config.has_textures()) frame.spread = spread_of(*scene.camera, height, settings.aa);
    frame.lights = std::uint32_t(lights);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const glm::dvec3 at = (scene.lights[i].position - image.lattice.centre) / image.lattice.pitch;
        const double within = double((1 << (config.coord_bits - 1)) - 1),
                     most = double((1 << (config.light_bits() - 1)) - 1);
        const double size = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}),
                     nearer = size > most ? most / size : 1;
        frame.near[i] = std::round(size) <= within;
        for (std::size_t k = 0; k < 3; ++k) {
            frame.place[3 * i + k] = std::int32_t(std::round(at[int(k)] * nearer));
            frame.colour[3 * i + k] =
                fixed(scene.lights[i].colour[int(k)], share_bits, (1u << strength_bits) - 1);
        }
        const PlanesBetween planes = between(scene, config, image.lattice, &frame.place[3 * i]);
        frame.cell[i] = planes.cell;
        frame.clear[i] =
            planes.clear && !(frame.near[i] && is_walled_in(scene, image.lattice, &frame.place[3 * i]));
    }
    return frame;
}

}   // namespace rayclock
