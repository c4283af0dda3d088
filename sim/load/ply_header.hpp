// The header of a PLY file: elements, and of each its properties.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// Throws UserError unless the header is complete, with x, y, z in `vertex` and a list of indices in `face`.
PlyHeader read_ply_header(const std::string& file, std::string_view bytes);

}   // namespace rayclock
