// The list of built-in scenes, and `name:size`. The geometry is in generate/, one file per scene.
#include "model/scene/builtin.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "model/core/error.hpp"
#include "model/core/nearest.hpp"
#include "model/scene/generate/generate.hpp"

namespace rayclock {
namespace {

/// A scene without spheres is the same in both forms.
template <std::uint64_t (*triangles)(int)> PrimitiveCounts all_triangles(int size, Primitives) { return {.triangles = triangles(size)}; }
template <Scene (*make)(int)> Scene one_form(int size, Primitives) { return make(size); }

PrimitiveCounts spheres_counts(int, Primitives) { return {.spheres = spheres_spheres, .planes = 1}; }
PrimitiveCounts plane_counts(int, Primitives) { return {.planes = 1}; }

constexpr std::array<Builtin, 13> all{{
    {"balls", 3, 5, "sphereflake: spheres of many sizes on a floor", balls_counts, make_balls},
    {"gears", 4, 25, "interlocked gears: hard-edged parts, half of them hidden", all_triangles<gears_triangles>, one_form<make_gears>},
    {"mount", 6, 11, "fractal mountain: an even terrain of any density", mount_counts, make_mount},
    {"rings", 5, 19, "chains of rings: long thin triangles, much empty space", rings_counts, make_rings},
    {"teapot", 12, 389, "teapot on a checkerboard: small detail in a large room", all_triangles<teapot_triangles>, one_form<make_teapot>},
    {"tetra", 6, 11, "Sierpinski's tetrahedron: most rays miss", all_triangles<tetra_triangles>, one_form<make_tetra>},
    {"tree", 8, 15, "forking tree on a wide field: extreme range of sizes", tree_counts, make_tree},
    {"icosphere", 4, 9, "closed round ball: the smallest test for cracks", all_triangles<icosphere_triangles>, one_form<make_icosphere>},
    {"cornell", 1, 1, "Cornell box: a handful of large triangles, no size", all_triangles<cornell_triangles>, one_form<make_cornell>},
    {"spheres", 1, 1, "glass, mirror and matt spheres on a checkered plane", spheres_counts, one_form<make_spheres>},
    {"plane", 1, 1, "checkered plane as far as the horizon: what samples miss", plane_counts, one_form<make_plane>},
    {"mirrors", 1, 1, "Cornell box whose side walls are mirrors: rays without end", all_triangles<cornell_triangles>, one_form<make_mirrors>},
    {"square", 1, 1, "white square on black, slightly turned: how edges look", all_triangles<square_triangles>, one_form<make_square>},
}};

std::string_view name_of(std::string_view spec) { return spec.substr(0, spec.find(':')); }

const Builtin* find(std::string_view name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Builtin& b) { return b.name == name; });
    return found == all.end() ? nullptr : &*found;
}

int size_of(const Builtin& builtin, std::string_view spec) {
    if (spec.size() == builtin.name.size()) return builtin.default_size;
    const std::string_view digits = spec.substr(builtin.name.size() + 1);
    int size = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), size);
    if (error != std::errc{} || end != digits.data() + digits.size() || size < 1 || size > builtin.max_size)
        throw UserError("the size of the built-in scene '" + std::string(builtin.name) + "' must be a whole number in 1.." +
                        std::to_string(builtin.max_size) + ", not '" + std::string(digits) + "'");
    return size;
}

} // namespace

std::span<const Builtin> builtins() { return all; }

bool is_builtin(std::string_view spec) { return find(name_of(spec)) != nullptr; }

Scene make_builtin(std::string_view spec, Primitives primitives) {
    const std::string_view name = name_of(spec);
    const Builtin* builtin = find(name);
    if (!builtin) {
        std::vector<std::string> names;
        for (const Builtin& b : all) names.emplace_back(b.name);
        throw UserError("no built-in scene is called '" + std::string(name) + "'" + did_you_mean(name, names) +
                        " (`rayclock scenes` lists them)");
    }
    const int size = size_of(*builtin, spec);
    Scene scene = builtin->make(size, primitives);
    scene.name = builtin->max_size == 1 ? std::string(name) : std::string(name) + ":" + std::to_string(size);
    return scene;
}

} // namespace rayclock
