#pragma once
// The refusals of a function under test.
#include <string>

#include "model/base/error.hpp"

namespace rayclock::test {

/// Returns the message of a UserError; empty if the call succeeds.
template <typename Call> std::string complaint(const Call& call) {
    try {
        call();
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

}   // namespace rayclock::test
