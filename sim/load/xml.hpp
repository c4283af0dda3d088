#pragma once
// An XML document as a tree, read by expat.
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/text.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// An element. Line breaks in its text have become blanks.
struct XmlElement {
    std::string name, text;
    std::map<std::string, std::string> attributes;
    std::vector<XmlElement> children;
    std::uint64_t line = 0;

    const XmlElement* find(std::string_view child) const;   ///< the first of that name, null if none
    std::vector<const XmlElement*> all(std::string_view child) const;
    /// find() along a path: "technique_common/accessor".
    const XmlElement* at(std::string_view path) const;
    std::string attribute(const std::string& key) const;   ///< empty if it is not there
};

/// Refused with their lines: wrong syntax, a document type (whose entities may grow without end), elements
/// deeper in each other than a document needs.
XmlElement parse_xml(const std::string& file, std::string_view text, Loading& loading);

}   // namespace rayclock
