#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/base/progress.hpp"

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

/// Draws progress with the time that is left on standard error, if that is a terminal; otherwise does
/// nothing. What comes after a comma in `what` is shown, and is not part of the name of the work.
Progress terminal_progress();

/// write_bytes() of sim/files/output.hpp; "-" is standard output. Throws UserError if it cannot.
void write_file(const std::string& path, const std::string& text);

}   // namespace rayclock
