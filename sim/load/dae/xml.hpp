#pragma once
// Reading an XML document into a tree by Expat.
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/text.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// An element. Line breaks in its text are replaced by blanks.
struct XmlElement {
    std::string name, text;
    std::map<std::string, std::string> attributes;
    std::vector<XmlElement> children;
    std::uint64_t line = 0;

    const XmlElement* find(std::string_view child) const;   ///< the first of that name, or null
    std::vector<const XmlElement*> all(std::string_view child) const;
    /// Applies find() along a path: "technique_common/accessor".
    const XmlElement* at(std::string_view path) const;
    std::string attribute(const std::string& key) const;   ///< empty if it is missing
};

/// Parses a document. Throws UserError with the line for wrong syntax and for elements that are nested too
/// deeply. Also throws it for a document type, whose entities may grow without bound.
XmlElement parse_xml(const std::string& file, std::string_view text, Loading& loading);

}   // namespace rayclock
