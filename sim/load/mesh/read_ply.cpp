// PLY, text and binary of both byte orders. Reads every element as the header declares it. Coordinates of
// used vertices must be finite, indices must be in range, and the file must be as long as its counts require.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "sim/files/text.hpp"
#include "sim/load/mesh/indexed.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/mesh/ply_header.hpp"

namespace rayclock {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are read in place");

/// Reads the text form: one row of an element per line, its words in the order of the properties.
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
    void end(Warnings& warnings) {
        if (const std::string_view more = take_word(line_); !more.empty())
            warnings.count("line", "with more words than the header declares, which are skipped", at_.line,
                           more);
    }
    std::uint64_t line() const { return at_.line; }
    void skip(PlyType) {
        if (take_word(line_).empty()) at_.refuse("a number is missing at the end");
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
    SourcePosition at_;
};

/// Reads the binary form.
class BinaryBody {
public:
    BinaryBody(const PlyHeader& header, std::string_view rest, const std::string& file)
        : rest_(rest), swap_(header.form == PlyForm::big_endian), at_{file} {}

    void begin(const PlyElement& element, std::uint64_t index) { element_ = &element, index_ = index; }
    void end(Warnings&) {}
    std::uint64_t line() const { return 0; }
    void skip(PlyType type) { take(type); }
    double number(PlyType type) {
        const std::string_view bytes = take(type);
        char raw[8];
        std::memcpy(raw, bytes.data(), bytes.size());
        if (swap_) std::reverse(raw, raw + type.bytes);
        return decode(raw, type);
    }
    [[noreturn]] void refuse(const PlyElement& element, std::uint64_t index,
                             const std::string& sentence) const {
        at_.refuse(fmt::format("{} {}: {}", element.name, index, sentence));
    }

private:
    std::string_view take(PlyType type) {
        if (rest_.size() < type.bytes)
            at_.refuse(fmt::format("the file is cut off: it ends inside {} {} of {}", element_->name, index_,
                                   element_->count));
        const std::string_view bytes = rest_.substr(0, type.bytes);
        rest_.remove_prefix(type.bytes);
        return bytes;
    }
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
    SourcePosition at_;
    const PlyElement* element_ = nullptr;
    std::uint64_t index_ = 0;
};

/// Returns the position of a property in `row_`, the nine numbers that are kept of a vertex or a face.
/// Returns -1 if it is not kept.
int place_of(const std::string& name) {
    static const std::map<std::string, int> kept{{"x", 0},           {"y", 1},
                                                 {"z", 2},           {"nx", 3},
                                                 {"ny", 4},          {"nz", 5},
                                                 {"red", 6},         {"green", 7},
                                                 {"blue", 8},        {"r", 6},
                                                 {"g", 7},           {"b", 8},
                                                 {"diffuse_red", 6}, {"diffuse_green", 7},
                                                 {"diffuse_blue", 8}};
    const auto found = kept.find(name);
    return found == kept.end() ? -1 : found->second;
}

/// Returns the factor that scales a colour to 0..1. Integers of two bytes are fractions of 65535, all others
/// of 255.
double colour_scale(PlyType type) {
    if (type.kind == 'f') return 1;
    return type.bytes == 2 ? 1 / 65535.0 : 1 / 255.0;
}

const glm::vec3 no_colour(std::numeric_limits<float>::quiet_NaN());

bool has_all(const PlyElement& element, int first) {
    int found = 0;
    for (const PlyProperty& p : element.properties) {
        const int place = p.count ? -1 : place_of(p.name);
        if (place >= first && place < first + 3) found |= 1 << (place - first);
    }
    return found == 7;
}

template <class Body> class PlyReader {
public:
    PlyReader(const PlyHeader& header, Body body, Loading& loading, Warnings warnings)
        : header_(header), body_(body), loading_(loading), warnings_(std::move(warnings)) {
        for (const PlyElement& e : header.elements)
            if (e.name == "vertex") {
                vertices_ = e.count;
                mesh_.has_normals = has_all(e, 3);
            }
    }

    Scene read(const SourcePosition& at) {
        for (const PlyElement& element : header_.elements) elements(element);
        return scene_of(mesh_, at, loading_, std::move(warnings_));
    }

private:
    void elements(const PlyElement& element) {
        const bool is_vertex = element.name == "vertex", is_face = makes_faces(element);
        const bool has_colour = (is_vertex || is_face) && has_all(element, 6);
        std::vector<int> places;
        for (const PlyProperty& p : element.properties) {
            const int place = is_vertex || is_face ? place_of(p.name) : -1;
            places.push_back(is_face && place < 6 ? -1 : place);
        }
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            if (i % 65'536 == 0) loading_.report_progress("checking", i, element.count);
            body_.begin(element, i);
            has_fault_ = false;
            const std::size_t faces = mesh_.ends.size();
            for (std::size_t k = 0; k < element.properties.size(); ++k)
                if (const PlyProperty& property = element.properties[k]; property.count)
                    list(element, i, property, is_face && is_indices(property));
                else if (places[k] >= 0)
                    number(property, places[k]);
                else
                    body_.skip(property.type);
            body_.end(warnings_);
            glm::vec3 colour(row_[6], row_[7], row_[8]);
            if (has_colour && std::isfinite(colour.r + colour.g + colour.b) && clamp_colour(colour))
                warnings_.count(element.name, odd_colour, body_.line());
            if (has_colour && is_face) {
                mesh_.face_colours.resize(faces, no_colour);
                mesh_.face_colours.resize(mesh_.ends.size(), colour);
            }
            if (is_vertex) vertex(i, has_colour ? &colour : nullptr);
        }
    }

    void vertex(std::uint64_t i, const glm::vec3* colour) {
        if (has_fault_) mesh_.faults.push_back({static_cast<std::uint32_t>(i), body_.line()});
        mesh_.positions.emplace_back(row_[0], row_[1], row_[2]);
        if (mesh_.has_normals) {
            glm::vec3 normal(row_[3], row_[4], row_[5]);
            if (!std::isfinite(normal.x) || !std::isfinite(normal.y) || !std::isfinite(normal.z)) {
                warnings_.count("normal", "with components that are not finite, left out", body_.line());
                normal = glm::vec3(0);   // counts as missing
            }
            mesh_.normals.push_back(normal);
        }
        if (colour) mesh_.colours.push_back(*colour);
    }

    void number(const PlyProperty& property, int place) {
        const double value = body_.number(property.type);
        const bool fits = std::abs(value) <= std::numeric_limits<float>::max();
        has_fault_ = has_fault_ || (place < 3 && !fits);
        if (place >= 6 && !fits)
            warnings_.count("colour", "with a value that is not finite, left out", body_.line(),
                            property.name);
        const double scale = place < 6 ? 1 : colour_scale(property.type);
        row_[place] =
            static_cast<float>(fits || std::isnan(value) ? value * scale : std::copysign(HUGE_VAL, value));
    }

    void list(const PlyElement& element, std::uint64_t i, const PlyProperty& property, bool is_indices) {
        const double length = body_.number(*property.count);
        if (length < 0) body_.refuse(element, i, fmt::format("a list of {} entries", length));
        if (is_indices && element.name == "face") return face(element, i, property, length);
        if (is_indices) return strips(element, i, property, length);
        for (double k = 0; k < length; ++k) body_.skip(property.type);
    }

    std::uint32_t vertex_of(const PlyElement& element, std::uint64_t i, double index) const {
        if (!(index >= 0 && index < static_cast<double>(vertices_)))
            body_.refuse(element, i,
                         fmt::format("vertex index {} is out of range: the file has {} (0 is the first)",
                                     index, vertices_));
        return static_cast<std::uint32_t>(index);
    }

    void face(const PlyElement& element, std::uint64_t i, const PlyProperty& property, double length) {
        if (length > max_corners)
            body_.refuse(element, i,
                         fmt::format("a face with {} corners; the most is {}", length, max_corners));
        const bool is_kept = length >= 3;   // faces with fewer corners are points and lines
        for (double k = 0; k < length; ++k)
            if (is_kept)
                mesh_.indices.push_back(vertex_of(element, i, body_.number(property.type)));
            else
                body_.skip(property.type);
        if (is_kept) add_triangles(element, i, static_cast<std::uint64_t>(length) - 2);
    }

    /// Reads strips: from the third vertex on, each vertex makes a triangle with the two before it. Every
    /// second triangle is reversed. A negative number ends a strip.
    void strips(const PlyElement& element, std::uint64_t i, const PlyProperty& property, double length) {
        const double none = property.type.kind == 'u' ? std::exp2(8.0 * double(property.type.bytes)) - 1 : -1;
        std::uint32_t a = 0, b = 0;
        std::uint64_t corners = 0;
        for (double k = 0; k < length; ++k) {
            const double index = body_.number(property.type);
            if (index < 0 || index == none) {
                corners = 0;
                continue;
            }
            const std::uint32_t c = vertex_of(element, i, index);
            if (++corners > 2) {
                const bool is_even = corners % 2 != 0;
                mesh_.indices.insert(mesh_.indices.end(), {is_even ? a : b, is_even ? b : a, c});
                add_triangles(element, i, 1);
            }
            a = b, b = c;
        }
    }

    void add_triangles(const PlyElement& element, std::uint64_t i, std::uint64_t count) {
        mesh_.end_face();
        triangles_ += count;
        if (triangles_ > max_triangles)
            body_.refuse(element, i, fmt::format("more than {} triangles", max_triangles));
    }

    const PlyHeader& header_;
    Body body_;
    Loading& loading_;
    std::uint64_t vertices_ = 0, triangles_ = 0;
    float row_[9] = {};
    bool has_fault_ = false;   ///< of the vertex that is being read
    Warnings warnings_;
    IndexedMesh mesh_;
};

}   // namespace

Scene read_ply(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    const SourcePosition at{path.string()};
    Warnings warnings(at.file);
    const PlyHeader header = read_ply_header(at.file, bytes, warnings);
    const std::string_view rest = std::string_view(bytes).substr(header.bytes);
    if (header.form == PlyForm::ascii)
        return PlyReader(header, TextBody(header, rest, at.file), loading, warnings).read(at);
    return PlyReader(header, BinaryBody(header, rest, at.file), loading, warnings).read(at);
}

}   // namespace rayclock
