// Reads netlists of Yosys and nextpnr, and assigns cells to units and source lines.
#include "sim/silicon/chip/cells.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/base/split.hpp"
#include "sim/files/input.hpp"
#include "sim/files/text.hpp"
#include "sim/silicon/area/variants.hpp"
#include "sim/silicon/chip/board.hpp"

namespace rayclock::chip {

namespace fs = std::filesystem;

namespace {

/// Follows modules / MODULE / cells / CELL / type, attributes or connections, and skips everything else.
class CellReader : public nlohmann::json_sax<nlohmann::json> {
public:
    explicit CellReader(const std::function<void(const Cell&)>& take) : take_(take) {}

    bool start_object(std::size_t) override {
        path_.push_back(std::move(key_));
        key_.clear();
        if (is_cell()) cell_ = {path_.back(), {}, {}, {}, {}};
        return true;
    }
    bool end_object() override {
        if (is_cell()) take_(cell_);
        path_.pop_back();
        return true;
    }
    bool key(string_t& text) override {
        key_ = text;
        return true;
    }
    bool string(string_t& text) override {
        if (in_cells() && path_.size() == 5 && key_ == "type") cell_.type = text;
        if (in_cells() && path_.size() == 6 && path_.back() == "attributes") {
            if (key_ == "src") cell_.source = text;
            if (key_ == "NEXTPNR_BEL") cell_.bel = text;
        }
        return true;
    }
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t number) override {
        if (in_cells() && path_.size() == 6 && path_.back() == "connections")
            cell_.nets.push_back(int(number));
        return true;
    }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    bool in_cells() const { return path_.size() >= 5 && path_[1] == "modules" && path_[3] == "cells"; }
    bool is_cell() const { return in_cells() && path_.size() == 5; }

    const std::function<void(const Cell&)>& take_;
    std::vector<std::string> path_;   ///< names of the enclosing objects; the document's own name is empty
    std::string key_;
    Cell cell_;
};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool has_word(std::string_view line, const std::string& word) {
    line = line.substr(0, line.find("//"));
    for (std::size_t at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_letter(line[at - 1])) && (end == line.size() || !is_letter(line[end])))
            return true;
    }
    return false;
}

std::string_view nth_line(std::string_view text, int line) {
    std::string_view found;
    for (int i = 0; i < line && !text.empty(); ++i) found = take_line(text);
    return found;
}

/// Returns the path of the file with this name relative to the folder `sources`; empty if there is none. The
/// netlist may come from an equal copy of the sources in another folder.
std::string same_source(const fs::path& path, const fs::path& sources) {
    std::error_code error;
    const fs::path names = path.relative_path();
    fs::path name;
    for (auto first = names.end(); first != names.begin();) {   // of longer and longer ends of the path
        --first;
        name = name.empty() ? *first : *first / name;
        if (fs::is_regular_file(sources / name, error)) return name.string();
    }
    return {};
}

/// Returns true if the position belongs to an instance. Yosys places an instance at its name or at the
/// parenthesis behind it, "u_queue (". It always places a process at its keyword.
bool is_instance(const std::string& file, int line, int column) {
    const std::string text = read_if_there(file);
    const std::string_view whole = nth_line(text, line);
    std::size_t at = std::min(std::size_t(std::max(column - 1, 0)), whole.size());
    while (at > 0 && (at == whole.size() || !is_letter(whole[at]))) --at;
    while (at > 0 && is_letter(whole[at - 1])) --at;
    return whole.substr(at).starts_with("u_");
}

/// Returns the first line in the module rc_NAME that contains a word.
std::string line_in_module(const std::string& name, const std::string& word, const std::string& sources) {
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(sources, error)) {
        if (entry.path().filename() != "rc_" + name + ".sv" || word.empty()) continue;
        const std::string text = read_if_there(entry.path());
        int line = 1;
        for (std::string_view rest = text; !rest.empty(); ++line)
            if (has_word(take_line(rest), word))
                return fmt::format("rtl/{}:{}", fs::relative(entry.path(), sources, error).string(), line);
    }
    return {};
}

}   // namespace

bool read_cells(const std::string& file, const std::function<void(const Cell&)>& take) {
    std::ifstream stream(file, std::ios::binary);
    CellReader reader(take);
    return stream && nlohmann::json::sax_parse(stream, &reader);
}

Units::Units(std::string top) : top_(std::move(top)) {
    for (const area::UnitRow& row : area::unit_rows()) names_.push_back(row.name);
    names_.insert(names_.end(), {"host", "counters"});
    if (top_ == board_top)
        names_.insert(names_.end(), {"link", "frame", "colour", "writer", "scan", "video", "memory"});
}

std::string Units::of(std::string_view cell) const {
    if (cell.starts_with("$nextpnr_CCU2C_")) return top_ == "chip" || top_ == board_top ? carry_unit : top_;
    bool inside = false;
    for (const std::string& part : split(std::string(cell), '.')) {
        if (!part.starts_with("u_")) continue;
        const std::string name = part.substr(2);
        if (std::find(names_.begin(), names_.end(), name) != names_.end()) return name;
        if (name == top_ && name != "chip" && name != board_top) return name;
        inside |= name == top_;
    }
    return inside ? wiring_unit : harness_unit;
}

Use use_of(const std::string& type) {
    if (type == "TRELLIS_COMB" || type == "LUT4") return {1, 0, 0, 0};
    if (type == "TRELLIS_RAMW" || type == "CCU2C") return {2, 0, 0, 0};
    // Four cells to read, and a RAMW, which counts as two, to write.
    if (type == "TRELLIS_DPR16X4") return {6, 0, 0, 0};
    if (type == "TRELLIS_FF") return {0, 1, 0, 0};
    if (type == "MULT18X18D") return {0, 0, 1, 0};
    if (type == "DP16KD" || type == "PDPW16KD") return {0, 0, 0, 1};
    return {};
}

std::string source_line(const std::string& src, const std::string& sources, bool instances) {
    for (const std::string& place : split(src, '|')) {   // in no order
        const std::size_t colon = place.rfind(':');      // /some/rtl/engine/bvh/rc_box.sv:120.3-140.6
        int line = 0, column = 0;
        if (colon == std::string::npos || std::sscanf(place.c_str() + colon, ":%d.%d-", &line, &column) != 2)
            continue;
        const std::string file = same_source(place.substr(0, colon), sources);
        if (!file.empty() && is_instance((fs::path(sources) / file).string(), line, column) == instances)
            return fmt::format("rtl/{}:{}", file, line);
    }
    return {};
}

std::string source_of_name(const std::string& unit, const std::string& name, const std::string& sources) {
    std::string module = unit, found;
    for (const std::string& part : split(name, '.')) {
        const std::string word = part.substr(0, part.find('['));
        if (const std::string line = line_in_module(module, word, sources); !line.empty()) found = line;
        if (!part.starts_with("u_")) break;
        module = word.substr(2);
    }
    return found;
}

std::string register_of(std::string_view cell, const std::string& unit) {
    std::string name(cell);
    if (const std::size_t at = name.find("u_" + unit + "."); at != std::string::npos)
        name = name.substr(at + unit.size() + 3);
    for (const char* tail :
         {"_TRELLIS_FF_", "_LUT4_", "_CCU2C_", "_MULT18X18D_", "_PFUMX_", "_L6MUX21_", "$"})
        name = name.substr(0, name.find(tail));
    return name;
}

}   // namespace rayclock::chip
