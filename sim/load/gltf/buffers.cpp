// Decoding of GLB containers, data URIs, buffer views and accessors.
#include "sim/load/gltf/buffers.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "sim/files/text.hpp"

namespace rayclock {
namespace {

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

std::string decode_base64(std::string_view text, const JsonValue& at) {
    std::string bytes;
    std::uint32_t held = 0;
    int bits = 0;
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    for (const char c : text) {
        int six = 0;
        if (c >= 'A' && c <= 'Z')
            six = c - 'A';
        else if (c >= 'a' && c <= 'z')
            six = c - 'a' + 26;
        else if (c >= '0' && c <= '9')
            six = c - '0' + 52;
        else if (c == '+' || c == '/')
            six = c == '+' ? 62 : 63;
        else
            at.refuse(fmt::format("has {} inside its base64 data", shown(std::string_view(&c, 1))));
        held = (held << 6 | static_cast<std::uint32_t>(six)) & 0xffff;
        bits += 6;
        if (bits >= 8) bytes += static_cast<char>(held >> (bits -= 8));
    }
    return bytes;
}

using Component = GltfComponent;

template <class T> double get_as(const char* raw) {
    T value;
    std::memcpy(&value, raw, sizeof value);
    return static_cast<double>(value);
}

template <class T> Component integer() {
    return {sizeof(T), 1.0 / static_cast<double>(std::numeric_limits<T>::max()), get_as<T>};
}

Component component_of(const JsonValue& type) {
    switch (type.whole(1u << 16)) {
        case 5120: return integer<std::int8_t>();
        case 5121: return integer<std::uint8_t>();
        case 5122: return integer<std::int16_t>();
        case 5123: return integer<std::uint16_t>();
        case 5125: return integer<std::uint32_t>();
        case 5126: return {sizeof(float), 1, get_as<float>};
        default: type.expected("5120, 5121, 5122, 5123, 5125 or 5126");
    }
}

}   // namespace

GltfContainer open_gltf(const std::string& file, std::string_view bytes) {
    const SourcePosition at{file};
    if (!bytes.starts_with("glTF")) return {bytes, {}, false};
    if (bytes.size() < 20)
        at.refuse(fmt::format("the file is cut off: {} bytes are too few for a GLB", bytes.size()));
    if (word(bytes, 4) != 2) at.refuse(fmt::format("GLB version {}; only 2 is known", word(bytes, 4)));
    if (word(bytes, 8) > bytes.size())
        at.refuse(fmt::format("the file is cut off: it has {} bytes of {}", bytes.size(), word(bytes, 8)));
    bytes = bytes.substr(0, word(bytes, 8));
    GltfContainer container{{}, {}, true};
    for (std::size_t next = 12; next + 8 <= bytes.size();) {
        const std::uint32_t length = word(bytes, next), kind = word(bytes, next + 4);
        if (length > bytes.size() - next - 8)
            at.refuse(fmt::format("a GLB chunk of {} bytes goes beyond the end of the file", length));
        const std::string_view chunk = bytes.substr(next + 8, length);
        if (kind == 0x4e4f534a && container.text.empty()) container.text = chunk;
        if (kind == 0x004e4942 && container.binary.empty()) container.binary = chunk;
        next += 8 + std::size_t{length};
    }
    if (container.text.empty()) at.refuse("a GLB without a JSON chunk");
    return container;
}

GltfBuffers::GltfBuffers(const JsonValue& document, const std::filesystem::path& path,
                         const GltfContainer& container, Loading& loading, Warnings& warnings)
    : document_(document), path_(path), container_(container), loading_(loading), warnings_(warnings) {
    if (const auto buffers = document.find("buffers")) inside_.resize(buffers->array().size());
}

/// Throws UserError if the name leads out of the file's folder: an untrusted document must not make the
/// program read arbitrary files.
std::string_view GltfBuffers::file(const JsonValue& uri, const std::string& name) {
    if (leaves_folder(name))
        uri.refuse(fmt::format("names {}, which lies outside the folder of the file", shown(name)));
    auto found = outside_.find(name);
    if (found == outside_.end())   // a file that cannot be read leaves no entry
        found = outside_.emplace(name, loading_.read(path_.parent_path() / name, uri.where())).first;
    return found->second;
}

std::string_view GltfBuffers::buffer(std::uint64_t index) {
    const JsonValue entry = document_.at("buffers")[index];
    const std::uint64_t length = entry.at("byteLength").whole(std::uint64_t{1} << 40);
    const auto uri = entry.find("uri");
    if (!uri && (!container_.is_binary || index != 0)) entry.refuse("has no data: 'uri' is missing");
    std::string_view bytes = container_.binary;
    if (uri) {
        if (!uri->raw().is_string()) uri->expected("a string");
        const std::string& text = uri->raw().get_ref<const std::string&>();
        const std::size_t comma = text.find(";base64,");
        if (text.starts_with("data:") && comma == text.npos)
            uri->expected("base64 data or the name of a file");
        if (text.starts_with("data:")) {
            if (inside_[index].empty())
                inside_[index] = decode_base64(std::string_view(text).substr(comma + 8), *uri);
            bytes = inside_[index];
        } else {
            bytes = file(*uri, decode_percent(text));
        }
    }
    if (bytes.size() < length)
        entry.refuse(fmt::format("is cut off: it has {} bytes of {}", bytes.size(), length));
    return bytes.substr(0, length);
}

std::string_view GltfBuffers::view(const JsonValue& entry) {
    constexpr std::uint64_t far = std::uint64_t{1} << 40;
    const std::string_view all = buffer(entry.at("buffer").whole(inside_.size()));
    const std::uint64_t offset = entry.whole_or("byteOffset", far, 0),
                        length = entry.at("byteLength").whole(far);
    if (offset > all.size() || length > all.size() - offset)
        entry.refuse(
            fmt::format("ends at byte {}, beyond its buffer of {} bytes", offset + length, all.size()));
    return all.substr(offset, length);
}

std::string GltfBuffers::image(std::uint64_t index) {
    const JsonValue entry = document_.at("images")[index];
    if (const auto uri = entry.find("uri")) {
        const std::string text = uri->string();
        const std::size_t comma = text.find(";base64,");
        if (!text.starts_with("data:")) return std::string(file(*uri, decode_percent(text)));
        if (comma == text.npos) uri->expected("base64 data or the name of a file");
        return decode_base64(std::string_view(text).substr(comma + 8), *uri);
    }
    const JsonValue views = document_.at("bufferViews").array();
    return std::string(view(views[entry.at("bufferView").whole(views.size())]));
}

std::string_view GltfBuffers::slice(const JsonValue& accessor, std::uint64_t count, std::uint64_t element,
                                    std::uint64_t& stride) {
    constexpr std::uint64_t far = std::uint64_t{1} << 40;
    const JsonValue views = document_.at("bufferViews").array();
    const JsonValue view = views[accessor.at("bufferView").whole(views.size())];
    const std::string_view bytes = this->view(view);
    const std::uint64_t length = bytes.size();
    stride = view.whole_or("byteStride", 256, 0);
    if (stride == 0) stride = element;
    if (stride < element)
        view.refuse(fmt::format("has a byteStride of {}, less than an element of {} bytes", stride, element));
    const std::uint64_t start = accessor.whole_or("byteOffset", far, 0);
    const std::uint64_t needed = start + (count - 1) * stride + element;
    if (needed > length) accessor.refuse(fmt::format("needs {} bytes of a view of {}", needed, length));
    return bytes.substr(start);
}

std::vector<double> GltfBuffers::read(std::uint64_t index, std::uint64_t width) {
    const JsonValue accessor = document_.at("accessors")[index];
    const JsonValue type = accessor.at("type");
    const char* const wanted = width == 1   ? "SCALAR"
                               : width == 2 ? "VEC2"
                               : width == 3 ? "VEC3"
                               : width == 4 ? "VEC4"
                                            : "MAT4";
    if (type.string() != wanted) type.expected(fmt::format("\"{}\"", wanted));
    const Component component = component_of(accessor.at("componentType"));
    const std::uint64_t count = accessor.at("count").whole(std::uint64_t{1} << 32);
    if (count == 0) accessor.refuse("has a count of 0");
    const auto normalised = accessor.find("normalized");
    const bool is_scaled = normalised && normalised->raw() == Json(true);

    if (!loading_.may_make(count * width * sizeof(double))) accessor.refuse(loading_.too_much());
    const auto sparse = accessor.find("sparse");
    std::vector<double> numbers;
    if (accessor.find("bufferView"))
        numbers = take(accessor, count, component, width, is_scaled);
    else
        numbers.assign(count * width, 0.0);
    if (!sparse && !accessor.find("bufferView"))
        warnings_.count("accessor", "without a buffer view, taken as zeros", 0, accessor.path());
    if (sparse) put(*sparse, component, width, is_scaled, numbers);
    return numbers;
}

std::vector<double> GltfBuffers::take(const JsonValue& from, std::uint64_t count, const Component& component,
                                      std::uint64_t width, bool is_scaled) {
    std::uint64_t stride = 0;
    const std::string_view bytes = slice(from, count, component.bytes * width, stride);
    std::vector<double> numbers;
    numbers.reserve(count * width);
    for (std::uint64_t i = 0; i < count; ++i)
        for (std::uint64_t k = 0; k < width; ++k) {
            const double value = component.get(bytes.data() + i * stride + k * component.bytes);
            numbers.push_back(is_scaled ? std::max(value * component.scale, -1.0) : value);
        }
    return numbers;
}

/// Applies a sparse accessor: a list of element indices and their new values.
void GltfBuffers::put(const JsonValue& sparse, const Component& component, std::uint64_t width,
                      bool is_scaled, std::vector<double>& numbers) {
    const std::uint64_t count = sparse.at("count").whole(numbers.size() / width + 1);
    if (count == 0) sparse.refuse("has a count of 0");
    if (!loading_.may_make(count * (width + 1) * sizeof(double))) sparse.refuse(loading_.too_much());
    const JsonValue indices = sparse.at("indices"), type = indices.at("componentType");
    if (type.raw() != 5121 && type.raw() != 5123 && type.raw() != 5125)
        type.expected("5121, 5123 or 5125 for indices");
    const std::vector<double> at = take(indices, count, component_of(type), 1, false),
                              values = take(sparse.at("values"), count, component, width, is_scaled);
    for (std::size_t i = 0; i < count; ++i) {
        if (!(at[i] < double(numbers.size() / width)) || (i > 0 && !(at[i] > at[i - 1])))
            indices.refuse(fmt::format("names element {} at {}; indices rise, and there are {} elements",
                                       at[i], i, numbers.size() / width));
        std::copy_n(&values[i * width], width, &numbers[std::size_t(at[i]) * width]);
    }
}

}   // namespace rayclock
