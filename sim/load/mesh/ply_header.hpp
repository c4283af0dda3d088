#pragma once
// The header of a PLY file: its elements and their properties.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/load/loading.hpp"

namespace rayclock {

/// The encoding of the body.
enum class PlyForm { ascii, little_endian, big_endian };

/// The type of a number.
struct PlyType {
    std::size_t bytes;
    char kind;   ///< 'i' signed, 'u' unsigned, 'f' floating point
};

/// A number, or a list of numbers, of each row of an element.
struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count;   ///< type of the list's length; empty if this is not a list
};

/// A table of the file: `count` rows with the same properties.
struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;
};

/// The whole header.
struct PlyHeader {
    PlyForm form;
    std::vector<PlyElement> elements;
    std::size_t bytes;   ///< length of the header in the file
    std::uint64_t lines;
};

/// Returns true for an element that makes faces. "face" has a polygon in each row. "tristrips" has strips of
/// triangles, separated by -1.
bool makes_faces(const PlyElement& element);
/// Returns true for the list of vertex numbers of such an element.
bool is_indices(const PlyProperty& property);

/// Reads the header. Throws UserError unless it is complete, has x, y, z in `vertex`, and one list of indices
/// in each element that makes faces. Skips lines of an unknown kind with a warning.
PlyHeader read_ply_header(const std::string& file, std::string_view bytes, Warnings& warnings);

}   // namespace rayclock
