#pragma once
// Rays from a file.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/compile/stream.hpp"

namespace rayclock {

/// A stream of rays, numbered from 0.
class Rays {
public:
    virtual ~Rays() = default;
    virtual std::size_t size() const = 0;
    virtual StreamRay operator[](std::size_t i) const = 0;
    /// Returns the stream's name, for messages: its file's path.
    virtual const std::string& name() const = 0;
};

/// Rays in memory.
class ListedRays : public Rays {
public:
    ListedRays(std::string name, std::vector<StreamRay> rays)
        : name_(std::move(name)), rays_(std::move(rays)) {}
    std::size_t size() const override { return rays_.size(); }
    StreamRay operator[](std::size_t i) const override { return rays_[i]; }
    const std::string& name() const override { return name_; }

private:
    std::string name_;
    std::vector<StreamRay> rays_;
};

/// Rays as the rows of a table in memory that the caller keeps. A row has the numbers of an .npy file's ray.
class RayTable : public Rays {
public:
    static constexpr std::size_t least_columns = 6, max_columns = 9;
    struct Shape {
        std::size_t rows = 0, columns = least_columns, bytes_of_number = 4;   ///< 4: float32, 8: float64
    };
    /// Takes numbers in C order and checks every ray, as RayFile does. Throws UserError.
    RayTable(std::string name, const void* numbers, Shape shape, bool any_hit = false);

    std::size_t size() const override { return shape_.rows; }
    StreamRay operator[](std::size_t i) const override;
    const std::string& name() const override { return name_; }

protected:
    explicit RayTable(std::string name, bool any_hit) : name_(std::move(name)), any_hit_(any_hit) {}
    /// Sets the numbers and checks every ray. Throws UserError.
    void set(const void* numbers, Shape shape);

private:
    double number(std::size_t i, std::size_t column) const;
    void check(std::size_t i) const;

    std::string name_;
    const char* numbers_ = nullptr;
    Shape shape_;
    bool any_hit_;
};

/// The rays of a file. It keeps the file's bytes, and converts one ray at a time. docs/guide/streams.md
/// describes the formats:
/// - .npy: float32 or float64, n rows of origin and direction (6 numbers), then t_max (7), t_min and t_max
///   (8), and 1 for any hit (9);
/// - .rays of AnyDSL's traversal: 6 float32 for each ray.
class RayFile : public RayTable {
public:
    /// Reads a file and checks every ray. `any_hit`: every ray requests any hit. Throws UserError that names
    /// the file and the first faulty ray: a number that is NaN, an infinite t_min, an origin or a direction
    /// beyond the limits of StreamRay, t_min above t_max, or a ninth number other than 0 and 1.
    explicit RayFile(const std::string& path, bool any_hit = false);

private:
    std::unique_ptr<const std::string> bytes_;   // they stay in place when the stream is moved
};

}   // namespace rayclock
