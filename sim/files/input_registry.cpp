// The register of inputs and outputs: two maps under one mutex.
#include "sim/files/input_registry.hpp"

#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

#include <sys/stat.h>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {
namespace {

/// Files by device and inode, because one file may have many names. The value is the name that the user
/// typed.
using Files = std::map<std::pair<dev_t, ino_t>, std::string>;
std::mutex mutex;
Files inputs, outputs;

std::pair<dev_t, ino_t> key_of(const struct stat& file) { return {file.st_dev, file.st_ino}; }

/// Returns the registered name of a file. Drops a stale entry, whose name now leads to another file: the
/// system reuses inodes.
const std::string* name_in(Files& files, const struct stat& file) {
    const auto found = files.find(key_of(file));
    if (found == files.end()) return nullptr;
    struct stat now {};
    if (::stat(found->second.c_str(), &now) == 0 && key_of(now) == found->first) return &found->second;
    files.erase(found);
    return nullptr;
}

[[noreturn]] void refuse(const std::string& output, const std::string& input) {
    throw UserError(fmt::format("{}: the output would replace {}; name another file", printable(output),
                                input == output ? "an input" : "the input " + printable(input)));
}

}   // namespace

void note_input(const std::string& path, const struct stat& file) {
    const std::lock_guard lock(mutex);
    if (const std::string* const output = name_in(outputs, file)) refuse(*output, path);
    inputs.insert_or_assign(key_of(file), path);
}

void note_output(const std::string& path) {
    struct stat file {};
    if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return;
    const std::lock_guard lock(mutex);
    if (const std::string* const input = name_in(inputs, file)) refuse(path, *input);
    outputs.insert_or_assign(key_of(file), path);
}

void forget_output(const std::string& path) {
    const auto place = [](const std::string& name) {
        return std::filesystem::absolute(name).lexically_normal();
    };
    const std::lock_guard lock(mutex);
    std::erase_if(outputs, [&](const auto& output) { return place(output.second) == place(path); });
}

}   // namespace rayclock
