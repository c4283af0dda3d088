// Making the parts of a scene: flat and smooth ones side by side, exact joining. How they are put in their
// places is model/scene/placed.hpp.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/placed.hpp"

namespace rayclock {

/// One corner of a triangle as a file gives it. A normal that is zero means that there is none.
struct Corner {
    glm::dvec3 position{0};
    glm::dvec3 normal{0};
};

/// What becomes of a "face" whose corners have different colours.
constexpr std::string_view mixed_colours = "with corners of different colours, drawn in their mean";

/// A "vertex" whose colour has a component below 0 or above 1.
constexpr std::string_view odd_colour = "with a colour out of range, taken as the nearest within";
/// Takes the nearest colour within, and returns true if it was another one.
bool clamp_colour(glm::vec3& colour);

/// The colour of a face whose corners have colours: their mean, if every corner has one.
class FaceColour {
public:
    void add(const std::optional<glm::vec3>& colour);
    bool varies() const { return varies_ && is_whole_; }
    std::optional<glm::vec3> mean() const;

private:
    glm::vec3 first_{0};
    glm::dvec3 sum_{0};
    int corners_ = 0;
    bool varies_ = false, is_whole_ = true;
};

/// Collects triangles. Corners with equal positions and normals, to the last bit, become one vertex;
/// triangles with two corners in the same place are points or lines and are left out.
class PartBuilder {
public:
    PartBuilder(std::size_t triangles, bool is_smooth);   ///< `triangles` is a guess
    void add(const Corner& a, const Corner& b, const Corner& c, std::uint32_t material);
    /// The number of a colour, for add(); 0 for none.
    std::uint32_t colour(const std::optional<glm::vec3>& colour);
    Scene take() { return std::move(part_); }
    /// Colour n - 1 is that of the triangles whose material has the number n.
    std::vector<glm::vec3> take_colours() { return std::move(colours_); }
    std::uint64_t dropped() const { return dropped_; }   ///< triangles that were left out

private:
    std::uint32_t vertex(const Corner& corner);
    std::size_t slot(const glm::dvec3& position, const glm::dvec3& normal) const;
    void grow();
    bool is_smooth_;
    std::uint64_t dropped_ = 0;
    Scene part_;
    std::vector<glm::vec3> colours_;
    std::map<std::array<float, 3>, std::uint32_t> colour_numbers_;
    std::vector<std::uint32_t> table_;   ///< open hashing, a power of two, at most two thirds in use
};

/// Gives a flat part its facets' normals, so that it can stand beside smooth ones and stay flat.
void make_smooth(Scene& part);

/// The same of a part with instances.
void make_smooth(PlacedScene& part);
/// Something in it has normals, so that all must have some.
bool has_normals(const PlacedScene& part);

}   // namespace rayclock
