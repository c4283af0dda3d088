#pragma once
// NumPy's array files, format versions 1.0 to 3.0 (numpy.lib.format). Arrays are read in C order,
// little-endian.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rayclock {

/// The head of an .npy file.
struct NpyHead {
    std::string descr;   ///< the type of an element: "<f4"; empty for a structured type
    std::vector<std::uint64_t> shape;
    std::size_t begin = 0;   ///< offset of the data, in bytes
};

/// Reads the head of the file's bytes. Throws UserError, which names the file, if the file is not an .npy
/// file, is in Fortran order, holds Python objects, or has another number of bytes than the shape says.
NpyHead read_npy_head(std::string_view bytes, const std::string& name);

/// Returns the head of an array. `descr` is Python's text of its type.
std::string npy_head(const std::string& descr, const std::vector<std::uint64_t>& shape);

}   // namespace rayclock
