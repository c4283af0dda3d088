// OBJ: checks every statement and reports errors with their line. Reads positions, normals, faces, the
// materials of faces with their pictures, and the colours of vertices. Drops groups, objects, curves, points
// and lines. Keeps faces in the order of the file.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "sim/files/input.hpp"
#include "sim/files/text.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

/// Statements of the format that do not affect triangles.
constexpr std::array<std::string_view, 33> silent{
    "vp",         "g",         "o",     "s",     "p",        "l",        "mg",   "cstype", "deg",
    "bmat",       "step",      "curv",  "curv2", "surf",     "parm",     "trim", "hole",   "scrv",
    "sp",         "end",       "con",   "bevel", "c_interp", "d_interp", "lod",  "maplib", "usemap",
    "shadow_obj", "trace_obj", "ctech", "stech", "call",     "csh"};

/// The continuation of a warning about a statement that OBJ does not have, which is an extension of some
/// program or an error.
constexpr std::string_view unknown_statement = "skipped: OBJ has no such statement";

/// Counts one kind of element and resolves indices to it. An index may refer to a later line, so finish()
/// checks indices against the final count.
class Counted {
public:
    explicit Counted(std::string_view what) : what_(what) {}
    void add(const SourcePosition& at) {
        if (++count_ > std::numeric_limits<std::uint32_t>::max())
            at.refuse(fmt::format("more than 2^32 - 1 {} lines", what_));
    }
    std::uint64_t count() const { return count_; }
    std::uint64_t absolute(std::string_view word, const SourcePosition& at) {
        const std::int64_t index = whole_number(word, at);
        if (index == 0) at.refuse(fmt::format("{} index 0: indices start at 1", what_));
        if (index < 0 && static_cast<std::uint64_t>(-(index + 1)) >= count_)
            at.refuse(fmt::format("{} index {} reaches before the first of {}", what_, index, count_));
        if (index < 0) return count_ - static_cast<std::uint64_t>(-(index + 1));
        // The first index beyond the final count is also a new maximum, so maxima are all that is kept.
        const auto forward = static_cast<std::uint64_t>(index);
        if (forward > count_ && (maxima_.empty() || forward > maxima_.back().index))
            maxima_.push_back({forward, at.line});
        return forward;
    }
    /// Resolves an index that may refer to nothing. Such an index becomes 0 or a number above the final
    /// count.
    std::uint32_t absolute_or_none(std::string_view word, const SourcePosition& at) const {
        const std::int64_t index = whole_number(word, at);
        if (index < 0 && static_cast<std::uint64_t>(-(index + 1)) >= count_) return 0;
        if (index < 0) return static_cast<std::uint32_t>(count_ - static_cast<std::uint64_t>(-(index + 1)));
        return static_cast<std::uint32_t>(
            std::min<std::int64_t>(index, std::numeric_limits<std::uint32_t>::max()));
    }
    void finish(const std::string& file) const {
        for (const auto& [index, line] : maxima_)
            if (index > count_)
                SourcePosition{file, line}.refuse(
                    fmt::format("{} index {} is out of range: the file has {}", what_, index, count_));
    }

private:
    struct Forward {
        std::uint64_t index, line;
    };
    std::string_view what_;
    std::uint64_t count_ = 0;
    std::vector<Forward> maxima_;
};

/// Reads three numbers. Returns nothing if one is missing or not finite as a 32-bit float.
std::optional<glm::vec3> triple(std::string_view& rest) {
    glm::vec3 point(0);
    for (int i = 0; i < 3; ++i) {
        const std::optional<float> value = float_of(take_word(rest));
        if (!value) return std::nullopt;
        point[i] = *value;
    }
    return point;
}

/// Throws UserError that explains why triple() rejected a line.
[[noreturn]] void refuse_triple(std::string_view key, std::string_view rest, const SourcePosition& at) {
    int count = 0;
    for (std::string_view word = take_word(rest); !word.empty() && count < 3; word = take_word(rest), ++count)
        finite_number(word, at);
    at.refuse(fmt::format("{} needs 3 numbers and has {}", key, count));
}

