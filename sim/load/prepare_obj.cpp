// OBJ: every statement is checked with its line number, then written anew in the plainest form: positions,
// normals, faces with absolute indices, usemtl. Groups, objects, textures, curves, points and lines are dropped;
// that also keeps the faces in the order of the file, which the importer would sort by group.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "model/core/nearest.hpp"
#include "sim/load/file.hpp"
#include "sim/load/prepare.hpp"
#include "sim/load/text.hpp"

namespace rayclock {
namespace {

/// Statements that the format knows and that say nothing about triangles.
constexpr std::array<std::string_view, 34> silent{
    "vt", "vp", "g", "o", "s", "p", "l", "mg", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim",
    "hole", "scrv", "sp", "end", "con", "bevel", "c_interp", "d_interp", "lod", "maplib", "usemap", "shadow_obj",
    "trace_obj", "ctech", "stech", "call", "csh"};

/// Counts one kind of element and keeps the indices that only a later line could make good.
class Counted {
public:
    explicit Counted(std::string_view what) : what_(what) {}
    void add(const Place& at) {
        if (++count_ > std::numeric_limits<std::uint32_t>::max()) at.refuse(fmt::format("more than 2^32 - 1 {} lines", what_));
    }
    std::uint64_t absolute(std::string_view word, const Place& at) {
        const std::int64_t index = whole_number(word, at);
        if (index == 0) at.refuse(fmt::format("{} index 0: indices start at 1", what_));
        if (index < 0 && static_cast<std::uint64_t>(-(index + 1)) >= count_)
            at.refuse(fmt::format("{} index {} reaches before the first of {}", what_, index, count_));
        if (index < 0) return count_ - static_cast<std::uint64_t>(-(index + 1));
        // The first index beyond the final count is also a new maximum, so maxima are all that is kept.
        const auto forward = static_cast<std::uint64_t>(index);
        if (forward > count_ && (maxima_.empty() || forward > maxima_.back().index)) maxima_.push_back({forward, at.line});
        return forward;
    }
    void finish(const std::string& file) const {
        for (const auto& [index, line] : maxima_)
            if (index > count_)
                Place{file, line}.refuse(fmt::format("{} index {} is out of range: the file has {}", what_, index, count_));
    }

private:
    struct Forward {
        std::uint64_t index, line;
    };
    std::string_view what_;
    std::uint64_t count_ = 0;
    std::vector<Forward> maxima_;
};

class ObjWriter {
public:
    ObjWriter(const std::filesystem::path& path, std::size_t size) : path_(path), at_{path.string()} { out_.reserve(size + 64); }

    void statement(std::string_view line, std::uint64_t number) {
        at_.line = number;
        std::string_view rest = line.substr(0, line.find('#'));
        const std::string_view key = take_word(rest);
        if (key.empty()) return check_text(line, at_, "OBJ");
        if (key == "v") numbers("v ", rest, vertices_);
        else if (key == "vn") numbers("vn ", rest, normals_);
        else if (key == "f" || key == "fo") face(rest);
        else if (key == "usemtl") material(rest);
        else if (key == "mtllib") library(rest);
        else if (std::find(silent.begin(), silent.end(), key) == silent.end()) unknown(line, key);
        else check_text(line, at_, "OBJ");
    }

    Prepared finish() {
        at_.line = 0;
        vertices_.finish(at_.file);
        normals_.finish(at_.file);
        if (faces_ == 0) at_.refuse("the file has no triangles");
        Prepared prepared;
        prepared.main = "mesh.obj";
        prepared.files["mesh.mtl"] = materials(prepared.materials);
        prepared.files["mesh.obj"] = std::move(out_);
        return prepared;
    }

private:
    void numbers(std::string_view key, std::string_view rest, Counted& counted) {
        counted.add(at_);
        out_ += key;
        // Beyond the third there may be a weight or a colour; they are checked and not used.
        int count = 0;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const auto value = static_cast<float>(finite_number(word, at_));
            if (++count <= 3) coordinate(value);
        }
        if (count < 3) at_.refuse(fmt::format("{}needs 3 numbers and has {}", key, count));
        out_.back() = '\n';
    }

    /// Written anew, because the importer takes ".5" for no number at all and leaves out the vertex. It adds whole part
    /// and fraction as floats and multiplies by powers of ten, so these spellings are the ones that it reads exactly.
    void coordinate(float value) {
        const float size = std::abs(value);
        const auto to = std::back_inserter(out_);
        if (size >= 1 && size < 1e18f) fmt::format_to(to, "{:.9f} ", value);
        else if (size > 1e-6f && size < 1e-3f) fmt::format_to(to, "{:.15f} ", value);
        else fmt::format_to(to, "{} ", value);
    }

