#pragma once
// The raw data of a glTF file: the container, the buffers, and the accessors decoded to numbers.
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/json_value.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// The JSON text of a .gltf or .glb file, and the binary chunk of the latter.
struct GltfContainer {
    std::string_view text;
    std::string_view binary;
    bool is_binary = false;
};
/// Splits a file into its chunks. The result refers to `bytes`. Throws UserError if the file is damaged.
GltfContainer open_gltf(const std::string& file, std::string_view bytes);

/// The layout of one number in a buffer.
struct GltfComponent {
    std::uint64_t bytes;
    double scale;   ///< factor for a normalised integer
    double (*get)(const char*);
};

/// Reads the accessors of a document. The caller must keep the document, the bytes and the warnings alive.
class GltfBuffers {
public:
    GltfBuffers(const JsonValue& document, const std::filesystem::path& path, const GltfContainer& container,
                Loading& loading, Warnings& warnings);

    /// Returns all components of an accessor one after the other. Integers keep their value, or are scaled if
    /// normalised. `width` is 1, 2, 3, 4 or 16. An accessor without data yields zeros. Throws UserError if
    /// the accessor is wrong.
    std::vector<double> read(std::uint64_t accessor, std::uint64_t width);
    /// Returns the bytes of a picture in the document's list `images`. Throws UserError if the document is
    /// wrong or a file cannot be read.
    std::string image(std::uint64_t index);

private:
    std::vector<double> take(const JsonValue& from, std::uint64_t count, const GltfComponent& component,
                             std::uint64_t width, bool is_scaled);
    void put(const JsonValue& sparse, const GltfComponent& component, std::uint64_t width, bool is_scaled,
             std::vector<double>& numbers);
    std::string_view buffer(std::uint64_t index);
    std::string_view view(const JsonValue& entry);   ///< all bytes of a buffer view
    std::string_view file(const JsonValue& uri, const std::string& name);
    std::string_view slice(const JsonValue& accessor, std::uint64_t count, std::uint64_t element,
                           std::uint64_t& stride);

    JsonValue document_;
    std::filesystem::path path_;
    GltfContainer container_;
    Loading& loading_;
    Warnings& warnings_;
    std::vector<std::string> inside_;   ///< decoded data URIs of the buffers; empty until first used
    std::map<std::string, std::string> outside_;   ///< files; each is read once
};

}   // namespace rayclock
