#pragma once
// Golden pictures: stored pictures of the reference tracer, with which a test compares any engine's picture.
// Checking never writes them; tests/golden/make_golden.cpp makes them.
#include <cstdint>
#include <string>

#include "sim/files/image/image.hpp"

namespace rayclock {

/// The bounds within which a fixed-point engine's picture must stay.
///
/// Snapping vertices to a lattice of 2^-N of the scene's size moves a silhouette by at most 2^-N of the
/// picture's width w. In pixels this is w 2^-N: 0.002 for N = 16 and w = 128. A pixel changes its primitive
/// only if a silhouette passes its centre. So even with a silhouette in every third pixel, at most 0.1 % of
/// the pixels change. Quantised ray directions move a silhouette as much again only if they have as few bits.
/// Across a silhouette, colours differ by about a third of the range (root mean square). So the mean square
/// error is 0.001 * 0.32^2 = 1e-4 of full scale: 40 dB. Elsewhere only normals and barycentrics are rounded,
/// which changes colours far less than 8 steps of 255. So pixels beyond 8 steps are the changed ones: 0.1 %.
/// The bound of 0.5 % leaves room on small pictures (61 pixels of 128x96).
constexpr double golden_min_psnr_db = 40;
constexpr int golden_tolerance = 8;
constexpr double golden_max_beyond = 0.005;
constexpr int golden_coord_bits = 16;   ///< for lattices at least this fine

/// The bounds for a coarser lattice. Each bit less moves silhouettes twice as far and so changes twice as
/// many pixels: 3 dB.
struct GoldenBounds {
    double min_psnr_db = golden_min_psnr_db;
    double max_beyond = golden_max_beyond;
};
GoldenBounds golden_bounds(int coord_bits);

/// The comparison with a golden picture.
struct GoldenResult {
    bool found = false;   ///< a golden picture of that scene and size exists
    double psnr_db = 0;
    bool within = false;               ///< found, and inside all bounds
    std::uint64_t pixels_beyond = 0;   ///< pixels off by more than golden_tolerance
};

/// Returns folder/<scene with ':' and '/' as '_'>_<W>x<H>.png, for example tests/golden/gears_4_128x96.png.
std::string golden_path(const std::string& folder, const std::string& scene_spec, FrameSize size);

/// Compares with the golden picture of that scene and size. Throws UserError if the file exists but cannot be
/// read.
GoldenResult check_golden(const std::string& folder, const std::string& scene_spec, const Picture& picture,
                          int coord_bits = golden_coord_bits);

}   // namespace rayclock
