// Parsing and checking of PLY headers.
#include "sim/load/mesh/ply_header.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "sim/files/text.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {
namespace {

PlyType type_of(std::string_view word, const SourcePosition& at) {
    static const std::map<std::string_view, PlyType> types{
        {"char", {1, 'i'}},  {"int8", {1, 'i'}},    {"uchar", {1, 'u'}},  {"uint8", {1, 'u'}},
        {"short", {2, 'i'}}, {"int16", {2, 'i'}},   {"ushort", {2, 'u'}}, {"uint16", {2, 'u'}},
        {"int", {4, 'i'}},   {"int32", {4, 'i'}},   {"uint", {4, 'u'}},   {"uint32", {4, 'u'}},
        {"float", {4, 'f'}}, {"float32", {4, 'f'}}, {"double", {8, 'f'}}, {"float64", {8, 'f'}}};
    const auto found = types.find(word);
    if (found == types.end()) at.refuse(shown(word) + " is not a PLY type");
    return found->second;
}

PlyForm form_of(std::string_view rest, const SourcePosition& at) {
    const std::string_view word = take_word(rest);
    if (take_word(rest) != "1.0") at.refuse("only PLY version 1.0 is known");
    if (word == "ascii") return PlyForm::ascii;
    if (word == "binary_little_endian") return PlyForm::little_endian;
    if (word == "binary_big_endian") return PlyForm::big_endian;
    at.refuse(shown(word) + " is not a PLY format");
}

PlyElement element_of(std::string_view rest, const std::vector<PlyElement>& before,
                      const SourcePosition& at) {
    const std::string name(take_word(rest));
    const std::string_view word = take_word(rest);
    const std::int64_t count = whole_number(word, at);
    if (count < 0) at.refuse(fmt::format("{} elements of the kind '{}'", count, name));
    if (name == "vertex" && count > std::numeric_limits<std::uint32_t>::max())
        at.refuse(fmt::format("{} vertices, more than 2^32 - 1", count));
    if ((name == "face" || name == "tristrips") && static_cast<std::uint64_t>(count) > max_triangles)
        at.refuse(fmt::format("{} faces; the most is {}", count, max_triangles));
    for (const PlyElement& other : before)
        if (other.name == name) at.refuse(fmt::format("'{}' is declared twice", name));
    return {name, static_cast<std::uint64_t>(count), {}};
}

PlyProperty property_of(std::string_view rest, const SourcePosition& at) {
    PlyProperty property{};
    std::string_view word = take_word(rest);
    if (word == "list") {
        property.count = type_of(take_word(rest), at);
        if (property.count->kind == 'f') at.refuse("the length of a list must be a whole number");
        word = take_word(rest);
    }
    property.type = type_of(word, at);
    property.name = take_word(rest);
    if (property.name.empty()) at.refuse("a property without a name");
    return property;
}

/// Throws UserError unless the elements make a mesh.
void check_mesh(const PlyHeader& header, const SourcePosition& at) {
    const auto named = [&](const std::string& name) {
        return [&name](const auto& e) { return e.name == name; };
    };
    const auto vertex = std::find_if(header.elements.begin(), header.elements.end(), named("vertex"));
    if (vertex == header.elements.end()) at.refuse("the header has no element 'vertex'");
    for (const std::string axis : {"x", "y", "z"}) {
        const auto& all = vertex->properties;
        const auto found = std::find_if(all.begin(), all.end(), named(axis));
        if (found == all.end() || found->count)
            at.refuse(fmt::format("vertices have no property '{}'", axis));
    }
    std::uint64_t faces = 0;
    bool has_faces = false;
    for (const PlyElement& element : header.elements) {
        if (!makes_faces(element)) continue;
        const auto& all = element.properties;
        if (std::count_if(all.begin(), all.end(), is_indices) != 1)
            at.refuse(element.name == "face" ? "faces need one list of whole numbers 'vertex_indices'"
                                             : "strips need one list of whole numbers 'vertex_indices'");
        has_faces = true;
        faces += element.count;
    }
    if (!has_faces) at.refuse("the header has no element 'face'");
    if (faces == 0) at.refuse("the file has no triangles");
}

/// Takes the next line of the header. If lines end in a carriage return alone, the byte after the last one
/// belongs to the data, even if it is a line feed.
std::string_view header_line(std::string_view& rest, bool ends_in_return) {
    if (!ends_in_return) return take_line(rest);
    const std::size_t end = std::min(rest.find('\r'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return line;
}

}   // namespace

bool makes_faces(const PlyElement& element) { return element.name == "face" || element.name == "tristrips"; }

bool is_indices(const PlyProperty& property) {
    return (property.name == "vertex_indices" || property.name == "vertex_index") && property.count &&
           property.type.kind != 'f';
}

PlyHeader read_ply_header(const std::string& file, std::string_view bytes, Warnings& warnings) {
    PlyHeader header{};
    SourcePosition at{file};
    std::string_view rest = bytes;
    bool has_form = false;
    const std::size_t first_end = bytes.find_first_of("\r\n");
    const bool ends_in_return =
        first_end != bytes.npos && bytes[first_end] == '\r' && bytes.substr(first_end + 1, 1) != "\n";
    while (true) {
        if (rest.empty() || at.line > 10'000) at.refuse("the header does not end: end_header is missing");
        std::string_view line = header_line(rest, ends_in_return);
        ++at.line;
        check_text(line.substr(0, 200), at, "PLY");
        const std::string_view key = take_word(line);
        if (at.line == 1) {
            if (key != "ply") at.refuse("this is not PLY: the first word is " + shown(key));
        } else if (key == "format") {
            header.form = form_of(line, at);
            has_form = true;
        } else if (key == "element") {
            header.elements.push_back(element_of(line, header.elements, at));
        } else if (key == "property") {
            if (header.elements.empty()) at.refuse("a property before the first element");
            auto& properties = header.elements.back().properties;
            properties.push_back(property_of(line, at));
            for (std::size_t i = 0; i + 1 < properties.size(); ++i)
                if (properties[i].name == properties.back().name)
                    at.refuse(fmt::format("'{}' is declared twice", properties[i].name));
        } else if (key == "end_header") {
            break;
        } else if (key != "comment" && key != "obj_info" && !key.empty()) {
            warnings.count("line", "skipped: a PLY header has no such line", at.line, key);
        }
    }
    if (!has_form) at.refuse("the header names no format");
    header.bytes = bytes.size() - rest.size();
    header.lines = at.line;
    check_mesh(header, SourcePosition{file});
    return header;
}

}   // namespace rayclock
