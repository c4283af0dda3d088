#pragma once
// Runs the torture set on one called mutant after the other, each in a process of its own, so that a crash is
// a verdict as well.
#include <functional>

#include "sim/explore/torture/torture.hpp"
#include "tests/meta/campaign/state.hpp"

/// The model's fault that is awake; 0: none.
extern int rc_fault;

namespace rayclock::campaign {

class TortureJudge {
public:
    /// `chips`: of torture_chips(), those that are run, in this order. `records` what rays do, once for all
    /// faults of the RTL; for faults of the model nothing must have been worked out before they wake.
    TortureJudge(const std::vector<std::string>& chips, bool records);
    Verdict operator()(int seconds_at_most) const;
    /// The same with a fault of the model awake, so that what rays do is recorded anew.
    Verdict with_fault(int number, int seconds_at_most) const;

private:
    struct Prepared {
        TortureCase torture;
        std::vector<RecordedFrame> frames;
    };
    std::vector<Prepared> cases_;
};

/// Runs `work` in a child, for so many seconds of the processor at most. It returns whether it noticed a
/// fault, and sets its argument to what it saw, or to what it does, in case it does not come back. The
/// verdict's seconds are the processor's.
Verdict in_child(const std::function<bool(std::string&)>& work, int seconds_at_most);

}   // namespace rayclock::campaign
