// What is fuzzed: parsers by name, each with what must hold of all that it lets pass.
//
// A parser may throw UserError and nothing else. Any other exception, a sanitizer's finding, a broken demand,
// too much time or too much memory is a finding of libFuzzer, which keeps the input.
#pragma once
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>

#include "model/base/error.hpp"

namespace rayclock::fuzz {

void obj(std::string_view bytes);
void mtl(std::string_view bytes);
void ply(std::string_view bytes);
void stl(std::string_view bytes);
void off(std::string_view bytes);
void tds(std::string_view bytes);
void dae(std::string_view bytes);
void gz(std::string_view bytes);
void gltf(std::string_view bytes);
void scene(std::string_view bytes);
void config(std::string_view bytes);
void state(std::string_view bytes);
void cache(std::string_view bytes);
void merge(std::string_view bytes);
void compare(std::string_view bytes);
void yosys(std::string_view bytes);
void nextpnr(std::string_view bytes);
void options(std::string_view bytes);

/// The name of a fuzzed file, in a folder that holds what such a file may refer to.
std::filesystem::path file(const std::string& name);

/// Ends the program unless it holds.
void demand(bool holds, const char* claim);

/// One sentence, fit for a terminal.
void check_sentence(const std::string& sentence);

/// False if what is called refuses its input, with a proper sentence.
template <class Call> bool passes(const Call& call) {
    try {
        call();
        return true;
    } catch (const UserError& error) {
        check_sentence(error.what());
        return false;
    }
}

}   // namespace rayclock::fuzz
