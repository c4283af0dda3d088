// Finding and loading the library of picture formats with dlopen().
#include "sim/files/image/codec.hpp"

#include <filesystem>
#include <new>
#include <vector>

#include <dlfcn.h>

#include "model/base/error.hpp"
#include "sim/files/program_folder.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

constexpr const char* file_name = "rayclock_pictures.so";

/// Returns the places to search: next to the program or the Python module, the library folder of an
/// installation around it, and the build tree.
std::vector<fs::path> places() {
    const fs::path own = program_folder();
    std::vector<fs::path> all{own / file_name};
    for (fs::path place = own; place.has_relative_path(); place = place.parent_path())
        all.push_back(place.parent_path() / RAYCLOCK_LIBRARY_DIR / "rayclock" / file_name);
    all.push_back(fs::path(RAYCLOCK_CODEC_DIR) / file_name);
    return all;
}

const PictureCodec& load() {
    std::string complaint = "it is missing";
    for (const fs::path& place : places()) {
        std::error_code error;
        if (!fs::exists(place, error)) continue;
        if (void* library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL))
            if (const void* codec = dlsym(library, "rayclock_picture_codec"))
                return *static_cast<const PictureCodec*>(codec);
        complaint = dlerror();
        // The dynamic loader's messages when address space runs out.
        for (const char* words : {"failed to map segment", "annot allocate memory", "annot create"})
            if (complaint.find(words) != complaint.npos) throw std::bad_alloc();
        break;
    }
    throw UserError(std::string("pictures cannot be read or written without the program's library ") +
                    file_name + ": " + complaint);
}

const PictureCodec* stand_in = nullptr;

}   // namespace

const PictureCodec& picture_codec() {
    if (stand_in) return *stand_in;
    static const PictureCodec& codec = load();
    return codec;
}

StandInCodec::StandInCodec(const PictureCodec& codec) { stand_in = &codec; }
StandInCodec::~StandInCodec() { stand_in = nullptr; }

}   // namespace rayclock
