// Draws a family as SVG.
#include "sim/explore/stress/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "sim/judge/oracle/surface.hpp"

namespace rayclock::stress {

namespace {

constexpr int panel = 240, coord_bits = 16, dir_bits = 24, rays_shown = 7;

glm::dvec3 place(const Vec3i& p) { return {p[0], p[1], p[2]}; }

/// A parallel projection: the direction to the viewer, and the position of a point in the picture.
struct View {
    glm::dvec3 towards = glm::normalize(glm::dvec3{0.35, -0.8, 0.5});
    glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3{0, 0, 1}, towards)),
               up = glm::cross(towards, right);
    glm::dvec2 centre{0};
    double half = 1;   ///< lattice steps from the panel's middle to its border
    int left = 0;      ///< left edge of the panel

    glm::dvec2 flat(const glm::dvec3& p) const { return {glm::dot(p, right), glm::dot(p, up)}; }
    glm::dvec2 operator()(const glm::dvec3& p) const {
        const glm::dvec2 q = (flat(p) - centre) * (panel / 2.0 / half);
        return {left + panel / 2.0 + q.x, panel / 2.0 - q.y};
    }
};

/// Clips a segment to the panel; returns false if nothing is left (Liang and Barsky 1984).
bool clip(const View& view, glm::dvec2& a, glm::dvec2& b) {
    double from = 0, to = 1;
    const glm::dvec2 d = b - a;
    const double lo[2] = {double(view.left), 0}, hi[2] = {double(view.left + panel), panel};
    for (int k = 0; k < 2; ++k) {
        if (d[k] == 0) {
            if (a[k] < lo[k] || a[k] > hi[k]) return false;
            continue;
        }
        const double s = (lo[k] - a[k]) / d[k], t = (hi[k] - a[k]) / d[k];
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
    }
    if (from > to) return false;
    b = a + to * d;
    a = a + from * d;
    return true;
}

std::string segment(const View& view, const glm::dvec3& p, const glm::dvec3& q) {
    glm::dvec2 a = view(p), b = view(q);
    if (!clip(view, a, b)) return {};
    return fmt::format("M{:.0f} {:.0f}L{:.0f} {:.0f}", a.x, a.y, b.x, b.y);
}

/// Returns the edges of triangles, each once. For a closed surface only those that face the viewer.
std::string edges(const View& view, const Mesh& mesh, bool closed) {
    std::set<std::pair<Vec3i, Vec3i>> seen;
    std::set<std::string> drawn;   // many edges coincide in a small picture
    for (const oracle::Corners& t : mesh.triangles) {
        const glm::dvec3 normal = glm::cross(place(t.b) - place(t.a), place(t.c) - place(t.a));
        if (closed && glm::dot(normal, view.towards) < 0) continue;
        for (const auto& [p, q] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)})
            if (seen.insert(std::minmax(p, q)).second) drawn.insert(segment(view, place(p), place(q)));
    }
    std::string path;
    for (const std::string& s : drawn) path += s;
    return fmt::format("<path d=\"{}\" stroke=\"#888\" stroke-width=\"0.7\" fill=\"none\"/>\n", path);
}

struct Ray {
    Shot shot;
    std::vector<oracle::ExactHit> hits;   ///< nearest first
    glm::dvec3 at(const oracle::ExactHit& hit) const {
        return place(shot.o) + place(shot.d) * (double(hit.num) / double(hit.den));
    }
};

std::vector<Ray> some_rays(const Case& subject, const oracle::Surface& surface, Rng& rng) {
    std::vector<Ray> rays;
    std::vector<std::uint32_t> found;
    for (int tries = 0; tries < 400 && rays.size() < rays_shown; ++tries) {
        Ray ray{subject.shoot(rng), {}};
        surface.candidates(ray.shot.o, ray.shot.d, found);
        for (const std::uint32_t i : found)
            if (const auto hit = oracle::exact_hit(ray.shot.o, ray.shot.d, subject.mesh.triangles[i], i);
                hit.primitive == i)
                ray.hits.push_back(hit);
        std::sort(ray.hits.begin(), ray.hits.end(), [](const auto& a, const auto& b) { return a.before(b); });
        if (!ray.hits.empty()) rays.push_back(std::move(ray));
    }
    return rays;
}

std::string draw(const View& view, const std::vector<Ray>& rays) {
    std::string out;
    const double beyond = 4 * view.half;
    for (const Ray& ray : rays) {
        const glm::dvec3 along = glm::normalize(place(ray.shot.d));
        out += fmt::format("<path d=\"{}\" stroke=\"#0072b2\" stroke-width=\"1.1\"/>\n",
                           segment(view, place(ray.shot.o), ray.at(ray.hits.back()) + beyond * along));
        for (const oracle::ExactHit& hit : ray.hits) {
            const glm::dvec2 p = view(ray.at(hit));
            if (p.x < view.left || p.x > view.left + panel || p.y < 0 || p.y > panel) continue;
            out += fmt::format(
                "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\" fill=\"{}\" stroke=\"#d55e00\"/>\n", p.x, p.y,
                hit.sense > 0 ? "#d55e00" : "white");
        }
    }
    return out;
}

/// The hit on the triangle with the shortest edge, and that edge. The difficulty of the family shows there.
struct HardestHit {
    glm::dvec3 at{0};
    double edge = 0;
};
HardestHit hit_with_shortest_edge(const Mesh& mesh, const std::vector<Ray>& rays) {
    HardestHit best;
    for (const Ray& ray : rays)
        for (const oracle::ExactHit& hit : ray.hits) {
            const oracle::Corners& t = mesh.triangles[hit.primitive];
            for (const auto& [p, q] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)})
                if (const double edge = glm::distance(place(p), place(q)); best.edge == 0 || edge < best.edge)
                    best = {ray.at(hit), edge};
        }
    return best;
}

}   // namespace

std::string sketch(const Family& family) {
    Rng rng(11);
    const Case subject = family.make(coord_bits, dir_bits, rng);
    const oracle::Surface surface(subject.mesh.triangles);
    const std::vector<Ray> rays = some_rays(subject, surface, rng);
    View whole;
    whole.centre = whole.flat(0.5 * (place(subject.mesh.lo) + place(subject.mesh.hi)));
    whole.half = 0.62 * glm::distance(place(subject.mesh.lo), place(subject.mesh.hi));
    View near = whole;
    near.left = panel + 10;
    const HardestHit hard = hit_with_shortest_edge(subject.mesh, rays);
    near.centre = near.flat(hard.at);
    near.half = std::max(2.5 * hard.edge, 3.0);
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        2 * panel + 10, panel);
    for (const View* view : {&whole, &near})
        out += edges(*view, subject.mesh, family.closed) + draw(*view, rays) +
               fmt::format(
                   "<rect x=\"{}.5\" y=\"0.5\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#bbb\"/>\n",
                   view->left, panel - 1, panel - 1);
    return out + "</svg>\n";
}

}   // namespace rayclock::stress
