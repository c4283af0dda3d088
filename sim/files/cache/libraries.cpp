// The cache of built libraries on a POSIX file system: flock() for locks, rename() to publish.
#include "sim/files/cache/libraries.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/cache/hash.hpp"
#include "sim/files/input.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

constexpr const char* cure = "; set RAYCLOCK_CACHE to a folder that can be written";

[[noreturn]] void cannot(const fs::path& place, const char* what, const std::string& why) {
    throw UserError(fmt::format("{}: {} ({}){}", printable(place.string()), what, why, cure));
}

const char* variable(const char* name) {
    const char* value = std::getenv(name);
    return value && *value ? value : nullptr;
}

/// Returns true if only this user and root can write there. The cache of an installed program may belong to
/// root.
bool is_trusted(const struct stat& status) {
    return (status.st_uid == geteuid() || status.st_uid == 0) && (status.st_mode & 022) == 0;
}

/// Throws UserError if others can write to the folder: a library from the cache runs with this user's rights.
void check_trusted(const fs::path& folder, const char* why) {
    struct stat status {};
    if (stat(folder.c_str(), &status) != 0 || is_trusted(status)) return;
    const bool is_own = status.st_uid == geteuid();
    throw UserError(fmt::format(
        "{}: {}{}{}", printable(folder.string()), why,
        is_own ? fmt::format("others can write to this folder (mode {:o})", status.st_mode & 07777)
               : fmt::format("this folder belongs to another user ({})", status.st_uid),
        is_own ? "; remove that permission (chmod go-w), or set RAYCLOCK_CACHE to another folder" : cure));
}

/// Creates the temporary folder of this user. Throws UserError if it is a link or not this user's alone: in a
/// temporary directory, anybody may create a folder of a known name.
fs::path private_temporary() {
    const fs::path folder = fs::temp_directory_path() / fmt::format("rayclock-{}", geteuid());
    mkdir(folder.c_str(), 0700);
    if (fs::is_symlink(fs::symlink_status(folder)))
        throw UserError(fmt::format("{}: HOME is not set, and this is a link{}", folder.string(), cure));
    check_trusted(folder, "HOME is not set, and ");
    return folder;
}

bool is_plain_file(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() == fs::file_type::regular;
}

/// Returns all bytes of an ordinary file. Returns an empty string if it is not one or cannot be read.
std::string bytes_of(const fs::path& path) {
    return is_plain_file(path) ? read_if_there(path) : std::string{};
}

/// Returns the first lines of a seal. Further lines of a seal are a note for people.
std::string seal_of(const std::string& library) {
    return fmt::format("rayclock RTL 1\nsize {}\nhash {:016x}\n", library.size(), hash_of(library));
}

/// Returns the entry that a lock or a work folder belongs to. Its name is module-hash-hash.(lock|number).
/// Returns an empty string for any other name.
std::string entry_of(const std::string& name) {
    const std::size_t dot = name.find('.'), dash = name.find('-');
    if (dot == std::string::npos || dash > dot || !name.starts_with("rc_")) return {};
    const std::string end = name.substr(dot + 1), hash = name.substr(dash + 1, dot - dash - 1);
    if (end != "lock" && end.find_first_not_of("0123456789-") != std::string::npos) return {};
    if (end.empty() || hash.size() < 16 || hash.find_first_not_of("0123456789abcdef-") != std::string::npos)
        return {};
    return name.substr(0, dot);
}

/// Removes the files that builders left without holding their lock any more. Leaves what it cannot remove.
void sweep(const fs::path& cache) {
    std::error_code error;
    std::multimap<std::string, fs::path> left;
    for (fs::directory_iterator it(cache, error), end; !error && it != end; it.increment(error))
        if (const std::string entry = entry_of(it->path().filename()); !entry.empty())
            left.emplace(entry, it->path());
    for (auto it = left.begin(); it != left.end();) {
        const std::string entry = it->first;
        BuildLock lock(cache / entry);
        bool free = false;
        try {
            free = lock.take();
        } catch (const UserError&) {}   // a read-only cache holds no files of ours
        for (; it != left.end() && it->first == entry; ++it)
            if (free && it->second.extension() != ".lock") fs::remove_all(it->second, error);
    }
}

}   // namespace

CachePlace cache_place() {
    if (const char* chosen = variable("RAYCLOCK_CACHE"))
        return {fs::absolute(chosen).lexically_normal(), "RAYCLOCK_CACHE", {}};
    // The XDG specification says to ignore a relative path.
    if (const char* xdg = variable("XDG_CACHE_HOME"); xdg && fs::path(xdg).is_absolute())
        return {fs::path(xdg) / "rayclock", "XDG_CACHE_HOME", {}};
    if (const char* home = variable("HOME"); home && fs::path(home).is_absolute())
        return {fs::path(home) / ".cache/rayclock", "HOME", {}};
    const fs::path folder = private_temporary();
    return {folder, "",
            "HOME is not set, so built RTL is kept in " + folder.string() +
                ", among temporary files; RAYCLOCK_CACHE names a better folder"};
}

