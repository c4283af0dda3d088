// Generates the surfaces and rays of each family of hard cases.
#include "sim/explore/stress/families.hpp"

#include <cmath>
#include <memory>

#include "model/base/axes.hpp"
#include "model/base/nearest.hpp"
#include "sim/explore/stress/aim.hpp"

namespace rayclock::stress {

namespace {

/// Returns a case whose rays, shoot(mesh, rng), use its mesh. The case keeps the mesh alive.
template <class Shoot> Case with_rays(Mesh mesh, const Shoot& shoot) {
    const auto kept = std::make_shared<const Mesh>(std::move(mesh));
    return {*kept, [kept, shoot](Rng& rng) { return shoot(*kept, rng); }};
}
const oracle::Corners& any_triangle(const Mesh& mesh, Rng& rng) {
    return mesh.triangles[std::size_t(rng.below(int(mesh.triangles.size())))];
}
/// Shoots rays from outside at random triangles.
Case aimed(Mesh mesh, Target target, int n, int m) {
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const Vec3i o = outside(kept, n, from);
        const oracle::Corners& t = any_triangle(kept, from);
        return Shot{o, towards(o, t, weights(target, from), m, from), 0};
    });
}

/// Returns the lattice point at or near the point with these weights.
Vec3i point_of(const oracle::Corners& t, const Weights& w) {
    return by_axis(
        [&](std::size_t k) { return (w.a * t.a[k] + w.b * t.b[k] + w.c * t.c[k]) / (w.a + w.b + w.c); });
}

/// Moves an origin back along an axis to the end of the lattice.
void move_back(Shot& shot, int n) {
    for (std::size_t k = 0; k < 3; ++k)
        if (shot.d[k] != 0) shot.o[k] = shot.d[k] > 0 ? -most(n) : most(n);
}

Mesh ball(int level, int n, Rng& rng) {
    Mesh mesh;
    mesh.add(turned(sphere(level), rng), scale(n, 24, rng));
    return mesh;
}

Case random_rays(int n, int m, Rng& rng) {
    return aimed(ball(1 + rng.below(3), n, rng), Target::inside, n, m);
}
Case edges(int n, int m, Rng& rng) { return aimed(ball(1 + rng.below(3), n, rng), Target::edge, n, m); }
Case corners(int n, int m, Rng& rng) { return aimed(ball(1 + rng.below(3), n, rng), Target::corner, n, m); }

Case fan(int n, int m, Rng& rng) {
    Mesh mesh;
    mesh.add(turned(bipyramid(16 << rng.below(4), 1), rng), scale(n, 64, rng));
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const Vec3i o = outside(kept, n, from);
        const oracle::Corners& t = any_triangle(kept, from);   // the first corner is an apex
        return Shot{o, towards(o, t, from.below(2) ? Weights{1, 0, 0} : weights(Target::edge, from), m, from),
                    0};
    });
}

Case needles(int n, int m, Rng& rng) {
    Mesh mesh;
    const double size = scale(n, 64, rng);
    mesh.add(turned(bipyramid(16, (1 + rng.below(6)) / size), rng), size);
    return aimed(std::move(mesh), Target::any, n, m);
}

Case seams(int n, int m, Rng& rng, bool slivers) {
    Mesh mesh = ball(3, n, rng);
    cut_edges(mesh, 200, slivers, rng);
    // Half of the rays aim at the new corners, which are last in the list.
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const Vec3i o = outside(kept, n, from);
        const int all = int(kept.triangles.size());
        const oracle::Corners& t = kept.triangles[std::size_t(
            from.below(2) ? all - 1 - from.below(std::min(all, 200)) : from.below(all))];
        return Shot{o, towards(o, t, weights(from.below(2) ? Target::edge : Target::any, from), m, from), 0};
    });
}
Case slivers(int n, int m, Rng& rng) { return seams(n, m, rng, true); }
Case t_junctions(int n, int m, Rng& rng) { return seams(n, m, rng, false); }

