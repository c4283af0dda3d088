// OFF in text form: the header, the vertices, the faces. Leaves out the colours of vertices and faces, with a
// note. Blank lines and comments may appear anywhere.
#include <fmt/format.h>

#include "sim/files/text.hpp"
#include "sim/load/mesh/indexed.hpp"
#include "sim/load/mesh/mesh_file.hpp"

namespace rayclock {
namespace {

class OffReader {
public:
    OffReader(std::string_view text, const SourcePosition& at, Loading& loading)
        : rest_(without_mark(text)), bytes_(text.size()), at_(at), loading_(loading) {}

    Scene read() {
        header();
        for (std::uint64_t i = 0; i < vertices_; ++i) vertex(i);
        for (std::uint64_t i = 0; i < faces_; ++i) face(i);
        at_.line = 0;
        if (colours_) loading_.note(at_.file, "its colours are not drawn");
        return scene_of(mesh_, at_, loading_, Warnings(at_.file));
    }

private:
    /// Returns the next line with at least one word that is not a comment.
    std::string_view line(const char* wanted) {
        while (!rest_.empty()) {
            if (++at_.line % 65'536 == 0) loading_.report_progress("checking", bytes_ - rest_.size(), bytes_);
            const std::string_view whole = take_line(rest_);
            check_text(whole, at_, "OFF");
            std::string_view text = whole.substr(0, whole.find('#')), words = text;
            if (!take_word(words).empty()) return text;
        }
        at_.line = 0;
        at_.refuse(fmt::format("the file is cut off: {} is missing", wanted));
    }

    std::uint64_t count(std::string_view& words, const char* what) {
        const std::int64_t value = whole_number(take_word(words), at_);
        if (value < 0) at_.refuse(fmt::format("{} {}", value, what));
        return static_cast<std::uint64_t>(value);
    }

    void header() {
        const std::string_view whole = line("the header");
        std::string_view words = whole, keyword = take_word(words);
        // Files of the ModelNet data set lack the blank between the keyword and the first count.
        if (const std::size_t digit = keyword.find_first_of("0123456789");
            digit != keyword.npos && digit > 0) {
            words = whole.substr(static_cast<std::size_t>(keyword.data() - whole.data()) + digit);
            keyword = keyword.substr(0, digit);
        }
        const std::string kind = lower(keyword);
        if (kind != "off" && kind != "coff" && kind != "noff" && kind != "cnoff")
            at_.refuse(kind.ends_with("off") ? "OFF of the kind " + shown(keyword) +
                                                   " cannot be read, only OFF, "
                                                   "COFF, NOFF and CNOFF"
                                             : "this is not OFF: it begins with " + shown(keyword));
        mesh_.has_normals = kind.find('n') != kind.npos;
        std::string_view counts = words;
        const std::string_view next = take_word(counts);
        if (lower(next) == "binary") at_.refuse("binary OFF cannot be read, only text");
        // Many programs write the counts on the line of the keyword.
        counts = next.empty() ? line("the counts") : words;
        vertices_ = count(counts, "vertices");
        faces_ = count(counts, "faces");
        if (const std::string_view edges = take_word(counts); !edges.empty()) whole_number(edges, at_);
        // A vertex takes at least six characters and a face two. This check prevents an allocation for data
        // that cannot follow.
        if (vertices_ > rest_.size() / 6 + 1 || faces_ > rest_.size() / 2 + 1)
            at_.refuse(fmt::format("the file is cut off: {} vertices and {} faces do not fit in {} bytes",
                                   vertices_, faces_, bytes_));
    }

    void vertex(std::uint64_t index) {
        std::string_view words = line("a vertex");
        glm::vec3 position(0), normal(0);
        for (int i = 0; i < 3; ++i) position[i] = number(words, "vertex", index);
        if (mesh_.has_normals)
            for (int i = 0; i < 3; ++i) normal[i] = number(words, "vertex", index);
        colours_ |= !take_word(words).empty();
        mesh_.positions.push_back(position);
        if (mesh_.has_normals) mesh_.normals.push_back(normal);
    }
    float number(std::string_view& words, const char* what, std::uint64_t index) {
        const std::string_view word = take_word(words);
        if (word.empty()) at_.refuse(fmt::format("{} {} has too few numbers", what, index));
        return static_cast<float>(finite_number(word, at_));
    }

    void face(std::uint64_t index) {
        std::string_view words = line("a face");
        const std::uint64_t corners = count(words, "corners");
        if (corners > max_corners)
            at_.refuse(fmt::format("a face with {} corners; the most is {}", corners, max_corners));
        const std::size_t start = mesh_.indices.size();
        for (std::uint64_t k = 0; k < corners; ++k) {
            const std::string_view word = take_word(words);
            if (word.empty())
                at_.refuse(
                    fmt::format("face {} has {} corners, and {} of them are there", index, corners, k));
            const std::int64_t vertex = whole_number(word, at_);
            if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices_)
                at_.refuse(fmt::format("vertex index {} is out of range: the file has {} (0 is the first)",
                                       vertex, vertices_));
            mesh_.indices.push_back(static_cast<std::uint32_t>(vertex));
        }
        colours_ |= !take_word(words).empty();
        if (corners < 3) return mesh_.indices.resize(start);   // a point or a line
        if ((triangles_ += corners - 2) > max_triangles)
            at_.refuse(fmt::format("more than {} triangles", max_triangles));
        mesh_.end_face();
    }

    std::string_view rest_;
    std::size_t bytes_;
    SourcePosition at_;
    Loading& loading_;
    std::uint64_t vertices_ = 0, faces_ = 0, triangles_ = 0;
    bool colours_ = false;
    IndexedMesh mesh_;
};

}   // namespace

Scene read_off(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    return OffReader(bytes, {path.string()}, loading).read();
}

}   // namespace rayclock
