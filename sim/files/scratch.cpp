// The register of temporary files: an array of atomic pointers, which a signal handler can read.
#include "sim/files/scratch.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {
namespace fs = std::filesystem;
namespace {

/// Registered paths. There are more slots than tools that run at one time. A path that finds no slot is
/// removed only by its owner.
std::atomic<char*> slots[64];

/// Removes a folder by starting `rm`: walking a folder in this process would allocate memory.
void remove_folder(char* path) noexcept {
    const pid_t child = ::fork();
    if (child == 0) {
        ::execl("/bin/rm", "rm", "-rf", "--", path, static_cast<char*>(nullptr));
        ::_exit(1);
    }
    while (child > 0 && ::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {}
}

}   // namespace

void Scratch::name(const fs::path& path) {
    forget();
    char* const copy = ::strdup(fs::absolute(path).c_str());
    for (std::size_t i = 0; copy && i < std::size(slots); ++i)
        if (char* free = nullptr; slots[i].compare_exchange_strong(free, copy)) {
            slot_ = i;
            return;
        }
    std::free(copy);
}

void Scratch::forget() {
    if (slot_ != none) std::free(slots[slot_].exchange(nullptr));
    slot_ = none;
}

void remove_scratch() noexcept {
    for (std::atomic<char*>& slot : slots)
        if (char* const path = slot.exchange(nullptr); path && ::unlink(path) != 0 && errno != ENOENT)
            remove_folder(path);   // does not free `path`: free() is not safe in a signal handler
}

TemporaryFolder::TemporaryFolder(const std::string& prefix, const fs::path& parent) {
    std::error_code error;
    const fs::path place = parent.empty() ? fs::temp_directory_path(error) : parent;
    std::string name = (place / (prefix + "-XXXXXX")).string();
    if (error || !::mkdtemp(name.data()))
        throw UserError(fmt::format("{}: no folder can be made there for temporary files ({}){}",
                                    printable(error ? "TMPDIR" : place.string()),
                                    error ? error.message() : std::strerror(errno),
                                    parent.empty() ? "; set TMPDIR to another" : ""));
    path_ = name;
    scratch_.name(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}   // namespace rayclock
