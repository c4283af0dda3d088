#pragma once
// A COLLADA document: its ids and numbers, and the unit and axes of each element.
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/load/dae/xml.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// Points in an array, as the accessor of a source describes them: x, y, z in space, or s, t on a picture.
/// The document owns the array.
struct DaePoints {
    const std::vector<float>* numbers = nullptr;
    std::uint64_t first = 0, stride = 3, count = 0;
    std::array<std::uint64_t, 3> part{0, 1, 2};   ///< offsets of the numbers in an entry

    glm::dvec3 operator[](std::uint64_t i) const {
        const float* const entry = numbers->data() + first + i * stride;
        return {entry[part[0]], entry[part[1]], entry[part[2]]};
    }
    glm::dvec2 on_picture(std::uint64_t i) const {
        const float* const entry = numbers->data() + first + i * stride;
        return {entry[part[0]], entry[part[1]]};
    }
};

/// Access to a document. All functions throw UserError with file and line if the document is wrong.
class DaeDocument {
public:
    /// The caller must keep `top` and `loading` alive.
    DaeDocument(const XmlElement& top, std::string file, Loading& loading);

    const XmlElement& top() const { return top_; }
    const std::string& file() const { return file_; }
    Loading& loading() const { return loading_; }
    [[noreturn]] void refuse(const XmlElement& where, const std::string& sentence) const;
    /// Charges bytes to the file's memory allowance. Throws UserError if it is used up.
    void charge(std::uint64_t bytes) const;

    /// Returns the element that "#id" names, or null if the file has none.
    const XmlElement* find(const std::string& url) const;
    const XmlElement* with_id(const std::string& id) const;
    /// Returns the element that an attribute names. Throws UserError if the file has none.
    const XmlElement& target(const XmlElement& in, const char* key) const;

    /// Returns the numbers of an element's text. Throws UserError if one is not finite.
    std::vector<float> finite(const XmlElement& in) const;
    /// Throws UserError if there are not `count` numbers.
    std::vector<float> finite(const XmlElement& in, std::size_t count) const;
    /// Returns the numbers of an array, which may include NaN. Reads each array once, however many sources
    /// share it.
    const std::vector<float>& array(const XmlElement& in);
    /// Returns the whole number in an attribute, or `otherwise` if it is missing. Throws UserError if it is
    /// negative or larger than 2^32.
    std::uint64_t whole(const XmlElement& in, const char* key, std::uint64_t otherwise) const;

    /// Returns the position of an input's index among the indices of a corner.
    std::uint64_t offset(const XmlElement& input) const;

    /// Returns the points of the source that an input names. `width`: how many numbers a point has, 2 or 3.
    const DaePoints& points(const XmlElement& input, std::uint64_t width = 3);
    /// Returns the array of words (names, ids) or numbers that a source's accessor names.
    const XmlElement& array_of(const XmlElement& source) const;

    /// Returns the matrix that turns and scales coordinates of `inner` into those of `outer`, from their
    /// <asset>s.
    glm::dmat4 into(const XmlElement& outer, const XmlElement& inner) const;
    /// Returns the rotation of the document's up axis to y.
    glm::dmat4 up() const { return frames_.front().turn; }

private:
    struct Frame {
        glm::dmat4 turn{1};
        double metres = 1;
    };
    void collect(const XmlElement& element, std::uint32_t frame);
    Frame frame(const XmlElement& asset, Frame inherited) const;
    DaePoints read_points(const XmlElement& source, std::uint64_t width);
    /// Replaces a decimal comma by a point: some programs write numbers in the user's locale.
    std::string_view with_point(std::string_view word) const;

    const XmlElement& top_;
    std::string file_;
    Loading& loading_;
    mutable std::string commas_;   ///< the last word with a comma; the result of with_point() refers to it
    std::map<std::string, const XmlElement*> by_id_;
    std::map<const XmlElement*, std::vector<float>> arrays_;
    std::map<std::pair<const XmlElement*, std::uint64_t>, DaePoints> points_;   // by source and width
    std::vector<Frame> frames_;                             // the first is the document's own
    std::map<const XmlElement*, std::uint32_t> frame_of_;   // only elements in other frames than the first
};

}   // namespace rayclock
