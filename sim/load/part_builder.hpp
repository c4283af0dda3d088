#pragma once
// Building the parts of a scene: vertices are joined exactly, and flat and smooth parts can share a scene.
// model/scene/placed.hpp places them.
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/scene/placed.hpp"

namespace rayclock {

/// The coordinates of a corner for which the file has none.
constexpr glm::dvec2 no_coordinates{std::numeric_limits<double>::quiet_NaN()};

/// One corner of a triangle as stored in a file. A normal of zero means that the file has none.
struct Corner {
    glm::dvec3 position{0};
    glm::dvec3 normal{0};
    glm::dvec2 st = no_coordinates;   ///< on the texture
};

/// The continuation of a warning about a "face" whose corners have different colours.
constexpr std::string_view mixed_colours = "with corners of different colours, drawn in their mean";

/// The continuation of a warning about a "vertex" whose colour has a component below 0 or above 1.
constexpr std::string_view odd_colour = "with a colour out of range, taken as the nearest within";
/// Clamps a colour to 0..1. Returns true if this changed it.
bool clamp_colour(glm::vec3& colour);

/// Averages the colours of a face's corners. The face has a colour only if every corner has one.
class FaceColour {
public:
    void add(const std::optional<glm::vec3>& colour);
    bool varies() const { return varies_ && is_whole_; }
    /// Returns the mean colour, or nothing if a corner has none.
    std::optional<glm::vec3> mean() const;

private:
    glm::vec3 first_{0};
    glm::dvec3 sum_{0};
    int corners_ = 0;
    bool varies_ = false, is_whole_ = true;
};

/// Collects triangles. Corners with bitwise equal positions and normals become one vertex. Drops triangles
/// with two corners in the same place: they are points or lines.
class PartBuilder {
public:
    PartBuilder(std::size_t triangles, bool is_smooth);   ///< `triangles` is an estimate
    void add(const Corner& a, const Corner& b, const Corner& c, std::uint32_t material);
    /// Returns the number of a colour, for add(). 0 means no colour.
    std::uint32_t colour(const std::optional<glm::vec3>& colour);
    Scene take() { return std::move(part_); }
    /// Returns the colours: colour n - 1 belongs to the triangles with material n.
    std::vector<glm::vec3> take_colours() { return std::move(colours_); }
    std::uint64_t dropped() const { return dropped_; }   ///< dropped triangles

private:
    std::uint32_t vertex(const Corner& corner);
    void add_coordinates(const CornerCoordinates& corners);
    std::size_t slot(const glm::dvec3& position, const glm::dvec3& normal) const;
    void grow();
    bool is_smooth_;
    std::uint64_t dropped_ = 0;
    Scene part_;
    std::vector<glm::vec3> colours_;
    std::map<std::array<float, 3>, std::uint32_t> colour_numbers_;
    std::vector<std::uint32_t> table_;   ///< open addressing; size a power of two, at most two thirds full
};

/// Calls append(). If only one of them has texture coordinates, the coordinates of the other become
/// no_coordinates.
void append_part(Scene& scene, const Scene& part, const glm::dmat4& place,
                 std::optional<std::uint32_t> material, std::uint32_t material_base);

/// Gives a flat part the normals of its facets, so that it stays flat in a scene with normals.
void make_smooth(Scene& part);

/// Does the same for a part with instances.
void make_smooth(PlacedScene& part);
/// Returns true if any mesh of the part has normals, so that all of them need some.
bool has_normals(const PlacedScene& part);

}   // namespace rayclock
