#pragma once
// Temporary files for parsers that read a file by name.
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace rayclock::fuzz {

/// Writes a file with these bytes in memory, to spare the disk.
inline std::string scratch_file(const std::string& name, std::string_view bytes) {
    const std::string file = "/dev/shm/rc_fuzz-" + std::to_string(::getpid()) + "-" + name;
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    static const bool is_removed =
        std::atexit([] {
            for (const char* left : {"part.json", "report", "fuzzed.npy", "fuzzed.rays"})
                ::unlink(("/dev/shm/rc_fuzz-" + std::to_string(::getpid()) + "-" + left).c_str());
        }) == 0;
    (void)is_removed;
    return file;
}

}   // namespace rayclock::fuzz
