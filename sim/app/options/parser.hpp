#pragma once
// Declares the options of one command. Only parser.cpp uses the library that reads the command line.
#include <string>

namespace CLI {
class App;
class Option;
}   // namespace CLI

namespace rayclock {

/// A declared option, for further properties.
class DeclaredOption {
public:
    explicit DeclaredOption(CLI::Option* option) : option_(option) {}

    DeclaredOption& required();
    /// Shows its current value as default in the help.
    DeclaredOption& with_default();
    DeclaredOption& within(int least, int most);
    /// Accepts several values in one word, separated by commas.
    DeclaredOption& by_commas();
    /// Accepts the option without a value too, which then means `implied`.
    DeclaredOption& or_alone(const char* implied);
    /// Accepts one value each time that the option is given, so that SCENE may follow.
    DeclaredOption& one_each();
    /// Lists the option under this heading of the help.
    DeclaredOption& under(const char* heading);
    /// Refuses the option together with another.
    DeclaredOption& excludes(const DeclaredOption& other);

private:
    CLI::Option* option_;
};

/// Declares options.
class Parser {
public:
    explicit Parser(CLI::App& app) : app_(app) {}

    /// Declares an option. `names` is "--size", "-o,--output", or "SCENE" for a positional word. Values are
    /// strings, whole numbers, numbers, lists of strings, or std::optional of these; parser.cpp lists the
    /// types.
    template <class Value> DeclaredOption option(const char* names, Value& value, const char* help);
    DeclaredOption flag(const char* names, bool& value, const char* help);

private:
    CLI::App& app_;
};

}   // namespace rayclock
