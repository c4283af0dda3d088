#pragma once
// The fuzz targets: parsers by name, each with the requirements on everything that it accepts.
//
// A parser may throw UserError and nothing else. Any other exception, a sanitizer's finding, a failed
// requirement, or excessive time or memory is a finding of libFuzzer, which keeps the input.
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
void rays(std::string_view bytes);
void options(std::string_view bytes);
void board_link(std::string_view bytes);

/// Returns the path of a fuzzed file, in a folder with the files to which it may refer.
std::filesystem::path file(const std::string& name);

/// Ends the program unless `holds` is true.
void demand(bool holds, const char* claim);

/// Requires a single sentence that is safe for a terminal.
void check_sentence(const std::string& sentence);

/// Returns false if the call refuses its input with a proper sentence.
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
