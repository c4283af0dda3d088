// The list of built-in scenes, and the parser of `name:size`. generate/ has the geometry, one file per scene.
#include "model/scene/builtin.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/scene/generate/generate.hpp"
#include "model/scene/generate/mesh_writer.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {
namespace {

/// For scenes without spheres, which are the same in both forms.
template <std::uint64_t (*triangles)(int)> PrimitiveCounts all_triangles(int size, Primitives) {
    return {.triangles = triangles(size)};
}
template <Scene (*make)(int)> Scene one_form(int size, Primitives) { return make(size); }
template <PlacedScene (*make)(int)> Scene one_flat_form(int size, Primitives) {
    return flattened(make(size));
}

PrimitiveCounts spheres_counts(int, Primitives) { return {.spheres = spheres_spheres, .planes = 1}; }
PrimitiveCounts wknd_counts(int, Primitives) { return {.spheres = wknd_spheres}; }
PrimitiveCounts plane_counts(int, Primitives) { return {.planes = 1}; }

/// With cones and cylinders cut as in Haines' package.
template <PrimitiveCounts (*counts)(int, Primitives, int)>
PrimitiveCounts usual_counts(int size, Primitives p) {
    return counts(size, p, cone_sectors);
}
template <Scene (*make)(int, Primitives, int)> Scene usual_form(int size, Primitives p) {
    return make(size, p, cone_sectors);
}

constexpr std::array<Builtin, 22> built_in_scenes{{
    {"balls", 3, 5, "sphereflake: spheres of many sizes on a floor", balls_counts, make_balls},
    {"gears", 4, 25, "interlocked gears: hard-edged parts, half of them hidden",
     all_triangles<gears_triangles>, one_form<make_gears>},
    {"mount", 6, 11, "fractal mountain: an even terrain of any density", mount_counts, make_mount},
    {"rings", 5, 19, "chains of rings: long thin triangles, much empty space", usual_counts<rings_counts>,
     usual_form<make_rings>},
    {"teapot", 12, 389, "teapot on a checkerboard: small detail in a large room",
     all_triangles<teapot_triangles>, one_form<make_teapot>},
    {"tetra", 6, 11, "Sierpinski's tetrahedron: most rays miss", all_triangles<tetra_triangles>,
     one_form<make_tetra>},
    {"tree", 8, 15, "forking tree on a wide field: extreme range of sizes", usual_counts<tree_counts>,
     usual_form<make_tree>},
    {"icosphere", 4, 9, "closed round ball: the smallest test for cracks", all_triangles<icosphere_triangles>,
     one_form<make_icosphere>},
    {"cornell", 1, 1, "Cornell box: a handful of large triangles, no size", all_triangles<cornell_triangles>,
     one_form<make_cornell>},
    {"spheres", 1, 1, "glass, mirror and matt spheres on a checkered plane", spheres_counts,
     one_form<make_spheres>},
    {"wknd", 1, 1, "cover of Ray Tracing in One Weekend: spheres from radius 0.2 to 1000", wknd_counts,
     one_form<make_wknd>},
    {"plane", 1, 1, "checkered plane as far as the horizon: what samples miss", plane_counts,
     one_form<make_plane>},
    {"mirrors", 1, 1, "Cornell box, closed, whose four walls are mirrors: rays without end",
     all_triangles<mirrors_triangles>, one_form<make_mirrors>},
    {"cube", 1, 1, "cube of 12 triangles, seen as in Vortex's test rt_raycast", all_triangles<cube_triangles>,
     one_form<make_cube>},
    {"square", 1, 1, "white square on black, slightly turned: how edges look",
     all_triangles<square_triangles>, one_form<make_square>},
    {"room", 1, 1, "room of pictures: textures in all modes, near, far and in a mirror",
     all_triangles<room_triangles>, one_form<make_room>},
    {"gearbox", 4, 25, "the gears again, placed: one gear and its instances", all_triangles<gears_triangles>,
     one_flat_form<make_gearbox>},
    {"flake", 3, 5, "the balls again, placed: one ball and its instances", all_triangles<flake_triangles>,
     one_flat_form<make_flake>},
    {"boughs", 8, 15, "the tree again, placed: one cone, one ball and their instances",
     all_triangles<boughs_triangles>, one_flat_form<make_boughs>},
    {"clockwork", 16, 132, "moving: a wall of gears that turn each other, once round in 4 s",
     all_triangles<clockwork_triangles>, one_flat_form<make_clockwork>},
    {"crowd", 10, 267, "moving: walkers of five parts each, two steps in 2 s, and the camera with them",
     all_triangles<crowd_triangles>, one_flat_form<make_crowd>},
    {"flight", 400, 31249, "moving: mirror balls thrown over a ground, and a light that goes round, 4 s",
     all_triangles<flight_triangles>, one_flat_form<make_flight>},
}};

/// Scenes made of instances.
struct Placed {
    std::string_view name;
    PlacedScene (*make)(int size);
};
constexpr std::array<Placed, 6> placed{{{"gearbox", make_gearbox},
                                        {"flake", make_flake},
                                        {"boughs", make_boughs},
                                        {"clockwork", make_clockwork},
                                        {"crowd", make_crowd},
                                        {"flight", make_flight}}};

std::string_view name_of(std::string_view spec) { return spec.substr(0, spec.find(':')); }

/// Returns the scene of a spec. Throws UserError with the nearest known name.
const Builtin& named(std::string_view spec) {
    return by_name(built_in_scenes, name_of(spec), "no built-in scene", " (`rayclock scenes` lists them)");
}

/// Scenes whose cones and cylinders may have another number of sides.
struct Cut {
    std::string_view name;
    PrimitiveCounts (*counts)(int size, Primitives primitives, int sides);
    Scene (*generate)(int size, Primitives primitives, int sides);
};
constexpr std::array<Cut, 2> cut{{{"rings", rings_counts, make_rings}, {"tree", tree_counts, make_tree}}};
constexpr int least_sides = 3, max_sides = 1000;
constexpr std::uint64_t max_triangles = 20'000'000;

/// Returns a whole number from `least` to `most`. Otherwise throws UserError; `what` begins the sentence.
int number_of(std::string_view digits, int least, int most, const std::string& what) {
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc{} || end != digits.data() + digits.size() || number < least || number > most)
        throw UserError(what + " must be a whole number in " + std::to_string(least) + ".." +
                        std::to_string(most) + ", not " + shown(digits));
    return number;
}

