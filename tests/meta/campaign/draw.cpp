// Draws faults at random, one operator after the other.
#include "tests/meta/campaign/draw.hpp"

namespace rayclock::campaign {

Draw::Draw(std::vector<Mutant> all, std::uint64_t seed) : rng_(seed) {
    for (Mutant& m : all) by_operator_[m.fault.what].push_back(std::move(m));
}

std::optional<Mutant> Draw::next() {
    if (by_operator_.empty()) return {};
    auto it = by_operator_.upper_bound(last_operator_);
    if (it == by_operator_.end()) it = by_operator_.begin();
    last_operator_ = it->first;
    auto& list = it->second;
    const auto at = std::size_t(rng_.below(int(list.size())));
    Mutant m = std::move(list[at]);
    list.erase(list.begin() + std::ptrdiff_t(at));
    if (list.empty()) by_operator_.erase(it);
    m.number = ++drawn_;
    return m;
}

}   // namespace rayclock::campaign
