#pragma once
#include <cstdint>
#include <string>

#include "sim/files/image/image.hpp"

namespace rayclock {

// Golden pictures: kept pictures of the reference tracer, against which any engine's picture is held.
// Checking never writes; they are made by another program (tests/golden/make_golden.cpp).

/// Bounds within which a fixed-point engine's picture must stay.
///
/// Snapping vertices to a lattice of 2^-N of the scene's size moves a silhouette by at most 2^-N of the
/// picture's width w, or w 2^-N pixels: N = 16, w = 128 gives 0.002. A pixel changes its primitive only if a
/// silhouette passes its centre, so even with a silhouette in every third pixel no more than 0.1 % of pixels
/// change; quantised ray directions move it as much again only if they have as few bits. Across a silhouette
/// colours differ by about a third of the range (root mean square), so the mean square error is 0.001 *
/// 0.32^2 = 1e-4 of full scale: 40 dB. Elsewhere only normals and barycentrics are rounded, far less than 8
/// of 255 steps; so pixels beyond those are the changed ones, 0.1 %, for which 0.5 % leaves room on small
/// pictures (61 of 128x96).
constexpr double golden_min_psnr_db = 40;
constexpr int golden_tolerance = 8;
constexpr double golden_max_beyond = 0.005;
constexpr int golden_coord_bits = 16;   ///< for lattices at least so fine

/// Below that, each bit less moves silhouettes twice as far and so changes twice as many pixels: 3 dB.
struct GoldenBounds {
    double min_psnr_db = golden_min_psnr_db;
    double max_beyond = golden_max_beyond;
};
GoldenBounds golden_bounds(int coord_bits);

struct GoldenResult {
    bool found = false;   ///< there is a golden picture of that scene and size
    double psnr_db = 0;
    bool within = false;               ///< found, and inside all bounds
    std::uint64_t pixels_beyond = 0;   ///< pixels off by more than golden_tolerance
};

/// folder/<scene with ':' as '_'>_<W>x<H>.png, for example tests/golden/gears_4_128x96.png.
std::string golden_path(const std::string& folder, const std::string& scene_spec, FrameSize size);

/// Compares with the golden picture of that scene and size. Throws UserError if the file is there but
/// unreadable.
GoldenResult check_golden(const std::string& folder, const std::string& scene_spec, const Picture& picture,
                          int coord_bits = golden_coord_bits);

}   // namespace rayclock
