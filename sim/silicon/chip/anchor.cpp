// Exchanges the sites of multipliers and block memories to shorten wires.
#include "sim/silicon/chip/anchor.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string_view>

#include "model/base/error.hpp"

namespace rayclock::chip {

namespace fs = std::filesystem;

namespace {

constexpr const char* kinds[] = {"MULT18X18D", "DP16KD"};
constexpr int rounds = 3;                // cells that move in one round attract others in the next
constexpr std::size_t max_ends = 3000;   // larger nets are left out: the clock's net has wires of its own

struct Point {
    int x = 0, y = 0;
};
struct Bounds {
    int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
    void add(Point p) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    bool empty() const { return right < 0; }
    int half() const { return empty() ? 0 : right - left + bottom - top; }
    /// Returns the growth of half the perimeter if this point is added.
    int growth(Point p) const {
        if (empty()) return 0;
        return std::max({left - p.x, p.x - right, 0}) + std::max({top - p.y, p.y - bottom, 0});
    }
};

/// Cells by number, their positions, and the cells of each net.
class Wiring {
public:
    explicit Wiring(const std::vector<Cell>& cells) {
        for (std::size_t c = 0; c < cells.size(); ++c) {
            Point at;
            std::sscanf(cells[c].bel.c_str(), "X%d/Y%d/", &at.x, &at.y);
            at_.push_back(at);
            for (const int net : cells[c].nets) ends_[net].push_back(c);
        }
        std::erase_if(ends_, [](const auto& net) { return net.second.size() > max_ends; });
    }

    Point at(std::size_t cell) const { return at_[cell]; }
    void move(std::size_t cell, Point to) { at_[cell] = to; }

    long long length() const {
        long long sum = 0;
        for (const auto& [net, ends] : ends_) {
            Bounds bounds;
            for (const std::size_t end : ends) bounds.add(at_[end]);
            sum += bounds.half();
        }
        return sum;
    }
    /// Returns the wire length that the cell would add at each of these places, with all other cells fixed.
    std::vector<long long> costs(const Cell& placed, std::size_t cell,
                                 const std::vector<Point>& places) const {
        std::vector<long long> sums(places.size());
        for (const int net : placed.nets) {
            const auto found = ends_.find(net);
            if (found == ends_.end()) continue;
            Bounds others;
            for (const std::size_t end : found->second)
                if (end != cell) others.add(at_[end]);
            for (std::size_t p = 0; p < places.size(); ++p) sums[p] += others.growth(places[p]);
        }
        return sums;
    }

private:
    std::vector<Point> at_;
    std::map<int, std::vector<std::size_t>> ends_;
};

/// Returns the place of each cell, given as many places as cells. Exchanges pairs until no exchange lowers
/// the cost.
std::vector<std::size_t> exchanged(const std::vector<std::vector<long long>>& cost) {
    std::vector<std::size_t> takes(cost.size());
    for (std::size_t i = 0; i < takes.size(); ++i) takes[i] = i;
    for (bool better = true; better;) {
        better = false;
        for (std::size_t i = 0; i < takes.size(); ++i)
            for (std::size_t j = i + 1; j < takes.size(); ++j) {
                if (cost[i][takes[j]] + cost[j][takes[i]] >= cost[i][takes[i]] + cost[j][takes[j]]) continue;
                std::swap(takes[i], takes[j]);
                better = true;
            }
    }
    return takes;
}

/// Returns the word of a line `  "word": {` of a netlist in Yosys's format; empty for other lines.
std::string_view opened(std::string_view line) {
    const std::size_t begin = line.find('"');
    if (begin == std::string_view::npos || !line.ends_with("\": {")) return {};
    return line.substr(begin + 1, line.size() - begin - 5);
}

}   // namespace

long long wire_length(const std::vector<Cell>& cells) { return Wiring(cells).length(); }

Sites anchors(const std::vector<Cell>& cells) {
    Wiring wiring(cells);
    std::vector<std::string> bels;
    for (const Cell& cell : cells) bels.push_back(cell.bel);
    Sites sites;
    for (int round = 0; round < rounds; ++round)
        for (const char* kind : kinds) {
            std::vector<std::size_t> movable;
            std::vector<Point> places;
            std::vector<std::string> names;
            for (std::size_t c = 0; c < cells.size(); ++c)
                if (cells[c].type == kind)
                    movable.push_back(c), places.push_back(wiring.at(c)), names.push_back(bels[c]);
            std::vector<std::vector<long long>> cost;
            for (const std::size_t c : movable) cost.push_back(wiring.costs(cells[c], c, places));
            const std::vector<std::size_t> takes = exchanged(cost);
            const long long before = wiring.length();
            for (std::size_t i = 0; i < movable.size(); ++i) wiring.move(movable[i], places[takes[i]]);
            // Two connected cells may have taken each other's place, so the exchange can make wires longer.
            const bool better = wiring.length() < before;
            for (std::size_t i = 0; i < movable.size(); ++i) {
                const std::size_t place = better ? takes[i] : i;
                wiring.move(movable[i], places[place]);
                bels[movable[i]] = sites[cells[movable[i]].name] = names[place];
            }
        }
    return sites;
}

Sites anchors_of(const fs::path& placed) {
    std::vector<Cell> cells;
    const bool whole = read_cells(placed.string(), [&](const Cell& cell) {
        if (!cell.bel.empty()) cells.push_back(cell);
    });
    if (!whole)
        throw UserError(placed.filename().string() + " of nextpnr-ecp5 is not whole; is the disk full?");
    return anchors(cells);
}

void write_anchored(const fs::path& netlist, const fs::path& to, const Sites& sites) {
    std::ifstream in(netlist);
    std::ofstream out(to);
    std::size_t written = 0;
    auto cell = sites.end();
    bool here = false;   // the cell's attributes begin here
    for (std::string line; std::getline(in, line);) {
        const std::size_t first = line.find_first_not_of(' ');
        if (here) {
            const bool only = first != std::string::npos && line[first] == '}';
            out << "\"BEL\": \"" << cell->second << (only ? "\"\n" : "\",\n");
            ++written;
            cell = sites.end();
            here = false;
        }
        out << line << '\n';
        const std::string_view word = opened(line);
        if (word.empty()) continue;
        if (word == "attributes" && cell != sites.end()) {
            here = true;
        } else if (const auto found = sites.find(std::string(word)); found != sites.end()) {
            cell = found;
        }
    }
    out.close();
    if (!in.eof() || !out || written != sites.size())
        throw UserError(to.filename().string() + " cannot be written whole; is the disk full?");
}

}   // namespace rayclock::chip
