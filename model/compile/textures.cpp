// Lays out texels, and rounds corner coordinates and densities.
#include "model/compile/textures.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include <tbb/parallel_for.h>
#include <glm/matrix.hpp>

#include "model/compile/emit.hpp"
#include "model/compile/plane.hpp"
#include "model/layout/words.hpp"
#include "model/scene/camera.hpp"

namespace rayclock {

namespace {

WrapMode mode_of(Wrap wrap) {
    return wrap == Wrap::repeat   ? WrapMode::repeat
           : wrap == Wrap::mirror ? WrapMode::mirror
                                  : WrapMode::clamp;
}

/// Returns a logarithm with level_frac fraction bits, within the range of level_bits.
std::int32_t level_number(double log) {
    constexpr double most = (1 << (level_bits - 1)) - 1;
    const double scaled = std::ldexp(log, level_frac);
    return std::int32_t(std::round(scaled > -most ? std::min(scaled, most) : -most));
}

/// Returns the index of the texel at position i along a side. i lies at most one texel beyond the end. In
/// tiles larger than the picture it may lie farther out, but no filter reads those texels.
int wrapped_texel(int i, int side, Wrap wrap) {
    return wrap == Wrap::repeat ? i % side : std::min(i, side - 1);
}

/// Fills the lines of one level.
void write_level(const TexelLevel& level, const Texture& texture, TexelFormat format, std::uint32_t* words) {
    const TileShape tile = tile_shape(format);
    const int columns = std::max(level.width >> tile.log_width, 1),
              rows = std::max(level.height >> tile.log_height, 1);
    tbb::parallel_for(0, rows, [&](int row) {
        for (int column = 0; column < columns; ++column) {
            Line line{};
            for (int y = 0; y <= 1 << tile.log_height; ++y)
                for (int x = 0; x <= 1 << tile.log_width; ++x) {
                    const int from_x =
                                  wrapped_texel((column << tile.log_width) + x, level.width, texture.wrap_s),
                              from_y =
                                  wrapped_texel((row << tile.log_height) + y, level.height, texture.wrap_t);
                    put_texel(
                        line, std::uint32_t(x), std::uint32_t(y),
                        level.texels[std::size_t(from_y) * std::size_t(level.width) + std::size_t(from_x)],
                        format);
                }
            std::ranges::copy(line, words + std::size_t(row * columns + column) * words_per_line);
        }
    });
}

/// Sets the fields that all records of a texture share.
TexRecord common_record(const Texture& texture, std::uint32_t base) {
    const std::vector<TexelLevel>& levels = texture.pyramid->levels;
    TexRecord record;
    record.base = base;
    record.log_width = std::uint32_t(std::bit_width(unsigned(levels[0].width))) - 1;
    record.log_height = std::uint32_t(std::bit_width(unsigned(levels[0].height))) - 1;
    record.wrap_s = mode_of(texture.wrap_s), record.wrap_t = mode_of(texture.wrap_t);
    record.nearest = texture.nearest;
    record.last_level = texture.mipmaps ? std::uint32_t(levels.size()) - 1 : 0;
    return record;
}

bool has_texels(const Scene& scene, const Config& config) {
    return config.has_textures() && shows_textures(scene);
}

void set_coordinates(const CornerCoordinates& corners, TexRecord& record) {
    for (std::size_t k = 0; k < 3; ++k) {
        record.s[k] = std::int32_t(std::lround(std::ldexp(corners[k].x, coordinate_frac)));
        record.t[k] = std::int32_t(std::lround(std::ldexp(corners[k].y, coordinate_frac)));
    }
}

void set_plane(const Plane& plane, const Texture& texture, const Lattice& lattice, TexRecord& record,
               double& detail) {
    detail = texture_detail(texture, plane);
    if (const auto corners = plane_coordinates(plane, plane_on_lattice(plane, lattice), texture))
        return set_coordinates(*corners, record);
    // One texel everywhere: the average colour.
    record.last_level = std::uint32_t(texture.pyramid->levels.size()) - 1;
    detail = std::numeric_limits<double>::infinity();
}

TextureLines::key_type texels_of(const Texture& texture) {
    return {texture.pyramid.get(), texture.wrap_s, texture.wrap_t};
}

}   // namespace

TexRecord record_of(const Scene& scene, const Lattice& lattice, const Config& config, std::size_t primitive,
                    std::uint32_t base) {
    const Texture& texture = scene.textures[*texture_of(scene, primitive)];
    TexRecord record = common_record(texture, base);
    const std::size_t triangles = scene.triangles.size(), planes = triangles + scene.spheres.size();
    double detail = 0;
    if (primitive < triangles) {
        set_coordinates(scene.coordinates[primitive], record);
        if (const double cutoff = scene.materials[scene.triangles[primitive].material].cutoff; cutoff > 0)
            record.cutoff = std::uint32_t(std::clamp(std::round(cutoff * 255), 1.0, 255.0));
        detail = texture_detail(scene, std::uint32_t(primitive));
    } else if (primitive < planes) {
        set_coordinates({{{0, 0}, {1, 0}, {0, 1}}}, record);
        detail = texture_detail(texture, scene.spheres[primitive - triangles]);
    } else {
        set_plane(scene.planes[primitive - planes], texture, lattice, record, detail);
    }
    record.density = level_number(detail + std::log2(lattice.pitch.x) - config.t_frac_bits);
    return record;
}

std::int32_t texel_scale_of(const std::array<std::int32_t, 9>& a, const Config& config) {
    glm::dmat3 map;
    for (int i = 0; i < 9; ++i) map[i % 3][i / 3] = std::ldexp(double(a[std::size_t(i)]), -config.map_frac());
    return level_number(std::log2(std::abs(glm::determinant(map))) / 3);
}

void write_texels(const Scene& scene, const Config& config, const std::string& name, TextureLines& known,
                  MemoryImage& image) {
    if (!has_texels(scene, config)) return;
    for (std::size_t i = 0; i < primitive_count(scene); ++i) {
        const std::optional<std::uint32_t> number = texture_of(scene, i);
        if (!number) continue;
        const Texture& texture = scene.textures[*number];
        const std::uint64_t first = image.lines();
        if (!known.try_emplace(texels_of(texture), std::uint32_t(first)).second) continue;
        TexRecord record = common_record(texture, 0);
        record.last_level = std::uint32_t(texture.pyramid->levels.size()) - 1;
        check_lines(first + texture_lines(record, config.texels), config, name);
        image.words.resize((first + texture_lines(record, config.texels)) * words_per_line, 0);
        for (std::uint32_t l = 0; l <= record.last_level; ++l)
            write_level(texture.pyramid->levels[l], texture, config.texels,
                        &image.words[(first + level_offset(record, l, config.texels)) * words_per_line]);
    }
}

std::vector<std::uint32_t> write_records(const Scene& scene, const Lattice& lattice, const Config& config,
                                         const std::string& name, const TextureLines& known,
                                         MemoryImage& image) {
    if (!has_texels(scene, config)) return {};
    std::vector<std::uint32_t> records(primitive_count(scene));
    std::uint64_t next = image.lines();
    for (std::size_t i = 0; i < records.size(); ++i)
        if (texture_of(scene, i)) records[i] = std::uint32_t(next++);
    check_lines(next, config, name);
    image.words.resize(next * words_per_line, 0);
    rewrite_records(scene, lattice, config, known, records, image);
    return records;
}

void rewrite_records(const Scene& scene, const Lattice& lattice, const Config& config,
                     const TextureLines& known, const std::vector<std::uint32_t>& records,
                     MemoryImage& image) {
    tbb::parallel_for(std::size_t(0), records.size(), [&](std::size_t i) {
        if (records[i] == 0) return;
        const Texture& texture = scene.textures[*texture_of(scene, i)];
        Words scratch;
        write_payload(record_of(scene, lattice, config, i, known.at(texels_of(texture))), config,
                      &image.words[std::size_t(records[i]) * words_per_line], scratch);
    });
}

std::vector<std::uint32_t> write_textures(const Scene& scene, const Lattice& lattice, const Config& config,
                                          const std::string& name, MemoryImage& image) {
    TextureLines lines;
    write_texels(scene, config, name, lines, image);
    return write_records(scene, lattice, config, name, lines, image);
}

std::int32_t spread_of(const Camera& camera, std::uint32_t height, int samples_per_side) {
    return level_number(std::log2(sample_spread(camera, {0, int(height)}, samples_per_side)) - length_bias);
}

}   // namespace rayclock
