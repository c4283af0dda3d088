#pragma once
// Units with one fault at one output, for tests of elastic verification.
#include <string>

namespace rayclock::test {

/// A fault. `number` counts the transfers at the output from 0.
enum class Fault {
    value,   ///< one bit is wrong, from transfer `number` on
    lost,    ///< transfer `number` does not happen
    twice,   ///< transfer `number` happens twice
};
struct FaultyUnit {
    std::string unit;   ///< "tri"
    std::string port;   ///< "rsp"
    Fault fault;
    int number = 0;
    int bit = 0;   ///< of the payload, the lowest is 0
};
std::string name_of(const FaultyUnit& faulty);

/// Builds the RTL with a module in place of a unit's while it lives. The module comes from a file, or
/// contains the project's unit and a fault at one of its outputs.
class OtherUnit {
public:
    OtherUnit(const std::string& unit, const std::string& file);
    explicit OtherUnit(const FaultyUnit& faulty);
    ~OtherUnit();
    OtherUnit(const OtherUnit&) = delete;

private:
    std::string file_;   // to be removed
};

}   // namespace rayclock::test
