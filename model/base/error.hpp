#pragma once
#include <stdexcept>

namespace rayclock {

/// Something the user gave us makes no sense: a file, a flag, a size, a configuration.
/// The text is one sentence naming file, line and value; the program prints it and exits with 2.
class UserError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}   // namespace rayclock
