#pragma once
// The exception for work that a signal stopped.
#include <stdexcept>

namespace rayclock {

/// Reports that Ctrl-C or SIGTERM stopped the work. The text says which results are kept. The program prints
/// the text and exits with 1.
class Interrupted : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}   // namespace rayclock
