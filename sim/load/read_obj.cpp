// OBJ: every statement is checked with its line number; positions, normals, faces and the materials of faces
// are taken. Groups, objects, texture coordinates, curves, points and lines are dropped. Faces stay in the
// order of the file.
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "model/base/nearest.hpp"
#include "sim/files/input.hpp"
#include "sim/files/text.hpp"
#include "sim/load/mesh_file.hpp"

namespace rayclock {
namespace {

/// Statements that the format knows and that say nothing about triangles.
constexpr std::array<std::string_view, 34> silent{
    "vt",     "vp",         "g",         "o",     "s",     "p",        "l",        "mg",   "cstype",
    "deg",    "bmat",       "step",      "curv",  "curv2", "surf",     "parm",     "trim", "hole",
    "scrv",   "sp",         "end",       "con",   "bevel", "c_interp", "d_interp", "lod",  "maplib",
    "usemap", "shadow_obj", "trace_obj", "ctech", "stech", "call",     "csh"};

/// Counts one kind of element and keeps the indices that only a later line could make good.
class Counted {
public:
    explicit Counted(std::string_view what) : what_(what) {}
    void add(const Place& at) {
        if (++count_ > std::numeric_limits<std::uint32_t>::max())
            at.refuse(fmt::format("more than 2^32 - 1 {} lines", what_));
    }
    std::uint64_t absolute(std::string_view word, const Place& at) {
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
    void finish(const std::string& file) const {
        for (const auto& [index, line] : maxima_)
            if (index > count_)
                Place{file, line}.refuse(
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

class ObjReader {
public:
    ObjReader(const std::filesystem::path& path, Loading& loading)
        : path_(path), at_{path.string()}, loading_(loading) {}

    void statement(std::string_view line, std::uint64_t number) {
        at_.line = number;
        std::string_view rest = line.substr(0, line.find('#'));
        const std::string_view key = take_word(rest);
        if (key.empty()) return check_text(line, at_, "OBJ");
        if (key == "v")
            numbers("v ", rest, vertices_, positions_);
        else if (key == "vn")
            numbers("vn ", rest, normals_, directions_);
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

    ObjShape finish_shape() {
        check_end();
        ObjShape shape{{}, {}, {}, {}, {}, read_materials()};
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            const std::size_t end = i + 1 < runs_.size() ? runs_[i + 1].first_face : ends_.size();
            shape.materials.resize(end, static_cast<std::uint32_t>(runs_[i].material));
        }
        shape.positions = std::move(positions_), shape.normals = std::move(directions_);
        shape.corners = std::move(corners_), shape.ends = std::move(ends_);
        return shape;
    }

    Scene finish() {
        check_end();
        const std::vector<Material> materials = read_materials();
        Assembly assembly(at_.file, loading_);
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            loading_.tell("joining", i, runs_.size());
            assembly.add(part(i, assembly));
        }
        assembly.make_alike();
        for (std::size_t i = 0; i < runs_.size(); ++i)
            assembly.place(i, glm::dmat4(1), runs_[i].material, [&] { return materials[runs_[i].material]; });
        return assembly.take();
    }

private:
    /// Faces one after the other with the same material.
    struct Run {
        std::size_t first_face, material;
        bool is_smooth = false;
    };
    using Index = ObjShape::Corner;

    void check_end() {
        at_.line = 0;
        vertices_.finish(at_.file);
        normals_.finish(at_.file);
        if (ends_.empty()) at_.refuse("the file has no triangles");
    }

    void numbers(std::string_view key, std::string_view rest, Counted& counted,
                 std::vector<glm::vec3>& list) {
        counted.add(at_);
        glm::vec3 point(0);
        // Beyond the third there may be a weight or a colour; they are checked and not used.
        int count = 0;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const auto value = static_cast<float>(finite_number(word, at_));
            if (count < 3) point[count] = value;
            ++count;
        }
        if (count < 3) at_.refuse(fmt::format("{}needs 3 numbers and has {}", key, count));
        list.push_back(point);
    }

    void face(std::string_view rest) {
        const std::size_t start = corners_.size();
        if (runs_.empty()) use("default");
        const bool was_smooth = runs_.back().is_smooth;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) corner(word);
        const std::size_t corners = corners_.size() - start;
        if (corners > max_corners)
            at_.refuse(fmt::format("a face with {} corners; the most is {}", corners, max_corners));
        if (corners < 3) {   // a point or a line
            corners_.resize(start);
            runs_.back().is_smooth = was_smooth;
            return;
        }
        if ((triangles_ += corners - 2) > max_triangles)
            at_.refuse(fmt::format("more than {} triangles", max_triangles));
        ends_.push_back(corners_.size());
    }

    void corner(std::string_view word) {
        const std::size_t first = word.find('/');
        const std::size_t second = first == word.npos ? word.npos : word.find('/', first + 1);
        Index index{static_cast<std::uint32_t>(vertices_.absolute(word.substr(0, first), at_)), 0};
        if (first != word.npos) {
            const std::string_view texture = word.substr(first + 1, second - first - 1);
            if (!texture.empty()) whole_number(texture, at_);
        }
        if (second != word.npos && second + 1 != word.size()) {
            index.normal = static_cast<std::uint32_t>(normals_.absolute(word.substr(second + 1), at_));
            runs_.back().is_smooth = true;
        }
        corners_.push_back(index);
    }

    void material(std::string_view rest) {
        const std::string name = joined_words(rest);
        check_text(name, at_, "OBJ");
        use(name.empty() ? "default" : name);   // exporters do leave it out
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
        // One name with blanks or several names: the file system knows which.
        const std::string whole = joined_words(rest);
        std::error_code ignored;
        if (std::filesystem::exists(path_.parent_path() / whole, ignored))
            return libraries_.push_back({whole, at_.line});
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
            libraries_.push_back({std::string(word), at_.line});
    }

    /// A mesh often travels without its materials, so a missing file is no reason to refuse it.
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
            for (MtlBlock& block : read_mtl(path, loading_.read(path, from)))
                defined.try_emplace(block.name, std::move(block));
        }
        return defined;
    }