class ObjReader {
public:
    ObjReader(const std::filesystem::path& path, Loading& loading)
        : path_(path),
          at_{path.string()},
          loading_(loading),
          warnings_(at_.file),
          pictures_(at_.file, "material file", loading) {}

    void statement(std::string_view line, std::uint64_t number) {
        at_.line = number;
        std::string_view rest = line.substr(0, line.find('#'));
        const std::string_view key = take_word(rest);
        if (key.empty()) return check_text(line, at_, "OBJ");
        if (key == "v")
            vertex(rest);
        else if (key == "vn")
            normal(rest);
        else if (key == "vt")
            texture_vertex(rest, line);
        else if (key == "f" || key == "fo")
            face(rest);
        else if (key == "usemtl")
            material(rest);
        else if (key == "mtllib")
            library(rest);
        else if (std::find(silent.begin(), silent.end(), key) == silent.end())
            unknown(line, key);
        else
            check_text(line, at_, "OBJ");
    }

    /// Checks the whole file. Call it after the last statement, before the text is freed.
    void check_end() {
        at_.line = 0;
        vertices_.finish(at_.file);
        if (ends_.empty() && unknown_.line > 0) refuse_unknown();
        if (ends_.empty()) at_.refuse("the file has no triangles");
        check_positions();
        for (Run& run : runs_) run.is_smooth = false;
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            const std::size_t begin = corner_of_face(runs_[i].first_face),
                              end = corner_of_face(end_of_run(i));
            for (std::size_t k = begin; k < end; ++k) check_normal(corners_[k], runs_[i]);
        }
    }

    ObjShape finish_shape() {
        warnings_.say(loading_);
        ObjShape shape{{}, {}, {}, {}, {}, read_materials(), {}};
        shape.textures = std::move(textures_);
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            shape.materials.resize(end_of_run(i), static_cast<std::uint32_t>(runs_[i].material));
        }
        shape.positions = std::move(positions_), shape.normals = std::move(directions_);
        for (std::size_t i = 0; i < runs_.size(); ++i)
            for (std::size_t f = runs_[i].first_face; f < end_of_run(i); ++f)
                for (std::size_t k = corner_of_face(f); k < ends_[f]; ++k)
                    shape.corners.push_back({corners_[k].position, corners_[k].normal,
                                             coordinates_of(k, f, shape.known[runs_[i].material])});
        shape.ends = std::move(ends_);
        return shape;
    }

    Scene finish() {
        const std::vector<Material> materials = read_materials();
        Assembly assembly(at_.file, loading_);
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            loading_.report_progress("joining", i, runs_.size());
            assembly.add(part(i, assembly, materials[runs_[i].material]));
        }
        assembly.make_alike();
        for (std::size_t i = 0; i < runs_.size(); ++i)
            assembly.place(i, glm::dmat4(1), runs_[i].material, [&] { return materials[runs_[i].material]; });
        Scene scene = assembly.take();
        scene.textures = std::move(textures_);
        warnings_.say(loading_);
        return scene;
    }

