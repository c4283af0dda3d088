#pragma once
#include <stdexcept>

namespace rayclock {

/// The work was stopped by whoever asked for it; the text says what is kept of it. The program prints it and
/// exits with 1.
class Interrupted : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}   // namespace rayclock
