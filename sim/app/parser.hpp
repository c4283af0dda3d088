#pragma once
// The options of one command, as it declares them. Only parser.cpp knows the library that reads the command
// line.
#include <string>

namespace CLI {
class App;
class Option;
}   // namespace CLI

namespace rayclock {

/// An option that has been declared, for what else there is to say about it.
class Declared {
public:
    explicit Declared(CLI::Option* option) : option_(option) {}

    Declared& required();
    /// The help shows the value that it has now.
    Declared& with_default();
    Declared& within(int least, int most);
    /// Several values in one word, with commas between them.
    Declared& by_commas();
    /// The help lists it under this heading.
    Declared& under(const char* heading);
    /// Not together with the other.
    Declared& excludes(const Declared& other);

private:
    CLI::Option* option_;
};

class Parser {
public:
    explicit Parser(CLI::App& app) : app_(app) {}

    /// `names`: "--size", "-o,--output", or "SCENE" for a word without a name. Values are strings, whole
    /// numbers, numbers, lists of strings, and what may be missing (std::optional) of these; parser.cpp lists
    /// them.
    template <class Value> Declared option(const char* names, Value& value, const char* help);
    Declared flag(const char* names, bool& value, const char* help);

private:
    CLI::App& app_;
};

}   // namespace rayclock