/// Rays in a triangle's plane. They start at a lattice point of the plane outside the mesh, along a
/// combination of two edges.
Case edge_on(int n, int m, Rng& rng) {
    Mesh mesh;
    if (rng.below(2))
        mesh.add(cube(4), std::floor(scale(n, 24, rng) / 4) * 2);
    else
        mesh = ball(2, n, rng);
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const oracle::Corners& t = any_triangle(kept, from);
        const int p = from.below(9) - 4, q = from.below(9) - 4, r = from.below(5) - 2, s = from.below(5) - 2;
        const auto in_plane = [&](int along_ab, int along_ac) {
            return by_axis([&](std::size_t k) {
                return t.a[k] + along_ab * (t.b[k] - t.a[k]) + along_ac * (t.c[k] - t.a[k]);
            });
        };
        Shot shot{in_plane(p, q), {}, {}};
        // Clamping can leave the plane; such rays are hard cases too.
        for (auto& x : shot.o) x = std::clamp(x, -most(n), most(n));
        shot.d = towards(shot.o, in_plane(r, s), m, from);
        for (std::size_t k = 0; k < 3; ++k)
            if (shot.o[k] < kept.lo[k] || shot.o[k] > kept.hi[k]) shot.inside = 0;
        return shot;
    });
}

/// Rays from a corner, an edge or the inside of a triangle.
Case on_surface(int n, int m, Rng& rng) {
    Mesh mesh = ball(2, n, rng);
    if (rng.below(2)) {
        mesh = {};
        mesh.add(cube(4), std::floor(scale(n, 24, rng) / 4) * 2);
    }
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const oracle::Corners &t = any_triangle(kept, from), &other = any_triangle(kept, from);
        Shot shot{point_of(t, weights(Target::any, from)), {}, {}};
        shot.d = from.below(4) == 0
                     ? any_direction(m, from)
                     : towards(shot.o, from.below(3) ? other : t, weights(Target::any, from), m, from);
        return shot;
    });
}

/// The same surface twice, with corners in another order. Planes that meet at one distance.
Case ties(int n, int m, Rng& rng) {
    Mesh mesh = ball(2, n, rng);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = count; i-- > 0;) {
        const oracle::Corners& t = mesh.triangles[i];
        mesh.triangles.push_back(rng.below(2) ? oracle::Corners{t.b, t.c, t.a}
                                              : oracle::Corners{t.c, t.b, t.a});
    }
    return aimed(std::move(mesh), Target::any, n, m);
}

/// Several tessellations of one rectangle in the same plane.
Case coplanar(int n, int m, Rng& rng) {
    Mesh mesh;
    const double size = std::floor(scale(n, 48, rng) / 12) * 12;
    mesh.add(plate(3), size);
    mesh.add(plate(4, true), size);
    mesh.add(plate(2), size);
    return aimed(std::move(mesh), Target::any, n, m);
}

/// Rays along an axis through corners and edges.
Case axis_parallel(int n, int m, Rng& rng) {
    return with_rays(ball(1 + rng.below(3), n, rng), [=](const Mesh& kept, Rng& from) {
        const oracle::Corners& t = any_triangle(kept, from);
        const Weights w = weights(Target::any, from);
        Shot shot{point_of(t, w), axis_direction(m, from), 0};
        move_back(shot, n);
        return shot;
    });
}

/// A cube of whole squares, with rays along the axes through the grid's lines and corners.
Case grid(int n, int m, Rng& rng) {
    const int squares = 8, step = std::max(2, int(scale(n, 32, rng)) / squares * 2);
    Mesh mesh;
    mesh.add(cube(squares), step * squares / 2);
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        Shot shot{{}, axis_direction(m, from), 0};
        for (std::size_t k = 0; k < 3; ++k)
            shot.o[k] =
                kept.lo[k] + step * from.below(squares + 1) + (from.below(4) == 0 ? from.below(step) : 0);
        move_back(shot, n);
        return shot;
    });
}