    /// All materials in use; the first definition of a name counts, and one that has none is plain grey.
    std::vector<Material> read_materials() {
        const std::map<std::string, MtlBlock> defined = read_libraries();
        if (!loading_.may_make(used_.size() * sizeof(Material))) at_.refuse(loading_.too_much());
        std::vector<Material> materials(used_.size());
        std::uint64_t odd = 0, textured = 0;
        for (const auto& [name, number] : used_) {
            const auto found = defined.find(name);
            const bool is_known = found != defined.end();
            materials[number] =
                material_of(is_known ? found->second.surface : MtlSurface{.diffuse = glm::vec3(0.8f)}, name);
            odd += is_known && is_out_of_range(found->second.surface);
            textured += is_known && found->second.has_textures;
        }
        if (odd > 0)
            loading_.note(at_.file, counted(odd, "material") +
                                        " with values out of range, taken as the nearest within");
        if (textured > 0)
            loading_.note(at_.file, counted(textured, "material") + " with textures, which are not drawn");
        return materials;
    }

    PartBuilder part(std::size_t number, Assembly& assembly) const {
        const std::size_t begin = runs_[number].first_face,
                          end = number + 1 < runs_.size() ? runs_[number + 1].first_face : ends_.size();
        PartBuilder builder(end - begin, runs_[number].is_smooth);
        std::vector<Corner> corners;
        for (std::size_t f = begin; f < end; ++f) {
            corners.clear();
            for (std::size_t k = f == 0 ? 0 : ends_[f - 1]; k < ends_[f]; ++k) {
                const Index& index = corners_[k];
                corners.push_back(
                    {glm::dvec3(positions_[index.position - 1]),
                     index.normal == 0 ? glm::dvec3(0) : glm::dvec3(directions_[index.normal - 1])});
            }
            assembly.face(builder, corners);
        }
        return builder;
    }

    [[noreturn]] void unknown(std::string_view line, std::string_view key) const {
        check_text(line, at_, "OBJ");
        std::vector<std::string> known(silent.begin(), silent.end());
        known.insert(known.begin(), {"v", "vn", "f", "usemtl", "mtllib"});
        at_.refuse(shown(key) + " is not an OBJ statement" + did_you_mean(key, known));
    }

    struct Library {
        std::string name;
        std::uint64_t line;
    };

    std::filesystem::path path_;
    Place at_;
    Loading& loading_;
    Counted vertices_{"vertex"}, normals_{"normal"};
    std::vector<glm::vec3> positions_, directions_;
    std::vector<Index> corners_;
    std::vector<std::size_t> ends_;   ///< of each face, in `corners_`
    std::vector<Run> runs_;
    std::uint64_t triangles_ = 0;
    std::map<std::string, std::size_t> used_;
    std::vector<Library> libraries_;
};

/// Joins lines that end in a backslash with the next, in place; line breaks inside become marks of their own
/// so that the count of lines stays right.
constexpr char joined_break = '\v';

void join_lines(std::string& text) {
    for (std::size_t at = text.find('\\'); at != text.npos; at = text.find('\\', at + 1)) {
        const std::size_t end = at + 1 < text.size() && text[at + 1] == '\r' ? at + 2 : at + 1;
        if (end >= text.size() || text[end] != '\n') continue;
        for (std::size_t i = at; i < end; ++i) text[i] = ' ';
        text[end] = joined_break;
    }
}

void read_statements(ObjReader& reader, std::string text, Loading& loading) {
    std::replace(text.begin(), text.end(), joined_break, ' ');
    join_lines(text);
    std::string_view rest = without_mark(text);
    for (std::uint64_t line = 1, breaks = 0; !rest.empty(); line += 1 + breaks) {
        if (line % 65'536 == 1) loading.tell("checking", text.size() - rest.size(), text.size());
        const std::string_view statement = take_line(rest);
        breaks = static_cast<std::uint64_t>(std::count(statement.begin(), statement.end(), joined_break));
        reader.statement(statement, line);
    }
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
