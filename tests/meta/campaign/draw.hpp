#pragma once
// Faults in the order in which a seed draws them: the operators in turn, and of each operator's faults any.
#include <map>
#include <optional>

#include "model/base/rng.hpp"
#include "tests/meta/campaign/schema.hpp"

namespace rayclock::campaign {

class Draw {
public:
    Draw(std::vector<Mutant> all, std::uint64_t seed);
    /// The next one, numbered from 1 on; none if all are drawn.
    std::optional<Mutant> next();

private:
    Rng rng_;
    std::map<std::string, std::vector<Mutant>> by_operator_;
    std::string last_operator_;
    int drawn_ = 0;
};

}   // namespace rayclock::campaign
