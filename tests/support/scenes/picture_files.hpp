#pragma once
// The bytes of small pictures in several formats, for the tests of textures.
#include <cstdint>
#include <string>
#include <vector>

namespace rayclock::test {

/// Returns a chunk of a PNG file, with its checksum.
std::string png_chunk(const std::string& kind, const std::string& data);

/// Returns a PNG file. `rows` holds the rows, each after its filter byte 0. `others` are chunks before the
/// pixels. `is_interlaced`: the rows belong to the seven passes.
std::string png_of(std::uint32_t width, std::uint32_t height, int depth, int colour_type,
                   const std::string& rows, const std::string& others = {}, bool is_interlaced = false);

/// A BMP or TGA file of 2 x 1 pixels: the codes 255, 128, 0 and 0, 0, 64.
std::string small_bmp();
std::string small_tga();

/// A TIFF file of two pixels: 32, 96, 128, 128 and 0, 0, 0, 0. `extra`: 1 if colours are multiplied by alpha,
/// 2 if not.
std::string small_tiff(std::uint16_t extra);

/// A Radiance file of 2 x 1 pixels: 0.5, 0.25, 0 and black.
std::string small_hdr();

/// A JPEG file of one block in one colour: grey, YCbCr, or with four values the inverted CMYK of Adobe.
/// `side`: the width and the height that the header claims; the block has 8 x 8 texels.
std::string small_jpeg(const std::vector<int>& values, int side = 8);

}   // namespace rayclock::test
