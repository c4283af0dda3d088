#pragma once
// Tables of words and numbers, for terminals and pages.
#include <cstdint>
#include <string>
#include <vector>

namespace rayclock {

/// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t n);

/// A table: the first `left` columns are words and stand to the left, all others are numbers and stand to the
/// right.
class Table {
public:
    static constexpr std::size_t words_only = std::size_t(-1);

    explicit Table(std::vector<std::string> head, std::size_t left = 1)
        : left_(left), rows_{std::move(head)} {}
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    /// For a terminal: the columns are aligned with blanks.
    std::string text(int indent = 2) const;
    /// For a page in Markdown.
    std::string markdown() const;

private:
    std::size_t left_;
    std::vector<std::vector<std::string>> rows_;
};

}   // namespace rayclock
