#pragma once
// Finds seams: differences that two levels cause because the rays of two instances are not the same line.
//
// The ray is rounded separately for each instance. So each instance has a separate line, and the scene's ray
// is one more line. If all instances saw the same line, the picture would show a single ray, rounded once. An
// answer is a *seam* if none of these lines gives it alone:
// - the scene's ray,
// - the line of the instance that was hit,
// - the line of the instance that the ray leaves,
// - the lines of the instances that these lines meet first.
// The answer then comes from different lines, and their distance is checked.
// Where a line meets an instance that the instance's own ray does not meet, the two must lie within bound()
// of that instance's steps. If they are farther apart, the result is `RayFinding::none`.
//
// Lines and their hits are computed in doubles, in each instance's space, on the corners of its lattice. Hits
// of a line in its own instance are decided exactly. Where the map is the identity, as for the scene's own
// spheres and planes, the instance's line is the scene's ray.
#include <vector>

#include <glm/mat3x3.hpp>

#include "sim/judge/paths/placed.hpp"
#include "sim/judge/reference/reference.hpp"

namespace rayclock {

/// The explanation of an answer.
enum class RayFinding {
    one_line,   ///< a single line gives the answer
    seam,       ///< no single line does, and the lines concerned differ within the bound
    none        ///< neither holds
};

constexpr const char* no_finding =
    "no line of an instance gives the answer, and they are too far apart for a seam";

class SeamFinder {
public:
    SeamFinder(const PlacedWorld& world, const Config& config);

    /// Explains an answer that judge_answer() accepts. If `apart` is given, it is raised to the distance
    /// between the lines of a seam, relative to the bound.
    RayFinding explain(const Ray& ray, const Closest& answer, double* apart = nullptr) const;

private:
    struct Line {
        std::uint32_t place = oracle::PlacedRay::nowhere;   ///< the line's instance; nowhere: the scene's ray
        glm::dvec3 o{0}, d{0};                              ///< in steps of the scene's lattice
    };
    struct LineHit {
        std::uint32_t place = oracle::PlacedRay::nowhere;
        double t = 0;
    };
    struct Question;
    Line line_of(std::uint32_t place, const oracle::PlacedRay& ray) const;
    /// Returns the first instance that the line meets, within 0 < t < end.
    LineHit first_on(const Line& line, const Question& question) const;
    LineHit met_by_line(const Line& line, std::uint32_t place, bool is_finite) const;
    bool is_line_of(const Line& line, std::uint32_t place) const;
    LineHit met_exactly(std::uint32_t place, const Question& question) const;
    bool is_within_bound(const Line& line, const LineHit& met, const Question& question, double& apart) const;

    const PlacedWorld& world_;
    const Config& config_;
    /// An instance's map to the mesh's steps, and its inverse.
    struct Map {
        glm::dmat3 a{1}, back{1};
        glm::dvec3 b{0};
    };
    std::vector<Map> maps_;
    PlacedScene snapped_;             // its meshes are in lattice steps
    std::vector<Reference> meshes_;   // of these meshes
    std::optional<Reference> ends_;   // the spheres without the planes
};

}   // namespace rayclock
