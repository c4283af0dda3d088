#pragma once
// A command of the program: its name, help, options and work.
#include <functional>
#include <memory>
#include <string>

#include "sim/app/options/parser.hpp"

namespace rayclock {

/// A command.
struct Command {
    std::string name;
    const char* what;   ///< the command's purpose, for the help
    const char* example;
    std::function<void(Parser&)> declare;   ///< declares its options
    /// Returns the exit code: 0 for success, 1 if a check failed. Throws UserError for exit code 2.
    std::function<int()> run;
};

/// Returns a command with its own type of options, which store what was typed.
template <class Options> Command command(const char* name, const char* what, const char* example,
                                         void (*declare)(Parser&, Options&), int (*run)(const Options&)) {
    const auto options = std::make_shared<Options>();
    return {name, what, example, [=](Parser& parser) { declare(parser, *options); },
            [=] { return run(*options); }};
}

}   // namespace rayclock