private:
    /// Consecutive faces with the same material.
    struct Run {
        std::size_t first_face, material;
        bool is_smooth = false;
    };
    /// A corner by numbers from 1. If it has no texture coordinates, `texture` is 0 or above the final count.
    struct Index {
        std::uint32_t position = 0, normal = 0, texture = 0;
    };
    /// The number of a corner for which the face names no normal.
    static constexpr std::uint32_t no_normal = std::numeric_limits<std::uint32_t>::max();

    /// A vertex whose position cannot be read, and the words after its `v`.
    /// The same for texture coordinates, after `vt`.
    struct Fault {
        std::uint32_t index;   ///< counted from 1
        std::uint64_t line;
        std::string_view rest;   ///< refers to the text; valid until check_end()
    };

    std::size_t end_of_run(std::size_t run) const {
        return run + 1 < runs_.size() ? runs_[run + 1].first_face : ends_.size();
    }
    std::size_t corner_of_face(std::size_t face) const { return face == 0 ? 0 : ends_[face - 1]; }

    /// Throws UserError if a face uses a vertex whose position cannot be read. Counts unused ones.
    void check_positions() {
        if (faults_.empty()) return;
        const auto by_index = [](const Fault& fault, std::uint32_t index) { return fault.index < index; };
        for (const Index& corner : corners_) {
            const auto fault = std::lower_bound(faults_.begin(), faults_.end(), corner.position, by_index);
            if (fault != faults_.end() && fault->index == corner.position)
                refuse_triple("v", fault->rest, SourcePosition{at_.file, fault->line});
        }
        for (const Fault& fault : faults_)
            warnings_.count("unused vertex", "with coordinates that are not finite, left out", fault.line,
                            joined_words(fault.rest));
    }

    void check_normal(Index& corner, Run& run) {
        if (corner.normal == no_normal) {
            corner.normal = 0;
        } else if (corner.normal == 0 || corner.normal > directions_.size()) {
            warnings_.count("corner", "with a normal that is not in the file, drawn flat", 0,
                            std::to_string(corner.normal));
            corner.normal = 0;
        } else {
            run.is_smooth = true;
        }
    }

    void vertex(std::string_view rest) {
        vertices_.add(at_);
        const std::string_view all = rest;
        const std::optional<glm::vec3> place = triple(rest);
        if (!place) faults_.push_back({static_cast<std::uint32_t>(vertices_.count()), at_.line, all});
        positions_.push_back(place.value_or(glm::vec3(0)));
        vertex_colour(rest);
    }

    /// Reads the colour of a vertex: three numbers after the position. A single number there is a weight,
    /// which is ignored.
    void vertex_colour(std::string_view rest) {
        std::string_view words = rest;
        int count = 0;
        while (count < 3 && !take_word(words).empty()) ++count;
        std::optional<glm::vec3> colour;
        if (count == 3) {
            const std::string_view given = rest;
            colour = triple(rest);
            if (!colour)
                warnings_.count("vertex", "with a colour that is not finite, drawn without it", at_.line,
                                joined_words(given));
        }
        if (colour && clamp_colour(*colour)) warnings_.count("vertex", odd_colour, at_.line);
        if (!colour && colours_.empty()) return;
        colours_.resize(positions_.size());
        colours_.back() = colour;
    }

    /// Reads a normal. A normal that is zero or not finite counts as missing.
    void normal(std::string_view rest) {
        normals_.add(at_);
        const std::string_view all = rest;
        const std::optional<glm::vec3> direction = triple(rest);
        if (!direction)
            warnings_.count("normal", "with components that are not finite, left out", at_.line,
                            joined_words(all));
        directions_.push_back(direction.value_or(glm::vec3(0)));
    }

    /// Reads texture coordinates. An invalid number is an error only if a textured face uses it.
    void texture_vertex(std::string_view rest, std::string_view line) {
        check_text(line, at_, "OBJ");
        if (!loading_.draws_textures()) return;
        if (coordinates_.size() == std::numeric_limits<std::uint32_t>::max()) return;
        const std::string words = joined_words(rest);
        const std::optional<float> s = float_of(take_word(rest));
        const std::string_view second = take_word(rest);
        const std::optional<float> t = second.empty() ? 0.0f : float_of(second);
        if (!s || !t)
            texture_faults_.push_back({static_cast<std::uint32_t>(coordinates_.size() + 1), at_.line, words});
        coordinates_.emplace_back(s.value_or(0), t.value_or(0));
        coordinate_count_.add(at_);
    }

    void face(std::string_view rest) {
        const std::size_t start = corners_.size();
        if (runs_.empty()) use("default");
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) corner(word);
        const std::size_t corners = corners_.size() - start;
        if (corners > max_corners)
            at_.refuse(fmt::format("a face with {} corners; the most is {}", corners, max_corners));
        if (corners < 3) {   // a point or a line
            corners_.resize(start);
            return;
        }
        if ((triangles_ += corners - 2) > max_triangles)
            at_.refuse(fmt::format("more than {} triangles", max_triangles));
        ends_.push_back(corners_.size());
    }

    void corner(std::string_view word) {
        const std::size_t first = word.find('/');
        const std::size_t second = first == word.npos ? word.npos : word.find('/', first + 1);
        Index index{static_cast<std::uint32_t>(vertices_.absolute(word.substr(0, first), at_)), no_normal};
        if (first != word.npos) {
            const std::string_view texture = word.substr(first + 1, second - first - 1);
            if (!texture.empty()) index.texture = coordinate_count_.absolute_or_none(texture, at_);
        }
        if (second != word.npos && second + 1 != word.size())
            index.normal = std::min(normals_.absolute_or_none(word.substr(second + 1), at_), no_normal - 1);
        corners_.push_back(index);
    }

    void material(std::string_view rest) {
        const std::string name = joined_words(rest);
        check_text(name, at_, "OBJ");
        use(name.empty() ? "default" : name);   // some exporters omit the name
    }

    void use(const std::string& name) {
        const auto [found, ignored] = used_.try_emplace(name, used_.size());
        const bool is_open = !runs_.empty() && runs_.back().first_face == ends_.size();
        if (is_open)
            runs_.back().material = found->second;
        else if (runs_.empty() || runs_.back().material != found->second)
            runs_.push_back({ends_.size(), found->second});
    }

    void library(std::string_view rest) {
        check_text(rest, at_, "OBJ");
        // One name with blanks or several names: check whether a file of the whole name exists.
        const std::string whole = joined_words(rest);
        std::error_code ignored;
        if (std::filesystem::exists(path_.parent_path() / whole, ignored))
            return libraries_.push_back({whole, at_.line});
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
            libraries_.push_back({std::string(word), at_.line});
    }

    /// Reads the material files. Meshes often travel without them, so a missing file only causes a note.
    std::map<std::string, MtlBlock> read_libraries() {
        std::map<std::string, MtlBlock> defined;
        std::set<std::string> done;
        for (const auto& [name, line] : libraries_) {
            if (!done.insert(name).second) continue;
            const std::filesystem::path path = path_.parent_path() / name;
            const std::string from = fmt::format("{}: line {}", at_.file, line);
            std::error_code ignored;
            if (std::filesystem::status(path, ignored).type() == std::filesystem::file_type::not_found) {
                loading_.note(from, "the material file " + printable(path.string()) +
                                        " does not exist; its materials are grey");
                continue;
            }
            if (leaves_folder(name))
                loading_.note(from,
                              "the material file " + shown(name) + " lies outside the folder of the mesh");
            Warnings unused(path.string());
            for (MtlBlock& block : read_mtl(path, loading_.read(path, from), loading_)) {
                block.folder = path.parent_path();
                if (!block.fault.empty() && !used_.contains(block.name))
                    unused.count("unused material", "with values that make no sense, left out", 0,
                                 block.name);
                defined.try_emplace(block.name, std::move(block));
            }
            unused.say(loading_);
        }
        return defined;
    }

    /// Returns the colour of materials that the file lacks: white if vertices have colours, which then show
    /// unchanged.
    glm::vec3 unknown_colour() const { return glm::vec3(colours_.empty() ? 0.8f : 1.0f); }

    /// Returns the texture of a material, or nothing if its picture cannot be read.
    std::optional<std::uint32_t> texture_of(const MtlBlock& block) {
        if (!block.picture) return std::nullopt;
        const MtlPicture& map = *block.picture;
        const auto pyramid = pictures_.pyramid(block.folder, map.file);
        if (!pyramid) return std::nullopt;
        for (const std::string& option : map.ignored)
            warnings_.count("option", "of map_Kd ignored", 0, option);
        const Wrap wrap = map.clamps ? Wrap::clamp : Wrap::repeat;
        textures_.push_back({printable(map.file, 80), pyramid, wrap, wrap});
        mappings_.push_back({map.scale, map.offset});
        return static_cast<std::uint32_t>(textures_.size() - 1);
    }

    /// Returns all materials in use. The first definition of a name counts. An undefined material is plain
    /// grey.
    std::vector<Material> read_materials() {
        const std::map<std::string, MtlBlock> defined = read_libraries();
        if (!loading_.may_make(used_.size() * sizeof(Material))) at_.refuse(loading_.too_much());
        std::vector<Material> materials(used_.size());
        for (const auto& [name, number] : used_) {
            const auto found = defined.find(name);
            if (found == defined.end()) {
                materials[number] = material_of(MtlSurface{.diffuse = unknown_colour()}, name);
                continue;
            }
            const MtlBlock& block = found->second;
            if (!block.fault.empty()) throw UserError(block.fault);
            // Clang cannot capture a structured binding implicitly.
            const auto note_if = [&, &of = name](bool is_so, const char* became) {
                if (is_so) warnings_.count("material", became, 0, of);
            };
            MtlSurface surface = block.surface;
            const std::optional<std::uint32_t> texture = texture_of(block);
            // The format's default is a middle grey, but a picture alone shows its own colours.
            if (texture && !block.has_diffuse) surface.diffuse = glm::vec3(1);
            materials[number] = material_of(surface, name);
            materials[number].texture = texture;
            note_if(is_out_of_range(block.surface), "with values out of range, taken as the nearest within");
            note_if(!add_emission(materials[number], glm::dvec3(block.surface.emission)), mixed_emission);
            note_if(block.has_textures, block.picture ? "with other textures, which are not drawn"
                                                      : "with textures, which are not drawn");
        }
        return materials;
    }

    /// Returns a corner's coordinates on the picture of its material, or on any picture if the material has
    /// none. In the file t increases upwards. Throws UserError if the picture cannot be drawn there.
    glm::dvec2 coordinates_of(std::size_t corner, std::size_t face, const Material& material) {
        const std::uint32_t index = corners_[corner].texture;
        if (index == 0 || index > coordinates_.size()) return no_coordinates;
        const auto map = material.texture ? mappings_.at(*material.texture) : Mapping{};
        const auto by_index = [](const TextureFault& fault, std::uint32_t i) { return fault.index < i; };
        const auto fault = std::lower_bound(texture_faults_.begin(), texture_faults_.end(), index, by_index);
        if (fault != texture_faults_.end() && fault->index == index) {
            if (material.texture)
                SourcePosition{at_.file, fault->line}.refuse(
                    "vt " + shown(fault->words) + " is not a point on a picture, and a face uses it");
            return no_coordinates;
        }
        const glm::dvec2 given = glm::dvec2(coordinates_[index - 1]) * map.scale + map.offset;
        const glm::dvec2 st(given.x, 1 - given.y);
        if (material.texture)
            for (const double x : {given.x, given.y})
                if (!(std::abs(x) <= max_given_coordinate))
                    at_.refuse(fmt::format("face {} has the texture coordinate {}; the most is {}", face + 1,
                                           x, max_given_coordinate));
        return st;
    }

    /// Throws UserError if a face spans too much of its picture.
    void check_span(const std::vector<Corner>& corners, std::size_t face, const Material& material) const {
        if (!material.texture) return;
        for (std::size_t k = 2; k < corners.size(); ++k)
            if (const std::string why = coordinate_fault(textures_[*material.texture],
                                                         {corners[0].st, corners[k - 1].st, corners[k].st});
                !why.empty() && !std::isnan(corners[0].st.x + corners[k - 1].st.x + corners[k].st.x))
                at_.refuse(fmt::format("face {} {}", face + 1, why));
    }

    PartBuilder part(std::size_t number, Assembly& assembly, const Material& material) {
        const std::size_t begin = runs_[number].first_face, end = end_of_run(number);
        PartBuilder builder(end - begin, runs_[number].is_smooth);
        std::vector<Corner> corners;
        for (std::size_t f = begin; f < end; ++f) {
            corners.clear();
            FaceColour colour;
            for (std::size_t k = corner_of_face(f); k < ends_[f]; ++k) {
                const Index& index = corners_[k];
                corners.push_back(
                    {glm::dvec3(positions_[index.position - 1]),
                     index.normal == 0 ? glm::dvec3(0) : glm::dvec3(directions_[index.normal - 1]),
                     coordinates_of(k, f, material)});
                colour.add(index.position <= colours_.size() ? colours_[index.position - 1] : std::nullopt);
            }
            check_span(corners, f, material);
            if (colour.varies()) warnings_.count("face", mixed_colours);
            assembly.face(builder, corners, builder.colour(colour.mean()));
        }
        return builder;
    }

    void unknown(std::string_view line, std::string_view key) {
        check_text(line, at_, "OBJ");
        if (unknown_.line == 0) unknown_ = {std::string(key), at_.line};
        warnings_.count("line", unknown_statement, at_.line, key);
    }

    /// Throws UserError about the first unknown statement: the file holds no triangles.
    [[noreturn]] void refuse_unknown() const {
        std::vector<std::string> known(silent.begin(), silent.end());
        known.insert(known.begin(), {"v", "vn", "f", "usemtl", "mtllib"});
        SourcePosition{at_.file, unknown_.line}.refuse(shown(unknown_.name) + " is not an OBJ statement" +
                                                       did_you_mean(unknown_.name, known));
    }

    struct TextureFault {
        std::uint32_t index;   ///< counted from 1
        std::uint64_t line;
        std::string words;   ///< after the `vt`
    };
    /// Maps the coordinates of the file to coordinates on a picture.
    struct Mapping {
        glm::dvec2 scale{1}, offset{0};
    };

    struct Library {
        std::string name;
        std::uint64_t line;
    };

    std::filesystem::path path_;
    SourcePosition at_;
    Loading& loading_;
    Warnings warnings_;
    Counted vertices_{"vertex"}, normals_{"normal"}, coordinate_count_{"texture coordinate"};
    std::vector<glm::vec3> positions_, directions_;
    /// Colours of the first vertices, up to the last one with a colour.
    std::vector<std::optional<glm::vec3>> colours_;
    std::vector<Fault> faults_;
    std::vector<glm::vec2> coordinates_;   ///< as in the file
    std::vector<TextureFault> texture_faults_;
    std::vector<Texture> textures_;
    std::vector<Mapping> mappings_;   ///< of the textures
    PictureFiles pictures_;
    std::vector<Index> corners_;
    std::vector<std::size_t> ends_;   ///< end of each face in `corners_`
    std::vector<Run> runs_;
    std::uint64_t triangles_ = 0;
    std::map<std::string, std::size_t> used_;
    std::vector<Library> libraries_;
    Library unknown_{{}, 0};   ///< the first unknown statement
};

