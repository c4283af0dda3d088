// Formatting of tables and of grouped digits.
#include "sim/files/table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rayclock {

std::string grouped(std::uint64_t n) {
    std::string text = std::to_string(n);
    for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), ",");
    return text;
}

namespace {

/// Returns one line of a Markdown table. An empty first cell takes a single blank.
std::string markdown_row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (std::size_t c = 0; c < cells.size(); ++c)
        line += (c == 0 && cells[c].empty() ? "" : " " + cells[c]) + " |";
    return line + "\n";
}

}   // namespace

std::string Table::markdown() const {
    std::string text = markdown_row(rows_[0]) + "|";
    for (std::size_t c = 0; c < rows_[0].size(); ++c) text += c < left_ ? "---|" : "---:|";
    text += "\n";
    for (std::size_t r = 1; r < rows_.size(); ++r) text += markdown_row(rows_[r]);
    return text;
}

std::string Table::text(int indent) const {
    std::vector<std::size_t> width;
    for (const auto& row : rows_)
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (c == width.size()) width.push_back(0);
            width[c] = std::max(width[c], row[c].size());
        }
    std::string text;
    for (const auto& row : rows_) {
        std::string line(std::size_t(indent), ' ');
        for (std::size_t c = 0; c < row.size(); ++c)
            line += (c ? "  " : "") + (c < left_ ? fmt::format("{:<{}}", row[c], width[c])
                                                 : fmt::format("{:>{}}", row[c], width[c]));
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

}   // namespace rayclock
