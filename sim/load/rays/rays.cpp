// Rays from a file.
#include "sim/load/rays/rays.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/input.hpp"
#include "sim/files/npy.hpp"

namespace rayclock {

RayTable::RayTable(std::string name, const void* numbers, Shape shape, bool any_hit)
    : RayTable(std::move(name), any_hit) {
    set(numbers, shape);
}

RayFile::RayFile(const std::string& path, bool any_hit) : RayTable(path, any_hit) {
    if (path.empty()) throw UserError("--rays names no file");
    Shape shape;
    std::size_t begin = 0;
    const std::string kind = extension(path);
    if (kind != "npy" && kind != "rays")
        throw UserError(printable(path) + ": rays come from .npy and .rays files");
    bytes_ = std::make_unique<const std::string>(read_file(path));
    const std::string& bytes = *bytes_;
    if (kind == "rays") {
        if (bytes.size() % (least_columns * 4) != 0)
            throw UserError(
                fmt::format("{}: a ray takes 24 bytes, and the file's {} bytes are not a multiple of that",
                            printable(path), bytes.size()));
        shape.rows = bytes.size() / (least_columns * 4);
    } else {
        const NpyHead head = read_npy_head(bytes, printable(path));
        if (head.descr != "<f4" && head.descr != "<f8")
            throw UserError(
                fmt::format("{}: rays are float32 or float64, little-endian (<f4, <f8), and these are {}",
                            printable(path), head.descr.empty() ? "a structure" : shown(head.descr)));
        if (head.shape.size() != 2 || head.shape[1] < least_columns || head.shape[1] > max_columns) {
            std::string shape;
            for (const std::uint64_t n : head.shape)
                shape += (shape.empty() ? "" : " x ") + std::to_string(n);
            throw UserError(fmt::format("{}: rays are n x 6, 7, 8 or 9 numbers, and these are {}",
                                        printable(path), shape.empty() ? "a single number" : shape));
        }
        begin = head.begin;
        shape = {head.shape[0], head.shape[1], head.descr == "<f4" ? std::size_t(4) : std::size_t(8)};
    }
    set(bytes.data() + begin, shape);
}

void RayTable::set(const void* numbers, Shape shape) {
    numbers_ = static_cast<const char*>(numbers);
    shape_ = shape;
    if (shape.rows == 0) throw UserError(printable(name_) + ": there are no rays");
    for (std::size_t i = 0; i < shape.rows; ++i) check(i);
}

double RayTable::number(std::size_t i, std::size_t column) const {
    const char* at = numbers_ + (i * shape_.columns + column) * shape_.bytes_of_number;
    if (shape_.bytes_of_number == 4) {
        float value;
        std::memcpy(&value, at, 4);
        return double(value);
    }
    double value;
    std::memcpy(&value, at, 8);
    return value;
}

StreamRay RayTable::operator[](std::size_t i) const {
    StreamRay ray;
    for (int k = 0; k < 3; ++k) {
        ray.origin[k] = number(i, std::size_t(k));
        ray.direction[k] = number(i, std::size_t(3 + k));
    }
    if (shape_.columns >= 8) ray.t_min = number(i, 6);
    if (shape_.columns >= 7) ray.t_max = number(i, shape_.columns == 7 ? 6 : 7);
    ray.any_hit = any_hit_ || (shape_.columns == 9 && number(i, 8) != 0);
    return ray;
}

void RayTable::check(std::size_t i) const {
    const auto refuse = [&](const std::string& what) {
        throw UserError(fmt::format("{}: ray {} {}", printable(name_), i, what));
    };
    const StreamRay ray = (*this)[i];
    bool finite = true;
    double largest = 0, farthest = 0;
    for (int k = 0; k < 3; ++k) {
        finite = finite && std::isfinite(ray.origin[k]) && std::isfinite(ray.direction[k]);
        largest = std::max(largest, std::abs(ray.direction[k]));
        farthest = std::max(farthest, std::abs(ray.origin[k]));
    }
    if (!finite) refuse("has a coordinate that is NaN or infinite");
    if (largest == 0) refuse("has the direction 0");
    if (largest < StreamRay::least_size || largest > StreamRay::max_size)
        refuse(fmt::format("has a direction whose largest component is {}; it must lie in 2^-500 ... 2^500",
                           largest));
    if (farthest > StreamRay::max_size)
        refuse(fmt::format("has an origin with a coordinate of {}; 2^500 is the largest", farthest));
    if (!std::isfinite(ray.t_min) || std::isnan(ray.t_max))
        refuse(fmt::format("has t_min {} and t_max {}", ray.t_min, ray.t_max));
    if (ray.t_min > ray.t_max) refuse(fmt::format("has t_min {} above t_max {}", ray.t_min, ray.t_max));
    if (shape_.columns == 9 && number(i, 8) != 0 && number(i, 8) != 1)
        refuse(fmt::format("has {} in its ninth column, which is 1 for any hit and 0 for the closest",
                           number(i, 8)));
}

}   // namespace rayclock
