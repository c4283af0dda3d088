// Writes the golden pictures: the reference tracer's view of every scene in golden_scenes.hpp.
//
//     golden_make FOLDER
//
// It refuses to replace a picture: delete a picture to update it. It checks nothing;
// tests/image/golden_test.cpp checks, and writes nothing. After a run, look at the pictures and update
// PROVENANCE.md.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "sim/files/image/golden.hpp"
#include "tests/support/scenes/golden_scenes.hpp"

namespace {

using namespace rayclock;

/// Returns false if the picture already exists.
bool make(const std::string& folder, const char* spec) {
    const std::string path = golden_path(folder, spec, golden_size);
    if (std::filesystem::exists(path)) {
        std::fprintf(stderr, "%s: exists already and is left alone; delete it to have it made anew\n",
                     path.c_str());
        return false;
    }
    const Scene scene = golden_scene(spec);
    const HitFrame hits = Reference(scene).frame(*scene.camera, golden_size);
    write_picture(path, shade(scene, hits), hits);
    std::printf("%s\n", path.c_str());
    return true;
}

}   // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: golden_make FOLDER\n");
        return 2;
    }
    try {
        bool all_made = true;
        for (const char* spec : golden_scenes) all_made = make(argv[1], spec) && all_made;
        return all_made ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