fs::path rtl_cache() {
    const CachePlace place = cache_place();
    static std::once_flag said;
    if (!place.warning.empty())
        std::call_once(said, [&] { fmt::print(stderr, "rayclock: {}\n", place.warning); });
    // Create it here with mode 0700, since a wide umask would let others in.
    std::error_code ignored;   // the code that writes there reports the error
    fs::create_directories(place.folder.parent_path(), ignored);
    mkdir(place.folder.c_str(), 0700);
    check_trusted(place.folder, "");
    return place.folder;
}

fs::path library_of(const fs::path& entry) {
    const std::string name = entry.filename();
    return entry / (name.starts_with(support_begin)   ? support_name
                    : name.starts_with(netlist_begin) ? "netlist.v"
                                                      : "module.so");
}

void write_text(const fs::path& path, const std::string& text) {
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) cannot(path, "cannot write the RTL cache here", std::strerror(errno ? errno : EIO));
}

void seal(const fs::path& folder, const std::string& made_by) {
    write_text(folder / "seal", seal_of(bytes_of(library_of(folder))) + made_by);
}

bool is_whole(const fs::path& entry) {
    std::error_code error;
    if (fs::symlink_status(entry, error).type() != fs::file_type::directory) return false;
    // A file in it may be older than the rights of the folder.
    for (const fs::path& part : {entry, entry / "seal", library_of(entry)})
        if (struct stat status{}; lstat(part.c_str(), &status) != 0 || !is_trusted(status)) return false;
    const std::string text = bytes_of(entry / "seal");
    if (text.empty() || !is_plain_file(library_of(entry))) return false;
    const std::string library = bytes_of(library_of(entry));
    return !library.empty() && text.starts_with(seal_of(library));
}

fs::path whole_entry(const std::string& begin) {
    std::error_code error;
    std::set<fs::path> entries;
    for (fs::directory_iterator it(rtl_cache(), error), end; !error && it != end; it.increment(error))
        if (const std::string name = it->path().filename();
            name.starts_with(begin) && name.find('.') == std::string::npos)
            entries.insert(it->path());
    for (const fs::path& entry : entries)
        if (is_whole(entry)) return entry;
    return {};
}

void open_cache() {
    static std::mutex mutex;
    static std::set<fs::path> swept;
    const fs::path folder = rtl_cache();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder, error))
        cannot(folder, "cannot make the RTL cache here", error ? error.message() : "no folder");
    const std::lock_guard lock(mutex);
    if (swept.insert(folder).second) sweep(folder);
}

void clear_place(const fs::path& place) {
    std::error_code error;
    fs::remove_all(place, error);
    if (error) cannot(place, "damaged, and cannot be removed", error.message());
}

bool BuildLock::take() {
    for (int attempt = 0; file_ < 0; ++attempt) {
        file_ = open(path_.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644);
        const int reason = errno;
        struct stat here {
        }, there{};
        const bool ordinary = file_ >= 0 && fstat(file_, &here) == 0 && S_ISREG(here.st_mode);
        if (ordinary && flock(file_, LOCK_EX | LOCK_NB) == 0) {
            // The previous holder may have removed the file: then the name no longer refers to this lock.
            if (lstat(path_.c_str(), &there) == 0 && there.st_ino == here.st_ino &&
                there.st_dev == here.st_dev)
                return true;
        } else if (ordinary) {
            close(std::exchange(file_, -1));
            return false;
        } else if (attempt > 2 || !fs::exists(fs::symlink_status(path_))) {
            if (file_ >= 0) close(std::exchange(file_, -1));
            cannot(path_, "cannot write the RTL cache here", std::generic_category().message(reason));
        } else {
            clear_place(path_);   // a folder, a link or a device
        }
        if (file_ >= 0) close(std::exchange(file_, -1));
    }
    return true;
}

BuildLock::~BuildLock() {
    if (file_ < 0) return;
    unlink(path_.c_str());
    flock(file_, LOCK_UN);   // a guard process may still hold the file open (process.hpp)
    close(file_);
}

WorkFolder::WorkFolder(const fs::path& entry) {
    static std::atomic<int> number = 0;
    path_ = entry.string() + fmt::format(".{}-{}", getpid(), number++);
    clear_place(path_);   // a dead builder may have used the same number
    // chmod() too: with a wide umask, mkdir() alone could leave the folder writable by a group.
    if (mkdir(path_.c_str(), 0755) != 0 || chmod(path_.c_str(), 0755) != 0)
        cannot(path_, "cannot write the RTL cache here", std::strerror(errno));
}

WorkFolder::~WorkFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
}

void WorkFolder::publish(const fs::path& entry) {
    std::error_code error;
    fs::rename(path_, entry, error);
    if (error) cannot(entry, "cannot write the RTL cache here", error.message());
    path_.clear();
}

}   // namespace rayclock
