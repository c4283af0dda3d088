#pragma once
// The memory image: the exact bytes of the chip's memory, and what its compilation reports.
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>

#include "model/layout/lattice.hpp"

namespace rayclock {

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
    std::uint32_t first_mesh_line = 0;
    std::uint32_t first_surface_line = 0;   ///< line of primitive 0's surface, if the chip shades
    /// If the chip shades: the number of the first plane and the line of its surface. The other planes
    /// follow.
    std::uint32_t first_plane = ~0u, first_plane_surface_line = 0;
    std::uint32_t first_ray_line = 0;       ///< with a stream: line of its first two rays
    std::vector<std::uint32_t> records{};   ///< with a stream: 8 words for each ray, from that line on
    /// With a stream: the lines of the hits, if the chip writes them.
    std::uint32_t first_hit_line = 0, hit_lines = 0;
    std::uint32_t primitives = 0;          ///< all primitive numbers lie below
    std::uint32_t listed_primitives = 0;   ///< primitives of a list; 0 if there is a tree
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
        return addr >= first_ray_line && addr < end() ? &records[std::size_t(addr - first_ray_line) * 16]
                                                      : nothing.data();
    }
    /// True if some line of an aligned burst of `burst` lines around this one belongs to the scene or to the
    /// rays.
    bool holds(std::uint32_t addr, std::uint32_t burst) const {
        const std::uint32_t first = addr / burst * burst;
        return first < lines() ||
               (!records.empty() && first + (burst - 1) >= first_ray_line && first < end());
    }
    const std::uint32_t* half_line(std::uint32_t addr) const { return &words[std::size_t(addr) * 8]; }
    const std::uint32_t* record(std::uint32_t ray) const { return &records[std::size_t(ray) * 8]; }
    std::uint32_t lines() const { return std::uint32_t(words.size() / 16); }   ///< lines of the scene
    /// Returns the line after the last one. A stream's rays count.
    std::uint32_t end() const {
        return records.empty() ? lines() : first_ray_line + std::uint32_t(records.size() / 16);
    }
};

}   // namespace rayclock