/// Replaces the line break between joined lines, so that the count of lines stays right.
constexpr char joined_break = '\v';

/// Joins each line that ends in a backslash with the next line, in place.
void join_lines(std::string& text) {
    for (std::size_t at = text.find('\\'); at != text.npos; at = text.find('\\', at + 1)) {
        std::size_t end = at + 1;
        if (text.compare(end, 2, "\r\n") == 0) ++end;
        if (end >= text.size() || (text[end] != '\n' && text[end] != '\r')) continue;
        for (std::size_t i = at; i < end; ++i) text[i] = ' ';
        text[end] = joined_break;
    }
}

void read_statements(ObjReader& reader, std::string text, Loading& loading) {
    std::replace(text.begin(), text.end(), joined_break, ' ');
    join_lines(text);
    std::string_view rest = without_mark(text);
    for (std::uint64_t line = 1, breaks = 0; !rest.empty(); line += 1 + breaks) {
        if (line % 65'536 == 1) loading.report_progress("checking", text.size() - rest.size(), text.size());
        const std::string_view statement = take_line(rest);
        breaks = static_cast<std::uint64_t>(std::count(statement.begin(), statement.end(), joined_break));
        reader.statement(statement, line);
    }
    reader.check_end();
}

}   // namespace

Scene read_obj(const std::filesystem::path& path, std::string text, Loading& loading) {
    ObjReader reader(path, loading);
    read_statements(reader, std::move(text), loading);
    return reader.finish();
}

ObjShape read_obj_shape(const std::filesystem::path& path, std::string text, Loading& loading) {
    ObjReader reader(path, loading);
    read_statements(reader, std::move(text), loading);
    return reader.finish_shape();
}

}   // namespace rayclock
