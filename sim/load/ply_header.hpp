// The header of a PLY file: elements, and of each its properties.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/load/loading.hpp"

namespace rayclock {

enum class PlyForm { ascii, little_endian, big_endian };

struct PlyType {
    std::size_t bytes;
    char kind;   ///< 'i' signed, 'u' unsigned, 'f' floating point
};

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count;   ///< type of the length, if this is a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyForm form;
    std::vector<PlyElement> elements;
    std::size_t bytes;   ///< length of the header in the file
    std::uint64_t lines;
};

/// A list of vertices that makes faces: "face" has a polygon in each, "tristrips" strips of triangles with -1
/// between them.
bool makes_faces(const PlyElement& element);
bool is_indices(const PlyProperty& property);

/// Throws UserError unless the header is complete, with x, y, z in `vertex` and one list of indices in each
/// element that makes faces. Lines of an unknown kind are skipped with a warning.
PlyHeader read_ply_header(const std::string& file, std::string_view bytes, Warnings& warnings);

}   // namespace rayclock