/// A parsed `name`, `name:size` or `name:size:sides`.
struct Spec {
    int size = 0, sides = cone_sectors;
    const Cut* cut = nullptr;   ///< set if the number of sides was given
};
Spec parsed(const Builtin& builtin, std::string_view spec) {
    const std::string scene = " of the built-in scene '" + std::string(builtin.name) + "'";
    if (spec.size() == builtin.name.size()) return {builtin.default_size};
    const std::string_view digits = spec.substr(builtin.name.size() + 1);
    const std::size_t colon = digits.find(':');
    const auto way =
        std::find_if(cut.begin(), cut.end(), [&](const Cut& c) { return c.name == builtin.name; });
    // For other scenes the rest is a typing mistake in the size.
    const bool has_sides = colon != digits.npos && way != cut.end();
    Spec out;
    out.size =
        number_of(has_sides ? digits.substr(0, colon) : digits, 1, builtin.max_size, "the size" + scene);
    if (!has_sides) return out;
    out.sides =
        number_of(digits.substr(colon + 1), least_sides, max_sides, "the number of sides of a cone" + scene);
    out.cut = &*way;
    return out;
}

}   // namespace

std::span<const Builtin> builtins() { return built_in_scenes; }

bool is_builtin(std::string_view spec) {
    return std::any_of(built_in_scenes.begin(), built_in_scenes.end(),
                       [&](const Builtin& b) { return b.name == name_of(spec); });
}

PrimitiveCounts builtin_counts(std::string_view text, Primitives primitives) {
    const Builtin& builtin = named(text);
    const Spec spec = parsed(builtin, text);
    if (!spec.cut) return builtin.counts(spec.size, primitives);
    const PrimitiveCounts counts = spec.cut->counts(spec.size, primitives, spec.sides);
    if (counts.triangles > max_triangles)
        throw UserError(shown(text) + ": that would be " + std::to_string(counts.triangles) +
                        " triangles, and " + std::to_string(max_triangles) + " are the limit");
    return counts;
}

PlacedScene make_placed(std::string_view text, Primitives primitives) {
    const Builtin& builtin = named(text);
    const Spec spec = parsed(builtin, text);
    builtin_counts(text, primitives);   // throws if there are too many
    const auto instanced =
        std::find_if(placed.begin(), placed.end(), [&](const Placed& p) { return p.name == builtin.name; });
    PlacedScene scene;
    if (instanced != placed.end())
        scene = instanced->make(spec.size);
    else
        scene.own = spec.cut ? spec.cut->generate(spec.size, primitives, spec.sides)
                             : builtin.make(spec.size, primitives);
    scene.own.name = builtin.name;
    if (builtin.max_size > 1) scene.own.name += ":" + std::to_string(spec.size);
    if (spec.cut) scene.own.name += ":" + std::to_string(spec.sides);
    return scene;
}

Scene make_builtin(std::string_view text, Primitives primitives) {
    return flattened(make_placed(text, primitives));
}

}   // namespace rayclock
