// Draws texture records and texels.
#include "sim/explore/torture/textures.hpp"

#include "model/layout/words.hpp"
#include "model/unit/tex/texel.hpp"

namespace rayclock::torture {

namespace {

constexpr int records = 12;       ///< of an image
constexpr int texel_lines = 32;   ///< of an image; 16 x 8 texels of 32 bits take 26 lines with all levels
constexpr int longest_log = 6;    ///< logarithm of the longest side that may fit in these lines

/// Cut-offs of most records. The alpha of most texels differs from one of these by at most 1.
constexpr std::array<std::uint32_t, 4> cutoffs{0, 1, 128, 255};

}   // namespace

Textures::Textures(const Config& config, const Dice& dice, SurfaceStyle style)
    : config_(config), dice_(dice.branch()), style_(style) {}

void Textures::make_cutouts(std::vector<PrimData>& prims) {
    if (!config_.has_textures() || style_ == SurfaceStyle::bright) return;
    for (PrimData& prim : prims)
        if (prim.is_triangle() && (style_ == SurfaceStyle::holes || dice_.percent(30)))
            prim.kind = PrimKind::cutout;
}

std::uint32_t Textures::lines() const { return config_.has_textures() ? records + texel_lines : 0; }

void Textures::append(std::vector<std::uint32_t>& words) {
    if (!config_.has_textures()) return;
    const auto first_texels = std::uint32_t(words.size() / words_per_line);
    for (int i = 0; i < texel_lines; ++i) {
        const Line line = texels();
        words.insert(words.end(), line.begin(), line.end());
    }
    first_record_ = first_texels + texel_lines;
    words.resize(words.size() + records * words_per_line, 0);
    Words scratch;
    for (std::uint32_t i = 0; i < records; ++i)
        write_payload(record(first_texels, i), config_, &words[(first_record_ + i) * words_per_line],
                      scratch);
}

std::uint32_t Textures::record_for(const PrimData& prim) {
    if (!config_.has_textures() || !prim.is_triangle() || style_ == SurfaceStyle::bright) return 0;
    const bool is_cutout = prim.kind == PrimKind::cutout;
    // A cut-out may also have no texture: an instance's material has none.
    const int share = style_ == SurfaceStyle::holes      ? 100
                      : is_cutout                        ? 90
                      : style_ == SurfaceStyle::textured ? 75
                                                         : 25;
    if (!dice_.percent(share)) return 0;
    return first_record_ + std::uint32_t(dice_.below(records));
}

/// Draws a texture coordinate: any, one near the picture, or one near a border of texels or pictures.
std::int32_t Textures::coordinate() {
    switch (dice_.below(3)) {
        case 0: return dice_.signed_number(coordinate_bits);
        case 1: return dice_.between(-2 << coordinate_frac, 2 << coordinate_frac);
        default: {
            const int step = dice_.between(coordinate_frac - longest_log - 1, coordinate_frac + 1);
            return dice_.between(-4, 4) * (1 << step) + dice_.between(-2, 2);
        }
    }
}

std::array<std::int32_t, 3> Textures::corners() {
    std::array<std::int32_t, 3> all{coordinate(), coordinate(), coordinate()};
    if (dice_.percent(25)) all[1] = all[2] = all[0];   // every hit has exactly this coordinate
    return all;
}

/// Draws a density: any, or one that gives paths of half the lattice's size a random level.
std::int32_t Textures::density(std::uint32_t last_level) {
    if (dice_.percent(30)) return dice_.signed_number(level_bits);
    const int octaves =
        dice_.between(-1, int(last_level) + 1) - (config_.coord_bits - 1 + config_.t_frac_bits);
    return (octaves << level_frac) + dice_.between(-(1 << (level_frac - 1)), 1 << (level_frac - 1));
}

/// Draws a record. Its texels usually lie in the lines of texels. In the style `textured` some textures are
/// larger and begin at any address, so that any line of memory serves as texels.
TexRecord Textures::record(std::uint32_t first_texels, std::uint32_t number) {
    TexRecord r;
    r.s = corners(), r.t = corners();
    const bool is_large = style_ == SurfaceStyle::textured && dice_.percent(40);
    const int longest = is_large ? max_side_log : longest_log;
    do {
        r.log_width = std::uint32_t(dice_.percent(is_large ? 50 : 20) ? longest : dice_.between(0, longest));
        r.log_height = std::uint32_t(dice_.percent(20) ? 0 : dice_.between(0, longest));
        if (dice_.percent(50)) std::swap(r.log_width, r.log_height);
        r.last_level = dice_.percent(20) ? 0 : std::max(r.log_width, r.log_height);
    } while (!is_large && texture_lines(r, config_.texels) > texel_lines);
    r.base = is_large
                 ? std::uint32_t(dice_.below(1 << config_.addr_bits))
                 : first_texels +
                       std::uint32_t(dice_.between(0, texel_lines - int(texture_lines(r, config_.texels))));
    r.wrap_s = WrapMode(number % 3), r.wrap_t = WrapMode(number / 3 % 3);
    r.nearest = dice_.percent(30);
    r.density = density(r.last_level);
    if (style_ == SurfaceStyle::holes)
        r.cutoff = cutoffs[std::size_t(dice_.between(1, 3))];
    else
        r.cutoff = dice_.percent(80) ? cutoffs[std::size_t(dice_.below(4))] : std::uint32_t(dice_.below(256));
    return r;
}

/// Draws a line of texels. In the style `holes` nearly all of them are transparent.
Line Textures::texels() {
    Line line;
    for (auto& word : line) word = dice_.bits();   // some bits belong to no texel
    const TileShape tile = tile_shape(config_.texels);
    const std::uint32_t cutoff = cutoffs[std::size_t(dice_.below(4))];
    // Alpha is random, or near the cut-off: one value for the line, or one for each texel.
    const int how = dice_.below(3), all = dice_.between(-1, 1);
    for (int i = 0; i < tile.texels(); ++i) {
        const std::uint32_t colour = dice_.bits();
        std::uint32_t alpha = colour >> 24;
        if (how > 0) {
            const int beyond = how == 1 ? all : dice_.between(-1, 1);
            alpha = std::uint32_t(std::clamp(int(cutoff) + beyond, 0, 255));
        }
        if (style_ == SurfaceStyle::holes) alpha = dice_.percent(1) ? 255 : 0;
        put_texel(line, std::uint32_t(i % tile.width()), std::uint32_t(i / tile.width()),
                  {std::uint8_t(colour), std::uint8_t(colour >> 8), std::uint8_t(colour >> 16),
                   std::uint8_t(alpha)},
                  config_.texels);
    }
    return line;
}

}   // namespace rayclock::torture
