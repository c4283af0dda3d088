// PLY, text and binary of both byte orders: every element is walked as the header says, coordinates must be
// finite, indices in range, and the file as long as its counts.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "sim/files/text.hpp"
#include "sim/load/indexed.hpp"
#include "sim/load/mesh_file.hpp"
#include "sim/load/ply_header.hpp"

namespace rayclock {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are read in place");

/// One element a line, its words in the order of the properties.
class TextBody {
public:
    TextBody(const PlyHeader& header, std::string_view rest, const std::string& file)
        : rest_(rest), at_{file, header.lines} {}

    void begin(const PlyElement& element, std::uint64_t index) {
        do {
            if (rest_.empty())
                at_.refuse(fmt::format("the file is cut off: {} {} of {} is missing", element.name, index,
                                       element.count));
            line_ = take_line(rest_);
            ++at_.line;
            check_text(line_, at_, "PLY");
        } while (std::all_of(line_.begin(), line_.end(), [](char c) { return c == ' ' || c == '\t'; }));
    }
    void end() {
        if (const std::string_view more = take_word(line_); !more.empty())
            at_.refuse(shown(more) + " is one word too many");
    }
    double number(PlyType type) {
        const std::string_view word = take_word(line_);
        return type.kind == 'f' ? any_number(word, at_) : static_cast<double>(whole_number(word, at_));
    }
    [[noreturn]] void refuse(const PlyElement&, std::uint64_t, const std::string& sentence) const {
        at_.refuse(sentence);
    }

private:
    std::string_view rest_, line_;
    Place at_;
};

class BinaryBody {
public:
    BinaryBody(const PlyHeader& header, std::string_view rest, const std::string& file)
        : rest_(rest), swap_(header.form == PlyForm::big_endian), at_{file} {}

    void begin(const PlyElement& element, std::uint64_t index) { element_ = &element, index_ = index; }
    void end() {}
    double number(PlyType type) {
        if (rest_.size() < type.bytes)
            at_.refuse(fmt::format("the file is cut off: it ends inside {} {} of {}", element_->name, index_,
                                   element_->count));
        char raw[8];
        std::memcpy(raw, rest_.data(), type.bytes);
        rest_.remove_prefix(type.bytes);
        if (swap_) std::reverse(raw, raw + type.bytes);
        return decode(raw, type);
    }
    [[noreturn]] void refuse(const PlyElement& element, std::uint64_t index,
                             const std::string& sentence) const {
        at_.refuse(fmt::format("{} {}: {}", element.name, index, sentence));
    }

private:
    template <class T> static double as(const char* raw) {
        T value;
        std::memcpy(&value, raw, sizeof value);
        return static_cast<double>(value);
    }
    static double decode(const char* raw, PlyType type) {
        if (type.kind == 'f') return type.bytes == 4 ? as<float>(raw) : as<double>(raw);
        if (type.kind == 'u')
            return type.bytes == 1   ? as<std::uint8_t>(raw)
                   : type.bytes == 2 ? as<std::uint16_t>(raw)
                                     : as<std::uint32_t>(raw);
        return type.bytes == 1   ? as<std::int8_t>(raw)
               : type.bytes == 2 ? as<std::int16_t>(raw)
                                 : as<std::int32_t>(raw);
    }

    std::string_view rest_;
    bool swap_;
    Place at_;
    const PlyElement* element_ = nullptr;
    std::uint64_t index_ = 0;
};

/// Which of the six numbers of a vertex that are kept; -1: none.
int place_of(const std::string& name) {
    static const std::vector<std::string> kept{"x", "y", "z", "nx", "ny", "nz"};
    const auto found = std::find(kept.begin(), kept.end(), name);
    return found == kept.end() ? -1 : static_cast<int>(found - kept.begin());
}

template <class Body> class PlyReader {
public:
    PlyReader(const PlyHeader& header, Body body, Loading& loading)
        : header_(header), body_(body), loading_(loading) {
        for (const PlyElement& e : header.elements)
            if (e.name == "vertex") {
                vertices_ = e.count;
                mesh_.has_normals = std::count_if(e.properties.begin(), e.properties.end(),
                                                  [](const auto& p) { return place_of(p.name) >= 3; }) == 3;
            }
    }

    Scene read(const Place& at) {
        for (const PlyElement& element : header_.elements) elements(element);
        return scene_of(mesh_, at, loading_);
    }

private:
    void elements(const PlyElement& element) {
        const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            if (i % 65'536 == 0) loading_.tell("checking", i, element.count);
            body_.begin(element, i);
            for (const PlyProperty& property : element.properties)
                if (property.count)
                    list(element, i, property, is_face && property.name.starts_with("vertex_ind"));
                else
                    number(element, i, property, is_vertex ? place_of(property.name) : -1);
            body_.end();
            if (!is_vertex) continue;
            mesh_.positions.emplace_back(row_[0], row_[1], row_[2]);
            if (mesh_.has_normals) mesh_.normals.emplace_back(row_[3], row_[4], row_[5]);
        }
    }

    void number(const PlyElement& element, std::uint64_t i, const PlyProperty& property, int place) {
        const double value = body_.number(property.type);
        if (place < 0) return;
        const bool is_position = place < 3, fits = std::abs(value) <= std::numeric_limits<float>::max();
        if (is_position && !fits)
            body_.refuse(element, i,
                         fmt::format("{} is {}, {}", property.name, value,
                                     std::isfinite(value) ? "larger than a 32-bit float can hold"
                                                          : "which is not a finite number"));
        row_[place] = fits ? static_cast<float>(value) : 0.0f;   // a normal of zero counts as none
    }

    void list(const PlyElement& element, std::uint64_t i, const PlyProperty& property, bool is_face) {
        const double length = body_.number(*property.count);
        if (length < 0) body_.refuse(element, i, fmt::format("a list of {} entries", length));
        if (is_face && length > max_corners)
            body_.refuse(element, i,
                         fmt::format("a face with {} corners; the most is {}", length, max_corners));
        const bool is_kept = is_face && length >= 3;   // the others are points and lines
        for (double k = 0; k < length; ++k) {
            const double index = body_.number(property.type);
            if (is_face && !(index >= 0 && index < static_cast<double>(vertices_)))
                body_.refuse(element, i,
                             fmt::format("vertex index {} is out of range: the file has {} (0 is the first)",
                                         index, vertices_));
            if (is_kept) mesh_.indices.push_back(static_cast<std::uint32_t>(index));
        }
        if (!is_kept) return;
        mesh_.end_face();
        triangles_ += static_cast<std::uint64_t>(length) - 2;
        if (triangles_ > max_triangles)
            body_.refuse(element, i, fmt::format("more than {} triangles", max_triangles));
    }

    const PlyHeader& header_;
    Body body_;
    Loading& loading_;
    std::uint64_t vertices_ = 0, triangles_ = 0;
    float row_[6] = {};
    IndexedMesh mesh_;
};

}   // namespace

Scene read_ply(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    const Place at{path.string()};
    const PlyHeader header = read_ply_header(at.file, bytes);
    const std::string_view rest = std::string_view(bytes).substr(header.bytes);
    if (header.form == PlyForm::ascii)
        return PlyReader(header, TextBody(header, rest, at.file), loading).read(at);
    return PlyReader(header, BinaryBody(header, rest, at.file), loading).read(at);
}

}   // namespace rayclock
