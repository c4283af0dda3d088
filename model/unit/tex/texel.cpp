// Addresses and colours of texels, in integers.
#include "model/unit/tex/texel.hpp"

#include <bit>
#include <cmath>

#include "model/fixed/rounding.hpp"
#include "model/fixed/tables.hpp"

namespace rayclock {

namespace {

constexpr std::int64_t one_picture = std::int64_t(1) << coordinate_frac;

/// Returns u or v of a hit. It is signed if the chip has planes.
std::int64_t weight_of(std::uint32_t x, const Config& c) {
    const std::int64_t half = std::int64_t(1) << (c.uv_bits() - 1);
    return c.planes && x >= half ? std::int64_t(x) - 2 * half : std::int64_t(x);
}

/// True if u or v of a plane's hit is saturated.
bool is_saturated(const TexReq& hit, const Config& c) {
    const std::uint32_t least = 1u << (c.uv_bits() - 1), most = least - 1;
    return c.planes && (hit.u == least || hit.u == most || hit.v == least || hit.v == most);
}

/// Returns a corner coordinate interpolated by u and v.
std::int64_t interpolated(const std::array<std::int32_t, 3>& corner, const TexReq& hit, const Config& c) {
    const std::int64_t along_u = std::int64_t(corner[1]) - corner[0],
                       along_v = std::int64_t(corner[2]) - corner[0];
    return corner[0] + ((weight_of(hit.u, c) * along_u + weight_of(hit.v, c) * along_v) >> c.bary_bits);
}

/// Returns the coordinate within the picture, 0 to one_picture - 1.
std::int64_t wrapped(std::int64_t x, WrapMode mode) {
    switch (mode) {
        case WrapMode::repeat: return x & (one_picture - 1);
        case WrapMode::mirror: return (x & one_picture ? ~x : x) & (one_picture - 1);
        default: return std::clamp<std::int64_t>(x, 0, one_picture - 1);
    }
}

/// Returns the coordinate of the upper or left texel of a filter, texel_frac fraction bits, in a level of
/// 2^log_side texels. x lies within the picture.
std::uint32_t in_texels(std::int64_t x, int log_side, bool nearest, WrapMode mode) {
    const auto place = std::int64_t(x >> (coordinate_frac - texel_frac - log_side));
    if (nearest) return std::uint32_t(place);
    const std::int64_t moved = place - (1 << (texel_frac - 1));
    if (mode != WrapMode::repeat) return std::uint32_t(std::max<std::int64_t>(moved, 0));
    return std::uint32_t(moved & ((std::int64_t(1) << (log_side + texel_frac)) - 1));
}

}   // namespace

std::uint32_t level_offset(const TexRecord& record, std::uint32_t level, TexelFormat format) {
    if (level == 0) return 0;
    const auto log_of_level = [&](int l) {
        return lines_log(std::max(int(record.log_width) - l, 0), std::max(int(record.log_height) - l, 0),
                         format);
    };
    const int log = log_of_level(int(level));
    return (1u << log_of_level(0)) + (log > 0 ? (1u << log) + 2 : record.last_level - level);
}

std::uint32_t texture_lines(const TexRecord& record, TexelFormat format) {
    std::uint32_t end = 0;
    for (std::uint32_t level = 0; level <= record.last_level; ++level) {
        const int log = lines_log(std::max(int(record.log_width) - int(level), 0),
                                  std::max(int(record.log_height) - int(level), 0), format);
        end = std::max(end, level_offset(record, level, format) + (1u << log));
    }
    return end;
}

const std::array<std::uint32_t, 1 << log_index_bits>& log_fractions() {
    static const std::array<std::uint32_t, 1 << log_index_bits> fractions = [] {
        constexpr std::size_t step = log_entries >> log_index_bits;
        std::array<std::uint32_t, 1 << log_index_bits> found{};
        for (std::size_t i = 0; i < found.size(); ++i)
            found[i] = rounded(log_table()[step * i + step / 2].value, log_value_bits - level_frac);
        return found;
    }();
    return fractions;
}

std::uint32_t log_of(std::uint32_t x) {
    if (x == 0) return 0;
    const int whole = int(std::bit_width(x)) - 1;
    const auto index =
        std::uint32_t(std::uint64_t(x) << log_index_bits >> whole) & ((1u << log_index_bits) - 1);
    return std::uint32_t(whole << level_frac) + log_fractions()[index];
}

std::uint32_t level_of(const TexReq& hit, const TexRecord& record, std::int32_t spread) {
    if (hit.path == 0) return 0;
    const std::int32_t cosine = unit_bits << level_frac;   // the logarithm of a cosine of 1
    const std::int32_t slant = std::max(cosine - std::int32_t(log_of(hit.cosine)), 0) >> 1;
    const std::int32_t level = record.density + hit.scale + spread + std::int32_t(log_of(hit.path)) + slant;
    const std::int32_t rounded = (level + (1 << (level_frac - 1))) >> level_frac;
    return std::uint32_t(std::clamp(rounded, 0, std::int32_t(record.last_level)));
}

TexelPlace texel_place(const TexReq& hit, const TexRecord& record, std::int32_t spread,
                       const Config& config) {
    TexelPlace place;
    place.cutoff = record.cutoff;
    place.level =
        hit.path != 0 && is_saturated(hit, config) ? record.last_level : level_of(hit, record, spread);
    const int log_width = std::max(int(record.log_width) - int(place.level), 0),
              log_height = std::max(int(record.log_height) - int(place.level), 0);
    const auto wrap_s = record.wrap_s, wrap_t = record.wrap_t;
    const std::uint32_t x = in_texels(wrapped(interpolated(record.s, hit, config), wrap_s), log_width,
                                      record.nearest != 0, wrap_s),
                        y = in_texels(wrapped(interpolated(record.t, hit, config), wrap_t), log_height,
                                      record.nearest != 0, wrap_t);
    const std::uint32_t fraction = (1u << texel_frac) - 1;
    if (!record.nearest) place.weight_x = x & fraction, place.weight_y = y & fraction;
    const TileShape tile = tile_shape(config.texels);
    const std::uint32_t column = x >> texel_frac, row = y >> texel_frac;
    place.x = column & ((1u << tile.log_width) - 1);
    place.y = row & ((1u << tile.log_height) - 1);
    const std::uint32_t tile_number =
        (row >> tile.log_height << std::max(log_width - tile.log_width, 0)) + (column >> tile.log_width);
    place.line = (record.base + level_offset(record, place.level, config.texels) + tile_number) &
                 ((1u << config.addr_bits) - 1);
    return place;
}

const std::array<std::uint32_t, 256>& srgb_table() {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> entries{};
        for (std::size_t code = 0; code < entries.size(); ++code) {
            const double x = double(code) / 255,
                         linear = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
            entries[code] = std::uint32_t(std::lround(linear * (1 << share_bits)));
        }
        return entries;
    }();
    return table;
}

