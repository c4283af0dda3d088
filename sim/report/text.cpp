#include "sim/report/text.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "sim/files/output.hpp"
#include "sim/files/streams.hpp"

namespace rayclock {

std::string grouped(std::uint64_t n) {
    std::string text = std::to_string(n);
    for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), ",");
    return text;
}

namespace {

/// An empty corner takes a single blank.
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

Progress terminal_progress() {
    if (!isatty(STDERR_FILENO)) return {};
    using Clock = std::chrono::steady_clock;
    struct State {
        std::string what;
        Clock::time_point start, drawn;
    };
    const auto state = std::make_shared<State>();
    return [state](std::string_view what, std::uint64_t done, std::uint64_t total) {
        const auto now = Clock::now();
        if (const std::string_view work = what.substr(0, what.find(',')); state->what != work)
            *state = {std::string(work), now, {}};
        const bool end = done >= total;
        if (!end && now - state->drawn < std::chrono::milliseconds(100)) return;
        state->drawn = now;
        const double seconds = std::chrono::duration<double>(now - state->start).count();
        if (end) {
            std::fprintf(stderr, "\r\033[K");
        } else {
            const double share = total ? double(done) / double(total) : 0;
            std::fprintf(stderr, "\r\033[K%.*s: %3.0f %%, %.0f s left", int(what.size()), what.data(),
                         share * 100, done ? seconds * (1 - share) / share : 0.0);
        }
        std::fflush(stderr);
    };
}

void write_file(const std::string& path, const std::string& text) {
    if (path == "-") {
        write_output(text);   // main() sees whether it arrives
        return;
    }
    write_bytes(path, text);
}

}   // namespace rayclock
