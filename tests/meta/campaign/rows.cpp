// The rows of the tables of mutants, as faults of the campaign.
#include "tests/meta/campaign/rows.hpp"

#include <algorithm>
#include <optional>
#include <regex>

#include "tests/meta/campaign/state.hpp"

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

constexpr auto npos = std::string::npos;

struct Row {
    std::string file, old, fresh, text;   ///< text: of the whole file
    std::size_t at = 0;                   ///< of old in it
    Language language = Language::verilog;
};

/// Where the row's texts differ: from..to of the file becomes `fresh`.
struct TextChange {
    std::size_t from = 0, to = 0;
    std::string fresh;
};
TextChange change_of(const Row& row) {
    const std::size_t shorter = std::min(row.old.size(), row.fresh.size());
    std::size_t same = 0, tail = 0;
    while (same < shorter && row.old[same] == row.fresh[same]) ++same;
    while (tail < shorter - same &&
           row.old[row.old.size() - 1 - tail] == row.fresh[row.fresh.size() - 1 - tail])
        ++tail;
    return {row.at + same, row.at + row.old.size() - tail,
            row.fresh.substr(same, row.fresh.size() - tail - same)};
}

/// A C++ argument, or the smallest thing between brackets and commas, around the characters from..to; none if
/// there is none.
std::optional<Region> argument(const std::string& plain, std::size_t from, std::size_t to) {
    int depth = 0;
    std::size_t begin = from, end = to;
    for (; begin > 0; --begin) {
        const char c = plain[begin - 1];
        if (c == ';' || (depth == 0 && (c == '(' || c == '[' || c == '{' || c == ','))) break;
        depth += (c == ')' || c == ']' || c == '}') - (c == '(' || c == '[' || c == '{');
    }
    depth = 0;
    for (; end < plain.size(); ++end) {
        const char c = plain[end];
        if (c == ';' || (depth == 0 && (c == ')' || c == ']' || c == '}' || c == ','))) break;
        depth += (c == '(' || c == '[' || c == '{') - (c == ')' || c == ']' || c == '}');
    }
    if (begin == 0 || end == plain.size() || plain[begin - 1] == ';' || plain[end] == ';') return {};
    depth = 0;   // a change of several arguments is not one expression
    for (std::size_t i = from; i < to; ++i) {
        const char c = plain[i];
        depth += (c == '(' || c == '[' || c == '{') - (c == ')' || c == ']' || c == '}');
        if (depth < 0 || (depth == 0 && c == ',')) return {};
    }
    Region region;
    region.begin = begin, region.end = end;
    return region;
}

/// The change as one of the smallest expression around it.
std::optional<std::pair<Region, std::string>> one_expression(const Row& row) {
    const std::string plain = blanked(row.text, row.language);
    const TextChange change = change_of(row);
    std::vector<Region> around;
    for (const Region& region : regions(row.text, row.language)) {
        const bool begins =
            region.begin <= change.from || row.text.find_first_not_of(" \n", change.from) >= region.begin;
        if (begins && region.begin <= change.to && region.end >= change.to) around.push_back(region);
    }
    if (around.empty() && row.language == Language::cpp)
        if (const auto region = argument(plain, change.from, change.to)) around.push_back(*region);
    if (around.empty()) return {};
    const Region& best =
        *std::min_element(around.begin(), around.end(),
                          [](const Region& a, const Region& b) { return a.end - a.begin < b.end - b.begin; });
    const std::size_t from = std::max(change.from, best.begin);
    const std::string changed = row.text.substr(best.begin, from - best.begin) + change.fresh +
                                row.text.substr(change.to, best.end - change.to);
    return std::pair{best, blanked(changed, row.language)};
}

/// Returns the text that identifies an expression: the assigned name, or the word before its bracket.
std::string key(const std::string& plain, const Region& region) {
    if (!region.target.empty()) return region.target;
    std::size_t from = region.begin - 1;
    while (from > 0 && (std::isalnum(static_cast<unsigned char>(plain[from - 1])) || plain[from - 1] == '_'))
        --from;
    return plain.substr(from, region.begin - 1 - from);
}

std::vector<Region> within(const std::vector<Region>& all, std::size_t from, std::size_t to) {
    std::vector<Region> some;
    for (const Region& region : all)
        if (region.begin >= from && region.end <= to) some.push_back(region);
    return some;
}

