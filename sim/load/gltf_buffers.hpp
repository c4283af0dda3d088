// The raw data of a glTF file: container, buffers, and accessors decoded to plain numbers.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/json_value.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// The JSON text of a .gltf or .glb, and the binary part of the latter.
struct GltfContainer {
    std::string_view text;
    std::string_view binary;
    bool is_binary = false;
};
GltfContainer open_gltf(const std::string& file, std::string_view bytes);

/// How one number lies in a buffer.
struct GltfComponent {
    std::uint64_t bytes;
    double scale;   ///< of a normalised integer
    double (*get)(const char*);
};

/// Reads accessors of the document. The bytes, the document and the warnings must outlive it.
class GltfBuffers {
public:
    GltfBuffers(const JsonValue& document, const std::filesystem::path& path, const GltfContainer& container,
                Loading& loading, Warnings& warnings);

    /// All components one after the other, integers as they are or scaled if normalised. `width` is 1, 3,
    /// 4 or 16. An accessor without data is all zeros.
    std::vector<double> read(std::uint64_t accessor, std::uint64_t width);
    /// The bytes of a picture of the document's list `images`.
    std::string image(std::uint64_t index);

private:
    std::vector<double> take(const JsonValue& from, std::uint64_t count, const GltfComponent& component,
                             std::uint64_t width, bool is_scaled);
    void put(const JsonValue& sparse, const GltfComponent& component, std::uint64_t width, bool is_scaled,
             std::vector<double>& numbers);
    std::string_view buffer(std::uint64_t index);
    std::string_view view(const JsonValue& entry);   ///< all bytes of a buffer's view
    std::string_view file(const JsonValue& uri, const std::string& name);
    std::string_view slice(const JsonValue& accessor, std::uint64_t count, std::uint64_t element,
                           std::uint64_t& stride);

    JsonValue document_;
    std::filesystem::path path_;
    GltfContainer container_;
    Loading& loading_;
    Warnings& warnings_;
    std::vector<std::string> inside_;              ///< buffers from data URIs, empty until asked for
    std::map<std::string, std::string> outside_;   ///< files, each read once
};

}   // namespace rayclock