TexelCode texel_of(const Line& line, std::uint32_t x, std::uint32_t y, TexelFormat format) {
    const TileShape tile = tile_shape(format);
    const std::uint32_t at = (y * std::uint32_t(tile.width()) + x) * std::uint32_t(tile.bits), word = at / 32;
    const std::uint64_t next = word + 1 < line.size() ? line[word + 1] : 0;
    const auto bits = std::uint32_t((line[word] | next << 32) >> at % 32);
    if (format == TexelFormat::rgb888) return {{bits >> 24, bits >> 16 & 255, bits >> 8 & 255}, bits & 255};
    const std::uint32_t red = bits >> 12 & 31, green = bits >> 6 & 63, blue = bits >> 1 & 31;
    return {{red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2}, (bits & 1) * 255};
}

void put_texel(Line& line, std::uint32_t x, std::uint32_t y, const std::array<std::uint8_t, 4>& texel,
               TexelFormat format) {
    const TileShape tile = tile_shape(format);
    const auto [red, green, blue, alpha] = texel;
    std::uint64_t bits = std::uint64_t(red) << 24 | green << 16 | blue << 8 | alpha;
    if (format == TexelFormat::rgb565) {
        const auto nearest = [](std::uint32_t code, std::uint32_t most) { return (code * most + 127) / 255; };
        bits = nearest(red, 31) << 12 | nearest(green, 63) << 6 | nearest(blue, 31) << 1 |
               std::uint32_t(alpha >= 128);
    }
    const std::uint32_t at = (y * std::uint32_t(tile.width()) + x) * std::uint32_t(tile.bits), word = at / 32;
    const std::uint64_t mask = ((std::uint64_t(1) << tile.bits) - 1) << at % 32;
    const std::uint64_t shifted = bits << at % 32;
    line[word] = (line[word] & ~std::uint32_t(mask)) | std::uint32_t(shifted);
    if (mask >> 32 != 0)
        line[word + 1] = (line[word + 1] & ~std::uint32_t(mask >> 32)) | std::uint32_t(shifted >> 32);
}

TexRsp filter_texels(const Line& line, const TexelPlace& place, TexelFormat format) {
    constexpr std::uint32_t one = 1u << texel_frac;
    const TexelCode corner[4] = {
        texel_of(line, place.x, place.y, format), texel_of(line, place.x + 1, place.y, format),
        texel_of(line, place.x, place.y + 1, format), texel_of(line, place.x + 1, place.y + 1, format)};
    const auto filtered = [&](const auto& value) {
        const std::uint32_t above = value(0) * (one - place.weight_x) + value(1) * place.weight_x,
                            below = value(2) * (one - place.weight_x) + value(3) * place.weight_x;
        return above * (one - place.weight_y) + below * place.weight_y;
    };
    TexRsp answer;
    answer.hole = filtered([&](int i) { return corner[i].alpha; }) < place.cutoff << (2 * texel_frac);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t sum = filtered([&](int i) { return srgb_table()[corner[i].code[k]]; });
        answer.colour[k] = (sum + (1u << (2 * texel_frac - 1))) >> (2 * texel_frac);
    }
    return answer;
}

}   // namespace rayclock
