#pragma once
// Rays from a file.
#include <string>

#include "model/compile/stream.hpp"

namespace rayclock {

/// The rays of a file, which stay as they are stored and are converted one at a time. docs/streams.md
/// describes the formats:
/// - .npy: float32 or float64, n rows of origin and direction (6 numbers), then t_max (7), t_min and t_max
/// (8), and 1
///   for any hit (9);
/// - .rays of AnyDSL's traversal: 6 float32 for each ray, and nothing else.
class RayFile {
public:
    /// Reads a file and checks every ray. `any_hit`: every ray asks for any hit. Throws UserError that names
    /// the file and the first faulty ray: a number that is NaN, an origin or t_min that is infinite, a
    /// direction that is zero or infinite, t_min above t_max, or a ninth number other than 0 and 1.
    explicit RayFile(const std::string& path, bool any_hit = false);

    std::size_t size() const { return count_; }
    StreamRay operator[](std::size_t i) const;
    const std::string& path() const { return path_; }

private:
    double number(std::size_t i, std::size_t column) const;
    void check(std::size_t i) const;

    std::string path_, bytes_;
    std::size_t begin_ = 0, count_ = 0, columns_ = 6, bytes_of_number_ = 4;
    bool any_hit_;
};

}   // namespace rayclock
