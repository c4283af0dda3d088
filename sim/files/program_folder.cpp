// The place of this code on the disk.
#include "sim/files/program_folder.hpp"

#include <dlfcn.h>
#include <link.h>

namespace rayclock {

namespace fs = std::filesystem;

std::filesystem::path program_folder() {
    std::error_code error;
    Dl_info info{};
    void* extra = nullptr;
    const auto here = reinterpret_cast<const void*>(&program_folder);
    if (dladdr1(here, &info, &extra, RTLD_DL_LINKMAP) != 0 && extra) {
        const char* name = static_cast<const link_map*>(extra)->l_name;   // empty for the program
        if (name && *name) return fs::canonical(name, error).parent_path();
    }
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

}   // namespace rayclock
