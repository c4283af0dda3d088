#pragma once
// Tables of words and numbers, for terminals and for Markdown pages.
#include <cstdint>
#include <string>
#include <vector>

namespace rayclock {

/// Returns a number with thousands separators: 1234567 -> "1,234,567".
std::string grouped(std::uint64_t n);

/// A table whose first `left` columns hold words, aligned left. All other columns hold numbers, aligned
/// right.
class Table {
public:
    static constexpr std::size_t words_only = std::size_t(-1);

    explicit Table(std::vector<std::string> head, std::size_t left = 1)
        : left_(left), rows_{std::move(head)} {}
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    /// Returns the table for a terminal, its columns aligned with blanks.
    std::string text(int indent = 2) const;
    /// Returns the table as Markdown.
    std::string markdown() const;

private:
    std::size_t left_;
    std::vector<std::vector<std::string>> rows_;
};

}   // namespace rayclock
