// The bytes of the pictures.
#include "tests/support/scenes/picture_files.hpp"

#include <cstdlib>

#include <zlib.h>

#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test {

std::string png_chunk(const std::string& kind, const std::string& data) {
    const std::string sealed = kind + data;
    const auto sum = std::uint32_t(
        crc32(0, reinterpret_cast<const Bytef*>(sealed.data()), static_cast<uInt>(sealed.size())));
    return raw(std::uint32_t(data.size()), true) + sealed + raw(sum, true);
}

std::string png_of(std::uint32_t width, std::uint32_t height, int depth, int colour_type,
                   const std::string& rows, const std::string& others, bool is_interlaced) {
    uLongf size = compressBound(uLong(rows.size()));
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
             uLong(rows.size()));
    packed.resize(size);
    const std::string header = raw(width, true) + raw(height, true) + char(depth) + char(colour_type) +
                               std::string(2, '\0') + char(is_interlaced);
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + others + png_chunk("IDAT", packed) +
           png_chunk("IEND", "");
}

std::string small_bmp() {
    return "BM" + raw(std::uint32_t(62)) + raw(std::uint32_t(0)) + raw(std::uint32_t(54)) +
           raw(std::uint32_t(40)) + raw(std::uint32_t(2)) + raw(std::uint32_t(1)) + raw(std::uint16_t(1)) +
           raw(std::uint16_t(24)) + std::string(24, '\0') + std::string("\0\x80\xff\x40\0\0\0\0", 8);
}
std::string small_tga() {
    return std::string("\0\0\2\0\0\0\0\0\0\0\0\0", 12) + raw(std::uint16_t(2)) + raw(std::uint16_t(1)) +
           "\x18" + std::string("\0\0\x80\xff\x40\0\0", 7) + std::string(8, '\0') +
           std::string("TRUEVISION-XFILE.\0", 18);
}

std::string small_tiff(std::uint16_t extra) {
    const std::string pixels("\x20\x60\x80\x80\0\0\0\0", 8);
    std::string file = "II" + raw(std::uint16_t(42)) + raw(std::uint32_t(24)) + pixels;   // pixels at 8
    for (int i = 0; i < 4; ++i) file += raw(std::uint16_t(8));                            // bits at 16
    const auto entry = [](int tag, int type, std::uint32_t count, std::uint32_t value) {
        return raw(std::uint16_t(tag)) + raw(std::uint16_t(type)) + raw(count) + raw(value);
    };
    return file + raw(std::uint16_t(10)) + entry(256, 3, 1, 2) + entry(257, 3, 1, 1) + entry(258, 3, 4, 16) +
           entry(259, 3, 1, 1) + entry(262, 3, 1, 2) + entry(273, 4, 1, 8) + entry(277, 3, 1, 4) +
           entry(278, 3, 1, 1) + entry(279, 4, 1, 8) + entry(338, 3, 1, extra) + raw(std::uint32_t(0));
}

std::string small_hdr() {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + std::string("\x80\x40\0\x80\0\0\0\0", 8);
}

std::string small_jpeg(const std::vector<int>& values, int side) {
    const auto segment = [](int mark, const std::string& data) {
        return "\xff" + std::string(1, char(mark)) + raw(std::uint16_t(data.size() + 2), true) + data;
    };
    std::string frame = char(8) + raw(std::uint16_t(side), true) + raw(std::uint16_t(side), true) +
                        char(values.size()),
                scan(1, char(values.size())), bits;
    for (std::size_t i = 0; i < values.size(); ++i) {
        frame += std::string{char(i + 1), 0x11, 0};
        scan += std::string{char(i + 1), 0};
        // A block has only its mean: the length of the number (4 bits), the number, and the end of the block.
        const int mean = 8 * (values[i] - 128);
        int length = 0;
        while (std::abs(mean) >> length) ++length;
        for (int k = 3; k >= 0; --k) bits += char('0' + (length >> k & 1));
        for (int k = length - 1; k >= 0; --k)
            bits += char('0' + ((mean < 0 ? mean + (1 << length) - 1 : mean) >> k & 1));
        bits += '0';
    }
    std::string data;
    for (std::size_t i = 0; i < bits.size(); i += 8) {
        int byte = 0;
        for (std::size_t k = i; k < i + 8; ++k) byte = 2 * byte + (k >= bits.size() || bits[k] == '1');
        data += char(byte);
        if (byte == 0xff) data += '\0';
    }
    std::string lengths(16, '\0'), numbers;
    lengths[3] = 12;   // twelve codes of 4 bits
    for (int i = 0; i < 12; ++i) numbers += char(i);
    const std::string adobe = std::string("Adobe\0\x64\0\0\0\0\0", 12);
    return "\xff\xd8" + (values.size() == 4 ? segment(0xee, adobe) : "") +
           segment(0xdb, '\0' + std::string(64, 1)) + segment(0xc0, frame) +
           segment(0xc4, '\0' + lengths + numbers) + segment(0xc4, "\x10\1" + std::string(16, '\0')) +
           segment(0xda, scan + std::string("\0\x3f\0", 3)) + data + "\xff\xd9";
}

}   // namespace rayclock::test
