#pragma once
// Seams: what two levels show because the rays of two instances are not the same line.
//
// Every instance sees the ray rounded for itself. So each has a line of its own, and the scene's ray is one
// more. If all instances saw the line of one of them, the picture would be that of one ray, rounded once.
// An answer is a *seam* if no single line gives it, of all lines that are concerned: the scene's ray, that of
// the instance that was hit, that of the instance that the ray leaves, and those of the instances that these
// lines meet first. Then the answer comes from lines that differ, and these are shown to differ by no more
// than they may: at the place where one line meets an instance that its own ray does not meet, both lie
// within bound() of that instance's steps. If they are farther apart, the result is
// `RayFinding::none`.
//
// Lines and what they meet are worked out in doubles, in each instance's space, on the corners of its
// lattice; but what a line meets in its own instance is decided exactly. Where the map is the identity, as of
// the scene's own spheres and planes, the instance's line is the scene's ray.
#include <vector>

#include <glm/mat3x3.hpp>

#include "sim/judge/reference/reference.hpp"
#include "sim/judge/paths/placed.hpp"

namespace rayclock {

/// What is found of an answer.
enum class RayFinding {
    one_line,   ///< a single line gives it
    seam,       ///< none does, and the lines concerned differ within the bound
    none        ///< neither
};

constexpr const char* no_finding =
    "no line of an instance gives the answer, and they are too far apart for a seam";

class Seams {
public:
    Seams(const PlacedWorld& world, const Config& config);

    /// Of an answer that judge_answer() finds right. `apart`, if given, is raised to how far the lines of a
    /// seam are apart, as a part of the bound.
    RayFinding look(const Ray& ray, const Closest& answer, double* apart = nullptr) const;

private:
    struct Line {
        std::uint32_t place = oracle::PlacedRay::nowhere;   ///< whose it is; nowhere: the scene's ray
        glm::dvec3 o{0}, d{0};                              ///< in steps of the scene's lattice
    };
    struct Met {
        std::uint32_t place = oracle::PlacedRay::nowhere;
        double t = 0;
    };
    struct Question;
    Line line_of(std::uint32_t place, const oracle::PlacedRay& ray) const;
    /// What the line meets first, within 0 < t < end.
    Met first_on(const Line& line, const Question& question) const;
    Met met_by_line(const Line& line, std::uint32_t place, bool is_finite) const;
    bool is_line_of(const Line& line, std::uint32_t place) const;
    Met met_exactly(std::uint32_t place, const Question& question) const;
    bool is_within_bound(const Line& line, const Met& met, const Question& question, double& apart) const;

    const PlacedWorld& world_;
    const Config& config_;
    /// Of an instance: to the mesh's steps, and back.
    struct Map {
        glm::dmat3 a{1}, back{1};
        glm::dvec3 b{0};
    };
    std::vector<Map> maps_;
    PlacedScene snapped_;             // whose meshes have steps for units
    std::vector<Reference> meshes_;   // of these
    std::optional<Reference> ends_;   // of spheres without planes
};

}   // namespace rayclock
