#pragma once
// Scene compilation: the scene on the lattice, its tree, and the exact bytes of the chip's memory.
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/core/config.hpp"
#include "model/core/payloads.hpp"
#include "model/base/progress.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// The lattice of N-bit signed coordinates that covers the scene's bounds and the eye: point = centre + pitch
/// * k.
struct Lattice {
    glm::dvec3 centre{0};
    glm::dvec3 pitch{1};   ///< scene units per lattice step, for each axis; none is more than twice another
    int coord_bits = 18;
    double coarsest() const;   ///< the largest pitch
    /// Returns a direction of the scene in lattice steps, in units of the coarsest pitch: d / pitch *
    /// coarsest().
    glm::dvec3 direction(const glm::dvec3& d) const { return d * (coarsest() / pitch); }
    Vec3i snap(const glm::dvec3& point) const;   ///< nearest lattice point, halves away from zero
};
/// Returns a lattice that has the eye as a point. `cubic`: the same pitch along all axes, as spheres and
/// shading require. A plane counts with its point nearest to the middle of the other primitives. With planes
/// the lattice is `room` times as large as necessary, and the squares of the first plane are a whole number
/// of pitches.
Lattice fit_lattice(const Scene& scene, const glm::dvec3& eye, int coord_bits, bool cubic = false,
                    double room = 1);

/// Figures of a compilation.
struct CompileReport {
    std::uint64_t triangles = 0;    ///< of the scene
    std::uint64_t collapsed = 0;    ///< of these, without area on the lattice: left out
    std::uint64_t coincident = 0;   ///< spheres that have the place of one before them: left out
    std::uint64_t nodes = 0, leaves = 0;
    std::uint64_t references = 0;   ///< to primitives, in leaves; exceeds the primitives if leaves share them
    int depth = 0;                  ///< nodes on the longest path from the root
    int stack_need = 0;             ///< most sibling groups that a ray may have to keep
    std::uint64_t bytes = 0;
    glm::dvec3 pitch{0};
    double seconds = 0;
};

/// With two levels: the lattices that the host has chosen for meshes. The entries of of_instance follow the
/// order of primitive numbers, with the scene's own triangles first. Empty meshes are left out.
struct LevelLattices {
    struct Class {
        Lattice lattice;
        glm::dmat4 before{1};   ///< the identity, or the placement applied to the mesh beforehand
    };
    std::vector<Class> classes;
    std::vector<std::uint32_t> of_instance;   ///< class
};

/// Memory of the chip: 64-byte lines, with the root node in line 0. model/engine/*/node.hpp and
/// core/lines.hpp define their layout (Node, PrimData).
struct MemoryImage {
    std::vector<std::uint32_t> words;   ///< 16 words per line, little-endian
    Lattice lattice;
    /// With two levels: first line of the lower structures. The scene's tree and its instances lie before it.
    std::uint32_t meshes = 0;
    std::uint32_t surfaces = 0;             ///< line of primitive 0's surface, if the chip shades
    std::uint32_t rays = 0;                 ///< with a stream: line of its first two rays
    std::vector<std::uint32_t> records{};   ///< with a stream: 8 words for each ray, from line `rays` on
    std::uint32_t primitives = 0;           ///< all primitive numbers lie below
    std::uint32_t listed = 0;               ///< primitives of a list; 0 if there is a tree
    /// With two levels: the first primitives of the instances whose mesh was moved to its place beforehand,
    /// rising.
    std::vector<std::uint32_t> written_out{};
    std::shared_ptr<const LevelLattices> levels{};   ///< with two levels
    CompileReport report;

    /// Returns a line. Beyond the end memory holds zeros: a cache's long line may reach there, and faulty
    /// hardware requests arbitrary lines.
    const std::uint32_t* line(std::uint32_t addr) const {
        static constexpr std::array<std::uint32_t, 16> nothing{};
        if (addr < lines()) return &words[std::size_t(addr) * 16];
        return addr >= rays && addr < end() ? &records[std::size_t(addr - rays) * 16] : nothing.data();
    }
    /// True if some line of an aligned burst of `burst` lines around this one belongs to the scene or to the
    /// rays.
    bool holds(std::uint32_t addr, std::uint32_t burst) const {
        const std::uint32_t first = addr / burst * burst;
        return first < lines() || (!records.empty() && first + (burst - 1) >= rays && first < end());
    }
    const std::uint32_t* half_line(std::uint32_t addr) const { return &words[std::size_t(addr) * 8]; }
    const std::uint32_t* record(std::uint32_t ray) const { return &records[std::size_t(ray) * 8]; }
    std::uint32_t lines() const { return std::uint32_t(words.size() / 16); }   ///< lines of the scene
    /// Returns the line after the last one. A stream's rays count.
    std::uint32_t end() const {
        return records.empty() ? lines() : rays + std::uint32_t(records.size() / 16);
    }
};

/// Snaps the scene to the lattice, builds a wide SAH tree, quantises outward and lays out the image. The
/// bytes are the same on every machine and for every number of threads. Throws UserError if nothing is left
/// on the lattice. It also throws if the image needs more lines, the scene longer primitive numbers, or the
/// tree a deeper stack than the configuration has.
MemoryImage compile_scene(const Scene& scene, const glm::dvec3& eye, const Config& config,
                          const Progress& progress = {});
/// Compiles triangles that are already on the lattice and count. The image's lattice keeps its default.
/// Throws UserError as compile_scene does.
MemoryImage compile_triangles(const std::vector<PrimData>& triangles, const Config& config,
                              const std::string& name, const Progress& progress = {});

/// True if a triangle can be hit, or another triangle may rely on it. A triangle without area cannot, except
/// with the sheared test: rounding its corners may give it area that its neighbour loses.
bool counts(const PrimData& triangle, const Config& config);

/// Puts the rays of a stream behind the scene, two in a line. Throws UserError if the memory has too few
/// lines, or the chip cannot number the rays.
void place_rays(MemoryImage& image, std::span<const RayRecord> rays, const Config& config);

/// Returns the shading registers of a frame. Throws UserError if the configuration has too few lights or
/// bounces, or only one sample.
ShadeFrame make_shade_frame(const Scene& scene, const Whitted& settings, const MemoryImage& image,
                            const Config& config);

/// Returns the configuration with exactly the optional units that the scene and the picture need.
Config fitted_config(const Scene& scene, const Whitted& settings, Config config);

/// Returns the camera registers of a frame: the eye on the lattice, and the pixel map scaled so that every
/// sum of raygen fits and every direction's largest component is at least 2^(M-2). Throws UserError if the
/// picture is larger than pixel_bits allows. It also throws if a direction in its middle would be too short:
/// beyond 175 degrees, or 800 times as wide as high.
Frame make_frame(const Camera& camera, FrameSize size, const Lattice& lattice, const Config& config);
/// Returns these registers together with the addresses that the chip needs of its memory.
Frame make_frame(const Camera& camera, FrameSize size, const MemoryImage& image, const Config& config);
/// Returns the registers of a frame that traces the image's stream of rays.
Frame make_stream_frame(const MemoryImage& image, std::size_t rays, const Config& config);

}   // namespace rayclock
