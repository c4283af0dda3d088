#pragma once
// The exception for wrong input.
#include <stdexcept>

namespace rayclock {

/// Reports input that makes no sense: a file, a flag, a size or a configuration. The text is one sentence
/// that names file, line and value. The program prints it and exits with 2.
class UserError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}   // namespace rayclock
