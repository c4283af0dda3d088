// A COLLADA document: what its ids and numbers mean, and in which unit and axes each of its elements stands.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "sim/load/loading.hpp"
#include "sim/load/xml.hpp"

namespace rayclock {

/// Triples of numbers in an array, found by the accessor of a source. It shares the array with its document.
struct DaeTriples {
    const std::vector<float>* numbers = nullptr;
    std::uint64_t first = 0, stride = 3, count = 0;
    std::array<std::uint64_t, 3> part{0, 1, 2};   ///< where x, y and z lie in an entry

    glm::dvec3 operator[](std::uint64_t i) const {
        const float* const entry = numbers->data() + first + i * stride;
        return {entry[part[0]], entry[part[1]], entry[part[2]]};
    }
};

class DaeDocument {
public:
    /// `top` and `loading` must outlive it.
    DaeDocument(const XmlElement& top, std::string file, Loading& loading);

    const XmlElement& top() const { return top_; }
    const std::string& file() const { return file_; }
    Loading& loading() const { return loading_; }
    [[noreturn]] void refuse(const XmlElement& where, const std::string& sentence) const;
    /// Counts bytes against what the file may make of itself.
    void charge(std::uint64_t bytes) const;

    /// The element that "#id" names, null if the file has none.
    const XmlElement* find(const std::string& url) const;
    const XmlElement* with_id(const std::string& id) const;
    /// The same for an attribute; refused if the file has none.
    const XmlElement& target(const XmlElement& in, const char* key) const;

    /// The numbers of an element's text, all finite.
    std::vector<float> finite(const XmlElement& in) const;
    std::vector<float> finite(const XmlElement& in, std::size_t count) const;   ///< refused if not so many
    /// The numbers of an array, NaN included. Each array is read once, however many sources share it.
    const std::vector<float>& array(const XmlElement& in);
    /// A whole number in an attribute that must not be negative.
    std::uint64_t whole(const XmlElement& in, const char* key, std::uint64_t otherwise) const;

    /// Where an input's number stands among those of a corner.
    std::uint64_t offset(const XmlElement& input) const;

    /// The source that an input names.
    const DaeTriples& triples(const XmlElement& input);
    /// The accessor's array of words (names, ids) or of numbers.
    const XmlElement& array_of(const XmlElement& source) const;

    /// What turns and scales the coordinates of `inner` into those of `outer`, from their <asset>s.
    glm::dmat4 into(const XmlElement& outer, const XmlElement& inner) const;
    /// Turns the document's up axis to y.
    glm::dmat4 up() const { return frames_.front().turn; }

private:
    struct Frame {
        glm::dmat4 turn{1};
        double metres = 1;
    };
    void collect(const XmlElement& element, std::uint32_t frame);
    Frame frame(const XmlElement& asset, Frame inherited) const;
    DaeTriples read_triples(const XmlElement& source);
    /// The word with a point in place of a decimal comma, as programs of some countries write it.
    std::string_view with_point(std::string_view word) const;

    const XmlElement& top_;
    std::string file_;
    Loading& loading_;
    mutable std::string commas_;   ///< the last word that had one
    std::map<std::string, const XmlElement*> by_id_;
    std::map<const XmlElement*, std::vector<float>> arrays_;
    std::map<const XmlElement*, DaeTriples> triples_;       // by source
    std::vector<Frame> frames_;                             // the document's is the first
    std::map<const XmlElement*, std::uint32_t> frame_of_;   // where it is not the first
};

}   // namespace rayclock