/// Plates and boxes without thickness, with rays in the planes of box faces.
Case flat_boxes(int n, int m, Rng& rng) {
    Mesh mesh;
    const double size = std::floor(scale(n, 24, rng) / 16) * 8;
    for (int i = -2; i <= 2; ++i) mesh.add(plate(4), size, {0, 0, i * std::floor(size / 4)});
    mesh.add(cube(2), size / 2);
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const oracle::Corners &t = any_triangle(kept, from), &s = any_triangle(kept, from);
        Shot shot{outside(kept, n, from), {}, {}};
        const auto axis = std::size_t(from.below(3));
        shot.o[axis] = t.a[axis];
        shot.d = towards(shot.o, s, weights(Target::any, from), m, from);
        if (from.below(4)) shot.d[axis] = 0;
        if (shot.d == Vec3i{}) shot.d = axis_direction(m, from);
        return shot;
    });
}

/// A ball of 1e-3 to 1e-5 of the size of the cube around it, as far as the lattice has room.
Case stadium(int n, int m, Rng& rng) {
    Mesh mesh;
    mesh.add(cube(1), most(n));
    const double tiny = std::max(3.0, most(n) / (rng.below(2) ? 1e3 : rng.below(2) ? 1e4 : 1e5));
    const double place = most(n) / 2.0;
    mesh.add(turned(sphere(2), rng), tiny, {place, -place, place / 3});
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        constexpr int cube_triangles = 12;   // the ball's triangles follow
        Shot shot{{}, {}, 1};
        do
            for (auto& x : shot.o) x = from.below(2 * most(n) - 1) - most(n) + 1;
        while (std::abs(shot.o[0] - kept.triangles[cube_triangles].a[0]) < most(n) / 8);   // not in the ball
        const int of_ball = int(kept.triangles.size()) - cube_triangles;
        const oracle::Corners& t = kept.triangles[std::size_t(
            from.below(8) == 0 ? from.below(cube_triangles) : cube_triangles + from.below(of_ball))];
        shot.d = towards(shot.o, t, weights(Target::any, from), m, from);
        return shot;
    });
}

/// A surface in one corner of the lattice, seen from the opposite corner.
Case far_off(int n, int m, Rng& rng) {
    Mesh mesh;
    const double size = std::max(24.0, most(n) / 64.0), place = most(n) - size - 1;
    mesh.add(turned(sphere(1 + rng.below(3)), rng), size, {place, place, place});
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        Shot shot{{}, {}, 0};
        for (auto& x : shot.o) x = -most(n) + from.below(most(n) / 64 + 1);
        shot.d = towards(shot.o, any_triangle(kept, from), weights(Target::any, from), m, from);
        return shot;
    });
}

/// The largest possible coordinates and directions.
Case largest(int n, int m, Rng& rng) {
    Mesh mesh;
    mesh.add(rng.below(2) ? cube(1) : bipyramid(4, 1), most(n));
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const int limit = most(n), far = most(m);
        Shot shot;
        for (std::size_t k = 0; k < 3; ++k) {
            const int places[] = {-limit - 1, limit, -limit, 0, from.below(2 * limit) - limit},
                      ways[] = {far, -far - 1, -far, 0, far - 1};
            shot.o[k] = places[from.below(5)];
            shot.d[k] = ways[from.below(5)];
            if (shot.o[k] == -limit - 1) shot.inside = 0;
        }
        if (shot.d == Vec3i{} || from.below(2))
            shot.d = towards(shot.o, any_triangle(kept, from), weights(Target::any, from), m, from);
        return shot;
    });
}

/// Nested balls, one lattice step apart.
Case shells(int n, int m, Rng& rng) {
    Mesh mesh;
    const double size = scale(n, 24, rng);
    const Shape shape = turned(sphere(2), rng);
    for (int i = 0; i < 4; ++i) mesh.add(shape, size - i);
    return aimed(std::move(mesh), Target::any, n, m);
}

Case concave(int n, int m, Rng& rng) {
    Mesh mesh;
    mesh.add(turned(cog(7), rng), scale(n, 24, rng));
    return aimed(std::move(mesh), Target::any, n, m);
}

