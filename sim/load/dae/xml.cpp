// Expat's callbacks, which build the tree.
#include "sim/load/dae/xml.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <expat.h>
#include <fmt/format.h>

namespace rayclock {
namespace {

/// Returns the current line. Newer releases of Expat have a function with a 64-bit result on all platforms,
/// and deprecate the old one.
template <class Parser> std::uint64_t line_of(Parser parser) {
    if constexpr (requires { XML_GetCurrentLineNumber64(parser); })
        return XML_GetCurrentLineNumber64(parser);
    else
        return XML_GetCurrentLineNumber(parser);
}

constexpr std::size_t max_nested_elements = 600;

/// The state of the parser. Expat is written in C, so no exception may cross it. stop() keeps the first error
/// and stops the parser.
struct Reading {
    XML_Parser parser;
    Loading* loading;
    XmlElement top;   // its only child is the document's element
    std::vector<XmlElement*> open{&top};
    std::optional<std::string> complaint;
    std::uint64_t line = 0;

    void stop(std::string sentence) {
        if (complaint) return;
        complaint = std::move(sentence);
        line = line_of(parser);
        XML_StopParser(parser, XML_FALSE);
    }
};

void begin_element(void* user, const XML_Char* name, const XML_Char** attributes) {
    Reading& r = *static_cast<Reading*>(user);
    if (r.complaint) return;
    if (r.open.size() > max_nested_elements)
        return r.stop(fmt::format("elements are nested deeper than {}", max_nested_elements));
    if (!r.loading->may_make(sizeof(XmlElement))) return r.stop(r.loading->too_much());
    XmlElement& element = r.open.back()->children.emplace_back();
    element.name = name;
    element.line = line_of(r.parser);
    for (; *attributes; attributes += 2) element.attributes.emplace(attributes[0], attributes[1]);
    r.open.push_back(&element);
}

void end_element(void* user, const XML_Char*) {
    Reading& r = *static_cast<Reading*>(user);
    if (!r.complaint) r.open.pop_back();
}

void take_text(void* user, const XML_Char* text, int length) {
    Reading& r = *static_cast<Reading*>(user);
    if (r.complaint) return;
    std::string& all = r.open.back()->text;
    for (const char c : std::string_view(text, std::size_t(length))) all += c == '\n' ? ' ' : c;
}

void refuse_type(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    static_cast<Reading*>(user)->stop("a document type is not taken");
}

}   // namespace

const XmlElement* XmlElement::find(std::string_view child) const {
    const auto found =
        std::find_if(children.begin(), children.end(), [&](const auto& c) { return c.name == child; });
    return found == children.end() ? nullptr : &*found;
}

std::vector<const XmlElement*> XmlElement::all(std::string_view child) const {
    std::vector<const XmlElement*> found;
    for (const XmlElement& c : children)
        if (c.name == child) found.push_back(&c);
    return found;
}

const XmlElement* XmlElement::at(std::string_view path) const {
    const std::size_t slash = path.find('/');
    const XmlElement* const child = find(path.substr(0, slash));
    return !child || slash == path.npos ? child : child->at(path.substr(slash + 1));
}

std::string XmlElement::attribute(const std::string& key) const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string{} : found->second;
}

XmlElement parse_xml(const std::string& file, std::string_view text, Loading& loading) {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(
        XML_ParserCreate(nullptr), XML_ParserFree);
    const SourcePosition at{file};
    if (!parser) at.refuse("cannot be read: no memory is left");
    Reading reading{parser.get(), &loading, {}, {}, {}, 0};
    reading.open = {&reading.top};
    XML_SetUserData(parser.get(), &reading);
    XML_SetElementHandler(parser.get(), begin_element, end_element);
    XML_SetCharacterDataHandler(parser.get(), take_text);
    XML_SetStartDoctypeDeclHandler(parser.get(), refuse_type);
    constexpr std::size_t piece = 1 << 20;
    for (std::size_t from = 0;; from += piece) {
        loading.report_progress("reading", std::min(from, text.size()), text.size());
        const std::string_view part = text.substr(std::min(from, text.size()), piece);
        const bool is_last = from + piece >= text.size();
        if (XML_Parse(parser.get(), part.data(), int(part.size()), is_last) == XML_STATUS_ERROR) {
            if (reading.complaint) SourcePosition{file, reading.line}.refuse(*reading.complaint);
            SourcePosition{file, line_of(parser.get())}.refuse(
                fmt::format("this is not XML: {}", XML_ErrorString(XML_GetErrorCode(parser.get()))));
        }
        if (is_last) break;
    }
    return std::move(reading.top.children.front());
}

}   // namespace rayclock
