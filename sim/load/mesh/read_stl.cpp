// STL, text and binary. Many binary files begin with "solid" too. So the length decides, which must match the
// count of facets, and so do the bytes of the count, which no text holds. Normals are ignored, because they
// only repeat the facets.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "sim/files/text.hpp"
#include "sim/load/mesh/mesh_file.hpp"

namespace rayclock {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read in place");

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

std::uint32_t binary_count(const std::string& bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    return count;
}

using Corners = std::vector<glm::vec3>;

Corners binary_corners(const std::string& bytes, const SourcePosition& at, const Loading& loading) {
    if (bytes.size() < header_bytes)
        at.refuse(fmt::format("this is not STL: {} bytes are too few", bytes.size()));
    const std::uint32_t count = binary_count(bytes);
    const std::uint64_t needed = header_bytes + facet_bytes * std::uint64_t{count};
    if (bytes.size() < needed)
        at.refuse(fmt::format("the file is cut off, or not STL: {} triangles take {} bytes and there are {}",
                              count, needed, bytes.size()));
    if (count == 0) at.refuse("the file has no triangles");
    if (count > max_triangles) at.refuse(fmt::format("{} triangles; the most is {}", count, max_triangles));
    Corners corners;
    corners.reserve(3 * std::size_t{count});
    for (std::uint32_t t = 0; t < count; ++t) {
        if (t % 65'536 == 0) loading.report_progress("checking", t, count);
        float corner[9];
        std::memcpy(corner, bytes.data() + header_bytes + facet_bytes * std::size_t{t} + 12, sizeof corner);
        for (const float x : corner)
            if (!std::isfinite(x))
                at.refuse(
                    fmt::format("triangle {} has the coordinate {}, which is not a finite number", t, x));
        for (const int k : {0, 3, 6}) corners.emplace_back(corner[k], corner[k + 1], corner[k + 2]);
    }
    return corners;
}

/// Reads the text form in one pass: facet (normal) / outer loop / three of vertex / endloop / endfacet.
class TextStl {
public:
    TextStl(std::string_view text, const SourcePosition& at) : text_(text), at_(at), warnings_(at.file) {}

    Corners read(Loading& loading) {
        for (std::string_view rest = text_; !rest.empty();) {
            if (++at_.line % 65'536 == 0)
                loading.report_progress("checking", text_.size() - rest.size(), text_.size());
            line(take_line(rest));
        }
        if (state_ != State::outside) at_.refuse("the file is cut off: endsolid is missing");
        at_.line = 0;
        if (facets_ == 0) at_.refuse("the file has no triangles");
        warnings_.say(loading);
        return std::move(corners_);
    }

private:
    enum class State { outside, solid, facet, loop, after_loop };

    void line(std::string_view rest) {
        check_text(rest, at_, "STL");
        const std::string_view word = take_word(rest);
        if (word.empty()) return;
        const std::string key = lower(word);
        if (key == "solid" && state_ == State::outside)
            state_ = State::solid;
        else if (key == "endsolid" && state_ == State::solid)
            state_ = State::outside;
        else if (key == "facet" && state_ == State::solid)
            facet(rest);
        else if (key == "outer" && state_ == State::facet)
            expect(rest, "loop", State::loop);
        else if (key == "vertex" && state_ == State::loop)
            vertex(rest);
        else if (key == "endloop" && state_ == State::loop)
            endloop();
        else if (key == "endfacet" && state_ == State::after_loop)
            endfacet();
        else if (is_keyword(key) || state_ == State::loop || state_ == State::after_loop)
            at_.refuse(shown(word) + " is out of place in a text STL");
        else   // for example colours
            warnings_.count("line", "skipped: STL has no such statement", at_.line, word);
    }

    static bool is_keyword(std::string_view key) {
        constexpr std::array<std::string_view, 7> known{"solid",  "endsolid", "facet",   "outer",
                                                        "vertex", "endloop",  "endfacet"};
        return std::find(known.begin(), known.end(), key) != known.end();
    }

    void expect(std::string_view& rest, std::string_view wanted, State next) {
        const std::string_view word = take_word(rest);
        if (lower(word) != wanted) at_.refuse(fmt::format("'{}' expected, not {}", wanted, shown(word)));
        state_ = next;
    }

    void facet(std::string_view rest) {
        expect(rest, "normal", State::facet);
        first_ = corners_.size();
    }

    void vertex(std::string_view rest) {
        glm::vec3 corner(0);
        for (int i = 0; i < 3; ++i) corner[i] = static_cast<float>(finite_number(take_word(rest), at_));
        if (const std::string_view more = take_word(rest); !more.empty())
            warnings_.count("line", "with more than three coordinates; the rest is skipped", at_.line, more);
        corners_.push_back(corner);
    }

    void endloop() {
        if (const std::size_t count = corners_.size() - first_; count != 3)
            at_.refuse(fmt::format("a facet with {} vertices instead of 3", count));
        state_ = State::after_loop;
    }

    void endfacet() {
        state_ = State::solid;
        if (++facets_ > max_triangles) at_.refuse(fmt::format("more than {} triangles", max_triangles));
    }

    std::string_view text_;
    SourcePosition at_;
    State state_ = State::outside;
    std::size_t first_ = 0;   ///< first corner of the current facet
    std::uint32_t facets_ = 0;
    Corners corners_;
    Warnings warnings_;
};

/// Returns true if the file is binary: the count has a byte that text lacks. Without such a byte it would
/// count at least 150 million facets, more than `max_triangles`.
bool is_binary(const std::string& bytes) {
    const std::size_t start = bytes.find_first_not_of(" \t\r\n");
    if (start == bytes.npos || lower(std::string_view(bytes).substr(start, 5)) != "solid") return true;
    if (bytes.size() < header_bytes) return false;
    if (bytes.size() == header_bytes + facet_bytes * std::uint64_t{binary_count(bytes)}) return true;
    return std::any_of(bytes.begin() + 80, bytes.begin() + header_bytes, [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\r' && c != '\n';
    });
}

}   // namespace

Scene read_stl(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    const SourcePosition at{path.string()};
    const Corners corners =
        is_binary(bytes) ? binary_corners(bytes, at, loading) : TextStl(bytes, at).read(loading);
    Assembly assembly(at.file, loading);
    PartBuilder builder(corners.size() / 3, false);
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
        builder.add({glm::dvec3(corners[k])}, {glm::dvec3(corners[k + 1])}, {glm::dvec3(corners[k + 2])}, 0);
    assembly.place(assembly.add(std::move(builder)), glm::dmat4(1), 0,
                   [] { return Material{.name = "default"}; });
    return assembly.take();
}

}   // namespace rayclock