/// A row of shrinking bodies, which gives the deepest possible tree.
Case deep(int n, int m, Rng& rng) {
    Mesh mesh;
    double size = 0.25 * most(n), place = 0.7 * most(n);
    const Shape body = turned(bipyramid(4, 1), rng);
    while (size >= 4) {
        mesh.add(body, size, {place, place / 2, -place});
        place -= 1.5 * size;
        size /= 1.6;
    }
    return with_rays(std::move(mesh), [=](const Mesh& kept, Rng& from) {
        const oracle::Corners& t = any_triangle(kept, from);
        Shot shot{outside(kept, n, from), {}, 0};
        if (from.below(2))
            shot.o = {most(n), most(n) / 2 + from.below(most(n) / 8), -most(n)};   // along the row
        shot.d = towards(shot.o, t, weights(Target::any, from), m, from);
        return shot;
    });
}

/// The quad (-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0), and rays from (0, 0, 10) through its diagonal.
/// One of them has the direction (0.30458447, 0.30458447, -0.9024725), which float32 loses (three.js, pull
/// request 33661).
Case quad(int n, int m, Rng& rng) {
    Mesh mesh;
    const double unit = std::floor(scale(n, 60, rng) / 10);
    Shape body = cube(1);
    for (glm::dvec3& p : body.points) p = {5 * p.x, 5 * p.y, p.z > 0 ? 0 : -5};
    mesh.add(body, unit);
    return with_rays(std::move(mesh), [=](const Mesh&, Rng& from) {
        Shot shot{{0, 0, std::min(most(n), int(10 * unit))}, {}, 0};
        const int along = from.below(3) == 0 ? int(0.30458447 * most(m)) : from.below(most(m) / 2);
        const int sign = from.below(2) ? 1 : -1;
        shot.d = {sign * along, sign * along, from.below(2) ? -int(0.9024725 * most(m)) : -most(m)};
        return shot;
    });
}

}   // namespace

const std::vector<Family>& families() {
    static const std::vector<Family> all{
        {"random", "a closed ball of 80 to 1,280 triangles, rays at the insides of triangles", true, false,
         random_rays},
        {"edges", "the ball, rays through shared edges", true, false, edges},
        {"corners", "the ball, rays through shared corners", true, false, corners},
        {"fan", "two cones of 16 to 128 triangles each: corners of that valence, and edges that meet there",
         true, false, fan},
        {"needles", "a spindle one to six lattice steps thin: triangles that are lines or nearly lines", true,
         false, needles},
        {"slivers", "the ball with edges cut on one side and the seam closed by triangles without area", true,
         false, slivers},
        {"edge_on", "rays in the plane of a triangle, seen edge-on (det = 0)", true, false, edge_on},
        {"on_surface", "rays that start on a corner, an edge or a plane of the surface: t = 0 is not a hit",
         false, false, on_surface},
        {"ties", "every triangle twice, in another order: equal t goes to the lower number", false, false,
         ties},
        {"coplanar", "three tessellations of one rectangle in one plane", false, false, coplanar},
        {"axis", "rays along the axes, both ways, through corners and edges: two components of d are zero",
         true, false, axis_parallel},
        {"grid", "a cube of whole squares and a grid of rays along the axes", true, false, grid},
        {"flat_boxes", "boxes without thickness, and rays inside the planes of boxes' faces", false, false,
         flat_boxes},
        {"stadium", "a ball in a cube 1,000 to 100,000 times as large", true, false, stadium},
        {"far", "a small ball in one corner of the lattice, seen from the opposite one", true, false,
         far_off},
        {"largest", "bodies as large as the lattice; largest coordinates and directions", true, false,
         largest},
        {"shells", "four nested balls, one lattice step apart", true, false, shells},
        {"concave", "a cog: concave edges and corners", true, false, concave},
        {"deep", "ever smaller bodies in a row: as deep a tree as the lattice allows", true, false, deep},
        {"quad", "the diagonal of a square, where float32 Moeller-Trumbore is known to lose rays", true,
         false, quad},
        {"t_junction", "negative control: edges cut on one side, a lattice step off. Must leak", true, true,
         t_junctions},
    };
    return all;
}

const Family& family(const std::string& name) { return by_name(families(), name, "--family: no family"); }

}   // namespace rayclock::stress
