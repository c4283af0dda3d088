#pragma once
// The simulator as a C++ library: scenes, configurations, simulated frames, traced rays.
// docs/guide/library.md is the guide. Link it with find_package(rayclock) and rayclock::library.
//
// Objects may be used by several threads as long as none changes them. All functions throw Error for input
// that makes no sense, and std::bad_alloc if memory runs out.
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rayclock::library {

/// Input that makes no sense, in one sentence.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

using Vector = std::array<double, 3>;

/// A scene. It never changes; copies share it.
class Scene {
public:
    /// Loads what the command line can name: "gears:4", or a file.
    static Scene load(const std::string& spec);
    /// Makes a scene of triangles, whose corners run counter-clockwise seen from outside.
    static Scene of_triangles(const std::string& name, std::span<const Vector> vertices,
                              std::span<const std::array<std::uint32_t, 3>> indices);

    const std::string& name() const;
    std::size_t triangles() const;

    struct Held;
    const Held& held() const { return *held_; }

private:
    explicit Scene(std::shared_ptr<const Held> held) : held_(std::move(held)) {}
    std::shared_ptr<const Held> held_;
};

/// A machine: the name of a configuration, or a file with one, and parameters that override it.
class Config {
public:
    explicit Config(const std::string& name = "default");
    /// Sets a parameter, as --set key=value does. Returns this configuration.
    Config& set(const std::string& key, const std::string& value);
    /// Returns the value of a parameter as text.
    std::string get(const std::string& key) const;

    struct Held;
    const Held& held() const { return *held_; }

private:
    std::shared_ptr<const Held> held_;
};

/// The picture of a simulated frame.
struct FrameOptions {
    int width = 512, height = 384;
    std::vector<double> mhz{66};   ///< clocks, from 1 to 100000
    int depth = 0;                 ///< bounces of the finished picture; 0: only the camera rays
    bool reference = false;        ///< compare with the reference, and judge every ray
    int threads = 0;               ///< 0: all cores
};

/// The figures of a run at one clock.
struct ClockReport {
    double mhz = 0;
    std::uint64_t cycles = 0;
    double fps = 0, mrays_per_s = 0;
    std::uint64_t dram_bytes = 0;
};

struct Report {
    std::vector<ClockReport> clocks;
    std::string json;   ///< the whole report, with the keys of `rayclock simulate --json`
};

/// Simulates one frame on the model at each clock.
Report simulate(const Scene& scene, const Config& config, const FrameOptions& options = {});

/// The points origin + t direction with t_min <= t <= t_max. The direction may have any length except 0.
struct Ray {
    Vector origin{}, direction{};
    double t_min = 0, t_max = std::numeric_limits<double>::infinity();
    bool any_hit = false;   ///< requests any hit, not the closest
};

constexpr std::uint32_t no_primitive = ~std::uint32_t(0);

/// The answer to a ray. t, u and v are NaN and the primitive is no_primitive without a closest hit.
struct Hit {
    /// `back`: the ray meets the side from which (b - a) x (c - a) points away.
    bool hit = false, back = false;
    std::uint32_t primitive = no_primitive;   ///< the triangle's number in the scene
    double t = 0, u = 0, v = 0;               ///< u, v: weights of the second and third corner
};

/// Returns the machine's answer to each ray, without timing. `threads` 0 means all cores.
std::vector<Hit> trace(const Scene& scene, const Config& config, std::span<const Ray> rays, int threads = 0);

/// Simulates a stream of rays on a machine that reads them from memory.
Report simulate_rays(const Scene& scene, const Config& config, std::span<const Ray> rays,
                     const std::vector<double>& mhz = {66}, int threads = 0);

/// Returns the version, for example "0.1.0".
const char* version();

}   // namespace rayclock::library