/// Gives the names that `added` declares the suffix _NUMBER, in `text`.
std::string renamed(std::string text, const std::string& added, int number) {
    const std::regex declared("\\b([a-z_]+_q);");
    for (std::sregex_iterator it(added.begin(), added.end(), declared), end; it != end; ++it)
        text = std::regex_replace(text, std::regex("\\b" + (*it)[1].str() + "\\b"),
                                  (*it)[1].str() + "_" + std::to_string(number));
    return text;
}

/// A row that puts items of a module in front of what it changes, or changes several expressions.
std::vector<std::pair<Region, std::string>> several(const Row& row, int number, std::string& added) {
    const std::size_t front =
        row.fresh.starts_with(row.old.substr(0, 4)) ? 0 : row.fresh.find(row.old.substr(0, 12));
    if (front == npos) return {};
    added = row.fresh.substr(0, front);
    const std::string fresh = row.fresh.substr(front);
    std::string changed = row.text;
    changed.replace(row.at, row.old.size(), fresh);
    const std::string plain = blanked(row.text, row.language), plain_changed = blanked(changed, row.language);
    const auto before = within(regions(row.text, row.language), row.at, row.at + row.old.size());
    const auto after = within(regions(changed, row.language), row.at, row.at + fresh.size());
    if (before.size() != after.size()) return {};
    std::vector<std::pair<Region, std::string>> found;
    std::vector<bool> used(after.size());
    for (const Region& region : before) {
        std::size_t i = 0;
        while (i < after.size() && (used[i] || key(plain_changed, after[i]) != key(plain, region))) ++i;
        if (i == after.size()) return {};
        used[i] = true;
        const std::string now = plain_changed.substr(after[i].begin, after[i].end - after[i].begin);
        if (now != plain.substr(region.begin, region.end - region.begin))
            found.emplace_back(region, renamed(now, added, number));
    }
    added = renamed(blanked(added, row.language), added, number);
    return found;
}

}   // namespace

std::vector<Mutant> of_row(const fs::path& source, const fs::path& folder, int number) {
    Row row{text_of(folder / "file"), text_of(folder / "old"), text_of(folder / "new"), "", 0,
            Language::verilog};
    if (!row.file.starts_with("rtl/")) row.language = Language::cpp;
    row.text = text_of(source / row.file);
    row.at = row.text.find(row.old);
    if (row.old.empty() || row.at == npos) return {};
    if (row.fresh.find("float(") != npos)
        return {};   // next to a float the sound expression would be rounded as well
    std::string added;
    std::vector<std::pair<Region, std::string>> changes;
    if (const auto one = one_expression(row))
        changes.push_back(*one);
    else
        changes = several(row, number, added);
    std::vector<Mutant> mutants;
    for (const auto& [region, text] : changes) {
        const int line = line_of(row.text, row.at);
        mutants.push_back(
            {number, row.file, line, region, {"row", text, folder.filename().string()}, added, row.at});
        added.clear();
    }
    return mutants;
}

static bool overlaps(const Mutant& m, const std::vector<Mutant>& others) {
    return std::any_of(others.begin(), others.end(), [&](const Mutant& o) {
        const bool same = m.region.begin == o.region.begin && m.region.end == o.region.end;
        return m.file == o.file && !same && m.region.begin < o.region.end && o.region.begin < m.region.end;
    });
}

std::vector<Mutant> all_rows(const fs::path& source, const fs::path& rows, const std::string& folder,
                             std::vector<std::string>& others) {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(rows))
        if (fs::exists(entry.path() / "old") && text_of(entry.path() / "file").starts_with(folder))
            all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    std::vector<Mutant> mutants;
    int number = first_row;
    for (const fs::path& row : all) {
        if (text_of(row / "old").empty()) continue;   // a control
        const std::vector<Mutant> some = of_row(source, row, ++number);
        const bool fits = !some.empty() && std::none_of(some.begin(), some.end(), [&](const Mutant& m) {
            return overlaps(m, mutants);
        });
        if (fits)
            mutants.insert(mutants.end(), some.begin(), some.end());
        else
            others.push_back(row.filename().string());
    }
    return mutants;
}

}   // namespace rayclock::campaign
