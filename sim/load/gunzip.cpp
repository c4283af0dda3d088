// Decompression by zlib in pieces of 64 KB, so that a small file cannot expand beyond the allowance.
#include "sim/load/gunzip.hpp"

#include <algorithm>
#include <limits>

#include <zlib.h>

#include "sim/files/input.hpp"
#include "sim/files/text.hpp"

namespace rayclock {
namespace {

constexpr int gzip_only = 16 + MAX_WBITS;   // accept no other wrapping
constexpr std::size_t piece = std::size_t{1} << 16;

/// Owns zlib's state.
class Stream {
public:
    explicit Stream(const SourcePosition& at) {
        if (inflateInit2(&z, gzip_only) != Z_OK) at.refuse("cannot be decompressed: no memory is left");
    }
    ~Stream() { inflateEnd(&z); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    z_stream z{};
};

}   // namespace

std::string mesh_extension(const std::filesystem::path& path) {
    const std::string outer = extension(path);
    return outer == "gz" ? extension(path.stem()) : outer;
}

std::string gunzip(const std::filesystem::path& path, const std::string& bytes, Loading& loading) {
    const SourcePosition at{path.string()};
    Stream stream(at);
    z_stream& z = stream.z;
    std::string out;
    std::string_view rest = bytes;
    for (bool is_open = true; is_open || !rest.empty();) {
        if (!is_open) {   // another gzip member follows the last one
            if (inflateReset(&z) != Z_OK) at.refuse("cannot be decompressed");
            is_open = true;
        }
        loading.report_progress("decompressing", bytes.size() - rest.size(), bytes.size());
        char buffer[piece];
        const std::size_t given = std::min<std::size_t>(rest.size(), std::numeric_limits<uInt>::max());
        z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest.data()));
        z.avail_in = static_cast<uInt>(given);
        z.next_out = reinterpret_cast<Bytef*>(buffer);
        z.avail_out = static_cast<uInt>(sizeof buffer);
        const int result = inflate(&z, Z_NO_FLUSH);
        const std::size_t made = sizeof buffer - z.avail_out;
        rest.remove_prefix(given - z.avail_in);
        if (!loading.may_make(made)) at.refuse(loading.too_much());
        out.append(buffer, made);
        if (result == Z_STREAM_END)
            is_open = false;
        else if (result == Z_BUF_ERROR || (result == Z_OK && rest.empty() && made < sizeof buffer))
            at.refuse("the file is cut off: its compressed data have no end");
        else if (result != Z_OK)
            at.refuse(out.empty() ? "this is not gzip, or it is damaged" : "its compressed data are damaged");
    }
    if (out.empty()) at.refuse("what it holds is empty");
    return out;
}

}   // namespace rayclock
