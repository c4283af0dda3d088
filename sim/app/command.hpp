#pragma once
// A command of the program: its name, its help, its options and its work.
#include <functional>
#include <memory>
#include <string>

#include "sim/app/parser.hpp"

namespace rayclock {

struct Command {
    std::string name;
    const char* what;   ///< it does, for the help
    const char* example;
    std::function<void(Parser&)> declare;   ///< its options
    std::function<int()> run;   ///< the exit code: 0 good, 1 a check failed; throws UserError for exit 2
};

/// A command with options of a type of its own, which keep what was typed.
template <class Options> Command command(const char* name, const char* what, const char* example,
                                         void (*declare)(Parser&, Options&), int (*run)(const Options&)) {
    const auto options = std::make_shared<Options>();
    return {name, what, example, [=](Parser& parser) { declare(parser, *options); },
            [=] { return run(*options); }};
}

}   // namespace rayclock
