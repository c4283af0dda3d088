// Builds the timing graph of an SDF file, and finds the latest arrival at each register pin.
#include "sim/silicon/chip/timing.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "sim/files/text.hpp"

namespace rayclock::chip {

namespace {

/// A pin of a cell at which a delay begins or ends.
struct Pin {
    int cell = 0;
    bool is_clock = false, goes_on = false, has_setup = false;
    double setup = 0;
    int waits = 0;   ///< incoming delays that have not been followed yet
    /// The latest arrival from a register, in nanoseconds. Negative if no register leads here.
    double arrival = -1;
    int edge = -1;   ///< the incoming delay of the latest arrival
};
struct Edge {
    int from = 0, to = 0;
    double ns = 0;
    bool in_cell = false;
};

bool is_clock(std::string_view pin) {
    return pin == "CLK" || pin == "WCK" || pin == "CLKA" || pin == "CLKB" ||
           (pin.size() == 4 && pin.starts_with("CLK") && pin[3] >= '0' && pin[3] <= '3');
}

/// Returns the slowest delay of "(200:218:236)", which is in picoseconds, in nanoseconds.
double slowest(std::string_view triple) {
    const std::size_t last = triple.rfind(':');
    if (last == std::string_view::npos) throw std::runtime_error("a delay of nextpnr's is not a triple");
    return std::atof(std::string(triple.substr(last + 1)).c_str()) / 1000;
}

class Graph {
public:
    explicit Graph(std::string_view sdf) {
        while (!sdf.empty()) read(take_line(sdf));
        if (edges_.empty()) throw std::runtime_error("there are no delays in what nextpnr has written");
        follow();
    }

    /// Returns all pins with a setup requirement, the latest first.
    std::vector<int> ends() const {
        std::vector<int> all;
        for (int p = 0; p < int(pins_.size()); ++p) {
            const Pin& pin = pins_[std::size_t(p)];
            const bool held = pin.has_setup || (!pin.goes_on && clocked_.contains(pin.cell));
            const bool is_input = pin.edge >= 0 && !edges_[std::size_t(pin.edge)].in_cell;
            if (held && is_input && !pin.is_clock) all.push_back(p);
        }
        std::stable_sort(all.begin(), all.end(), [&](int a, int b) { return delay(a) > delay(b); });
        return all;
    }

    Path path_to(int end) const {
        Path path;
        path.ns = delay(end);
        path.logic = pins_[std::size_t(end)].setup;
        path.to = cells_[std::size_t(pins_[std::size_t(end)].cell)];
        int pin = end;
        for (int e = pins_[std::size_t(end)].edge; e >= 0; e = pins_[std::size_t(pin)].edge) {
            const Edge& edge = edges_[std::size_t(e)];
            if (edge.in_cell) path.logic += edge.ns, ++path.levels;
            pin = edge.from;
            if (pins_[std::size_t(pin)].is_clock) break;
        }
        --path.levels;   // do not count the register itself
        path.from = cells_[std::size_t(pins_[std::size_t(pin)].cell)];
        return path;
    }

private:
    double delay(int p) const { return pins_[std::size_t(p)].arrival + pins_[std::size_t(p)].setup; }

    /// Reads one line, which holds one delay or the name of the cell that the next delays belong to.
    void read(std::string_view line) {
        const std::string_view kind = take_word(line);
        if (kind == "(INSTANCE") {
            instance_ = unescaped(strip(take_word(line)));
        } else if (kind == "(INTERCONNECT") {
            const int from = pin_of(unescaped(take_word(line))), to = pin_of(unescaped(take_word(line)));
            add({from, to, slowest_of(line), false});
        } else if (kind == "(IOPATH") {
            const std::string from = unescaped(take_word(line)), to = unescaped(take_word(line));
            const int begin = pin_of(instance_ + "/" + from);
            if (is_clock(from)) clocked_.insert(pins_[std::size_t(begin)].cell);
            add({begin, pin_of(instance_ + "/" + to), slowest_of(line), true});
        } else if (kind == "(SETUPHOLD") {
            take_word(line);   // (posedge
            const std::string_view name = take_word(line);
            take_word(line), take_word(line);   // (posedge CLK)
            Pin& pin =
                pins_[std::size_t(pin_of(instance_ + "/" + unescaped(name.substr(0, name.size() - 1))))];
            pin.has_setup = true;
            pin.setup = std::max(pin.setup, slowest(strip(take_word(line))));
            clocked_.insert(pin.cell);
        }
    }

    static std::string_view strip(std::string_view triple) { return triple.substr(0, triple.find(')')); }
    /// Returns the slower of the rising and the falling edge.
    static double slowest_of(std::string_view line) {
        const double rise = slowest(strip(take_word(line)));
        return std::max(rise, slowest(strip(take_word(line))));
    }
    static std::string unescaped(std::string_view name) {
        std::string plain;
        for (const char c : name)
            if (c != '\\') plain += c;
        return plain;
    }

    int pin_of(const std::string& name) {
        const auto [at, is_new] = pin_names_.emplace(name, int(pins_.size()));
        if (!is_new) return at->second;
        const std::size_t slash = name.rfind('/');
        if (slash == std::string::npos) throw std::runtime_error("a pin of nextpnr's has no cell");
        const auto [cell, new_cell] = cell_names_.emplace(name.substr(0, slash), int(cells_.size()));
        if (new_cell) cells_.push_back(cell->first);
        pins_.push_back({cell->second, is_clock(std::string_view(name).substr(slash + 1))});
        return at->second;
    }
    void add(const Edge& edge) {
        edges_.push_back(edge);
        pins_[std::size_t(edge.from)].goes_on = true;
        ++pins_[std::size_t(edge.to)].waits;
    }

    /// Follows a pin's delays after all delays that lead to it. A path from a register begins at its clock
    /// pin, at time 0.
    void follow() {
        std::vector<std::vector<int>> out(pins_.size());
        for (int e = 0; e < int(edges_.size()); ++e)
            out[std::size_t(edges_[std::size_t(e)].from)].push_back(e);
        std::vector<int> ready;
        for (int p = 0; p < int(pins_.size()); ++p)
            if (pins_[std::size_t(p)].waits == 0) ready.push_back(p);
        while (!ready.empty()) {
            const Pin from = pins_[std::size_t(ready.back())];
            const std::vector<int>& ways = out[std::size_t(ready.back())];
            ready.pop_back();
            for (const int e : ways) {
                const Edge& edge = edges_[std::size_t(e)];
                Pin& to = pins_[std::size_t(edge.to)];
                const double begin = from.is_clock ? 0 : from.arrival;
                if (begin >= 0 && begin + edge.ns > to.arrival) to.arrival = begin + edge.ns, to.edge = e;
                if (--to.waits == 0) ready.push_back(edge.to);
            }
        }
    }

    std::vector<Pin> pins_;
    std::vector<Edge> edges_;
    std::vector<std::string> cells_;
    std::unordered_map<std::string, int> pin_names_, cell_names_;
    std::unordered_set<int> clocked_;   ///< cells with a clock pin
    std::string instance_;
};

}   // namespace

std::vector<Path> slowest_paths(std::string_view sdf, std::size_t most,
                                const std::function<std::string(const Path&)>& same) {
    const Graph graph(sdf);
    std::vector<Path> paths;
    std::set<std::string> seen;
    for (const int end : graph.ends()) {
        if (paths.size() == most) break;
        const Path path = graph.path_to(end);
        if (seen.insert(same(path)).second) paths.push_back(path);
    }
    return paths;
}

}   // namespace rayclock::chip
