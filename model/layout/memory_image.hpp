#pragma once
// Scene compilation: the scene on the lattice, its tree, and the very bytes that the chip's memory would
// hold.
#include <array>
#include <cstdint>
#include <memory>
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
    glm::dvec3 pitch{1};   ///< scene units per lattice step, for each axis; none more than twice another
    int coord_bits = 18;
    double coarsest() const;   ///< the largest pitch
    /// A direction of the scene in lattice steps, in units of the coarsest pitch: d / pitch * coarsest().
    glm::dvec3 direction(const glm::dvec3& d) const { return d * (coarsest() / pitch); }
    Vec3i snap(const glm::dvec3& point) const;   ///< nearest lattice point, halves away from zero
};
/// The eye becomes a lattice point. `cubic`: the same pitch along all axes, as spheres and shading need it. A
/// plane counts with the point that is nearest to the middle of the rest; with planes the lattice is `room`
/// times as large as it must be, and the pitch is a whole part of the first one's squares.
Lattice fit_lattice(const Scene& scene, const glm::dvec3& eye, int coord_bits, bool cubic = false,
                    double room = 1);

/// What compilation found out.
struct CompileReport {
    std::uint64_t triangles = 0;   ///< of the scene
    std::uint64_t collapsed = 0;   ///< of these, without area on the lattice: left out
    std::uint64_t nodes = 0, leaves = 0;
    std::uint64_t references = 0;   ///< to primitives, in leaves; more than there are, if leaves share them
    int depth = 0;                  ///< nodes on the longest path from the root
    int stack_need = 0;             ///< sibling groups that a ray may have to keep
    std::uint64_t bytes = 0;
    glm::dvec3 pitch{0};
    double seconds = 0;
};

/// Of two levels: the lattices that the host has chosen for meshes. Which instance uses which is told in the
/// order of their primitives' numbers, those of the scene's own triangles first; empty meshes are left out.
struct LevelLattices {
    struct Class {
        Lattice lattice;
        glm::dmat4 before{1};   ///< the identity, or the place to which the mesh was moved beforehand
    };
    std::vector<Class> classes;
    std::vector<std::uint32_t> of_instance;   ///< class
};

/// Memory of the chip: 64-byte lines, the root node in line 0. Layout in core/payloads.hpp (Node, PrimData).
struct MemoryImage {
    std::vector<std::uint32_t> words;   ///< 16 words a line, little-endian
    Lattice lattice;
    std::uint32_t meshes = 0;                   ///< of two levels: where the lower structures begin; the
                                                ///< scene's trees and its instances lie before
    std::uint32_t surfaces = 0;                 ///< line of primitive 0's surface, if the chip shades
    std::uint32_t primitives = 0;               ///< the numbers of all lie below
    std::uint32_t listed = 0;                   ///< primitives of a list; 0 if there is a tree
    std::vector<std::uint32_t> written_out{};   ///< of two levels: the first primitives of instances whose
                                                ///< mesh was moved to its place beforehand, rising
    std::shared_ptr<const LevelLattices> levels{};   ///< of two levels
    CompileReport report;

    /// Beyond the end memory holds zeros: a cache's long line may reach there, and faulty hardware asks for
    /// anything.
    const std::uint32_t* line(std::uint32_t addr) const {
        static constexpr std::array<std::uint32_t, 16> nothing{};
        return addr < lines() ? &words[std::size_t(addr) * 16] : nothing.data();
    }
    const std::uint32_t* half_line(std::uint32_t addr) const { return &words[std::size_t(addr) * 8]; }
    std::uint32_t lines() const { return std::uint32_t(words.size() / 16); }
};

/// Snaps, builds a wide SAH tree, quantises outward and lays out the image; the same bytes on every machine
/// and for every number of threads. Throws UserError if nothing is left on the lattice, if the image needs
/// more lines, the scene longer primitive numbers or the tree a deeper stack than the configuration has.
MemoryImage compile_scene(const Scene& scene, const glm::dvec3& eye, const Config& config,
                          const Progress& progress = {});
/// The same for triangles that are on the lattice already and count; the image's lattice is left as it is by
/// default.
MemoryImage compile_triangles(const std::vector<PrimData>& triangles, const Config& config,
                              const std::string& name, const Progress& progress = {});

/// Whether a triangle can take a ray, or another triangle might rely on it. Without an area none does, but
/// for the sheared test: rounding its corners may give it one, and take it from its neighbour.
bool counts(const PrimData& triangle, const Config& config);

/// Registers of a frame for a chip that shades. Throws UserError if the configuration has too few lights,
/// bounces, or one sample only.
ShadeFrame make_shade_frame(const Scene& scene, const Whitted& settings, const MemoryImage& image,
                            const Config& config);

/// The configuration with the units that the scene and the picture need, and without those that they do not.
Config fitted_config(const Scene& scene, const Whitted& settings, Config config);

/// Camera registers for a frame: the eye on the lattice and the pixel map scaled so that every sum of raygen
/// fits and every direction's largest component is 2^(M-2) or more. Throws UserError if the picture is larger
/// than pixel_bits can tell, or so wide that a direction in its middle would be too short (beyond 175
/// degrees, or 800 times as wide as high).
Frame make_frame(const Camera& camera, FrameSize size, const Lattice& lattice, const Config& config);
/// The same, with what the chip must know of its memory.
Frame make_frame(const Camera& camera, FrameSize size, const MemoryImage& image, const Config& config);

}   // namespace rayclock
