#pragma once
// Reads a waveform that the program wrote, with GTKWave's own reader.
#include <map>
#include <set>
#include <string>

#include "sim/view/wave/fst.hpp"

namespace rayclock::test {

class Waveform {
public:
    explicit Waveform(const std::string& file) {
        std::string path;
        FstVisitor visitor;
        visitor.open_scope = [&](const std::string& name) { path += name + "."; };
        visitor.close_scope = [&] {
            path.pop_back();
            path.resize(path.rfind('.') + 1);
        };
        visitor.signal = [&](std::uint32_t signal, const std::string& name, int, bool) {
            signals_[path + name] = signal;
            names_.insert(path + name);
        };
        visitor.change = [&](std::uint64_t time, std::uint32_t signal, std::string_view value) {
            changes_[signal][time] = value;
            first_ = changes_.size() == 1 && changes_[signal].size() == 1 ? time : std::min(first_, time);
            last_ = std::max(last_, time);
        };
        read_fst(file, visitor);
    }
    const std::set<std::string>& names() const { return names_; }
    /// Returns the first name that contains `part`; empty if there is none.
    std::string name_with(const std::string& part) const {
        for (const std::string& name : names_)
            if (name.find(part) != std::string::npos) return name;
        return {};
    }
    std::uint64_t first() const { return first_; }
    std::uint64_t last() const { return last_; }
    /// Returns a signal's digits at a time.
    std::string at(const std::string& name, std::uint64_t time) const {
        const auto& changes = changes_.at(signals_.at(name));
        const auto next = changes.upper_bound(time);
        return next == changes.begin() ? "" : std::prev(next)->second;
    }

private:
    std::map<std::string, std::uint32_t> signals_;
    std::set<std::string> names_;
    std::map<std::uint32_t, std::map<std::uint64_t, std::string>> changes_;
    std::uint64_t first_ = 0, last_ = 0;
};

}   // namespace rayclock::test
