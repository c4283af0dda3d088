#pragma once
// Units with one fault at one output, for tests of elastic verification.
#include <string>
#include <utility>
#include <vector>

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

/// Builds the RTL with a module in place of a unit's while it lives. The module comes from a file, contains
/// the project's unit and a fault at one of its outputs, or is the project's with some texts replaced.
class OtherUnit {
public:
    OtherUnit(const std::string& unit, const std::string& file);
    explicit OtherUnit(const FaultyUnit& faulty);
    /// Each text must occur once.
    OtherUnit(const std::string& unit, const std::vector<std::pair<std::string, std::string>>& changes);
    ~OtherUnit();
    OtherUnit(const OtherUnit&) = delete;

private:
    void use(const std::string& unit, const std::string& text);

    std::string file_;   // to be removed
};

}   // namespace rayclock::test