    void face(std::string_view rest) {
        // Faces before the first usemtl would get that one's material from the importer.
        if (used_.empty()) use("default");
        const std::size_t start = out_.size();
        out_ += 'f';
        std::uint64_t corners = 0;
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++corners) corner(word);
        if (corners > max_corners) at_.refuse(fmt::format("a face with {} corners; the most is {}", corners, max_corners));
        if (corners < 3) return out_.resize(start);  // a point or a line
        out_ += '\n';
        if ((triangles_ += corners - 2) > max_triangles) at_.refuse(fmt::format("more than {} triangles", max_triangles));
        ++faces_;
    }

    void corner(std::string_view word) {
        const std::size_t first = word.find('/');
        const std::size_t second = first == word.npos ? word.npos : word.find('/', first + 1);
        const auto to = std::back_inserter(out_);
        fmt::format_to(to, " {}", vertices_.absolute(word.substr(0, first), at_));
        if (first == word.npos) return;
        const std::string_view texture = word.substr(first + 1, second - first - 1);
        if (!texture.empty()) whole_number(texture, at_);
        if (second == word.npos || second + 1 == word.size()) return;
        fmt::format_to(to, "//{}", normals_.absolute(word.substr(second + 1), at_));
    }

    void material(std::string_view rest) {
        const std::string name = trimmed(rest);
        check_text(name, at_, "OBJ");
        use(name.empty() ? "default" : name);  // exporters do leave it out
    }

    void use(const std::string& name) {
        const auto [found, ignored] = used_.try_emplace(name, used_.size());
        fmt::format_to(std::back_inserter(out_), "usemtl m{}\n", found->second);
    }

    void library(std::string_view rest) {
        check_text(rest, at_, "OBJ");
        // One name with blanks or several names: the file system knows which.
        const std::string whole = trimmed(rest);
        std::error_code ignored;
        if (std::filesystem::exists(path_.parent_path() / whole, ignored)) return libraries_.push_back(whole);
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) libraries_.emplace_back(word);
    }

    /// All materials in use; the first definition of a name counts, and one that has none is plain grey.
    std::string materials(std::vector<std::string>& names) const {
        std::map<std::string, std::string> defined;
        for (const std::string& name : libraries_)
            for (MtlBlock& block : read_mtl(path_.parent_path() / name)) defined.try_emplace(block.name, std::move(block.text));
        names.resize(used_.size());
        std::string text;
        for (const auto& [name, number] : used_) {
            names[number] = name;
            const auto found = defined.find(name);
            text += fmt::format("newmtl m{}\n{}", number, found == defined.end() ? "Kd 0.8 0.8 0.8\n" : found->second);
        }
        return text + "\n";
    }

    [[noreturn]] void unknown(std::string_view line, std::string_view key) const {
        check_text(line, at_, "OBJ");
        std::vector<std::string> known(silent.begin(), silent.end());
        known.insert(known.begin(), {"v", "vn", "f", "usemtl", "mtllib"});
        at_.refuse(shown(key) + " is not an OBJ statement" + did_you_mean(key, known));
    }

    static std::string trimmed(std::string_view text) {
        std::string name;
        for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) (name += name.empty() ? "" : " ") += word;
        return name;
    }

    std::filesystem::path path_;
    Place at_;
    std::string out_ = "mtllib mesh.mtl\n";
    Counted vertices_{"vertex"}, normals_{"normal"};
    std::uint64_t faces_ = 0, triangles_ = 0;
    std::map<std::string, std::size_t> used_;
    std::vector<std::string> libraries_;
};

/// Joins lines that end in a backslash with the next, in place; line breaks inside become marks of their own so
/// that the count of lines stays right.
constexpr char joined_break = '\v';

void join_lines(std::string& text) {
    for (std::size_t at = text.find('\\'); at != text.npos; at = text.find('\\', at + 1)) {
        const std::size_t end = at + 1 < text.size() && text[at + 1] == '\r' ? at + 2 : at + 1;
        if (end >= text.size() || text[end] != '\n') continue;
        for (std::size_t i = at; i < end; ++i) text[i] = ' ';
        text[end] = joined_break;
    }
}

} // namespace

Prepared prepare_obj(const std::filesystem::path& path, std::string text, const Progress& progress) {
    std::replace(text.begin(), text.end(), joined_break, ' ');
    join_lines(text);
    ObjWriter writer(path, text.size());
    std::string_view rest = without_mark(text);
    for (std::uint64_t line = 1, breaks = 0; !rest.empty(); line += 1 + breaks) {
        if (progress && line % 65'536 == 1) progress("checking", text.size() - rest.size(), text.size());
        const std::string_view statement = take_line(rest);
        breaks = static_cast<std::uint64_t>(std::count(statement.begin(), statement.end(), joined_break));
        writer.statement(statement, line);
    }
    return writer.finish();
}

} // namespace rayclock
