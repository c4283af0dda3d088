// Writing to a temporary file `.rayclock-<pid>-<i>.part`, then fsync() if requested, then rename().
#include "sim/files/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/input_registry.hpp"
#include "sim/files/scratch.hpp"

namespace rayclock {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse_file(const std::string& path, const std::string& why) {
    throw UserError(fmt::format("{}: {}", printable(path), why));
}
[[noreturn]] void not_written(const std::string& path, int error) {
    refuse_file(path, std::string("cannot be written: ") + std::strerror(error));
}

/// Writes all bytes. Returns 0 or the error number.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Flushes a file to the disk. Returns 0 too if the file system does not support it.
int sync(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno; }

/// Writes all bytes and closes the file in any case. Returns the first error number, or 0.
int write_and_close(int file, std::string_view bytes, Durable durable) {
    int error = write_all(file, bytes);
    if (error == 0 && durable == Durable::yes) error = sync(file);
    if (::close(file) != 0 && error == 0) error = errno;
    return error;
}

/// A temporary file next to `target`. The destructor removes it unless rename_to() succeeded.
class Temporary {
public:
    explicit Temporary(const fs::path& target) {
        for (int i = 0; file < 0; ++i) {
            name = fs::path(target)
                       .replace_filename(fmt::format(".rayclock-{}-{}.part", ::getpid(), i))
                       .string();
            file = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
            if (file < 0 && errno != EEXIST) not_written(target.string(), errno);
        }
        scratch_.name(name);
    }
    ~Temporary() {
        if (!name.empty()) ::unlink(name.c_str());
    }
    Temporary(const Temporary&) = delete;

    /// Returns 0 or the error number.
    int rename_to(const std::string& path) {
        if (::rename(name.c_str(), path.c_str()) != 0) return errno;
        name.clear();
        return 0;
    }

    std::string name;
    int file = -1;

private:
    Scratch scratch_;
};

/// Returns true if `path` is a device or a pipe, which is written in place. Throws UserError if it is neither
/// that nor an ordinary file nor a new name.
bool is_in_place(const std::string& path) {
    struct stat itself {
    }, status{};
    if (path.find('\0') != path.npos) refuse_file(path, "the name has a zero byte in it");
    if (::lstat(path.c_str(), &itself) != 0 || ::stat(path.c_str(), &status) != 0) status.st_mode = S_IFREG;
    if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode))
        return true;   // also through a link: /dev/stdout is one
    if (S_ISLNK(itself.st_mode)) refuse_file(path, "is a symbolic link; name the file that it points to");
    if (S_ISDIR(status.st_mode)) refuse_file(path, "is a directory, not a file to write");
    if (!S_ISREG(status.st_mode)) refuse_file(path, "is neither an ordinary file nor a pipe to write to");
    return false;
}

/// Writes to a device or a pipe. Throws UserError at once if nobody reads the pipe, instead of waiting for a
/// reader.
void write_in_place(const std::string& path, std::string_view bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (file < 0 && errno == ENXIO) refuse_file(path, "is a pipe that nobody reads");
    if (file < 0) not_written(path, errno);
    ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
    if (const int error = write_and_close(file, bytes, Durable::no)) not_written(path, error);
}

}   // namespace

void check_writable(const std::string& path) {
    if (path.empty()) throw UserError("the name of the file to write is empty");
    const fs::path target(path);
    if (!target.has_filename()) refuse_file(path, "is a directory, not a file to write");
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::error_code error;
    if (!fs::exists(folder, error))
        refuse_file(path, fmt::format("the folder {} does not exist", printable(folder.string())));
    if (!fs::is_directory(folder, error))
        refuse_file(path, fmt::format("{} is not a folder", printable(folder.string())));
    const bool in_place = is_in_place(path);
    if (fs::exists(target, error) && ::access(path.c_str(), W_OK) != 0) not_written(path, errno);
    if (in_place) return;
    note_output(path);
    // Create a file to find out: permission bits do not show read-only file systems, and do not bind root.
    const Temporary probe(target);
    ::close(probe.file);
}

void check_replaceable(const std::string& path) {
    check_writable(path);
    if (is_in_place(path)) refuse_file(path, "is a device or a pipe, not an ordinary file");
}

void write_bytes(const std::string& path, std::string_view bytes, Durable durable) {
    check_writable(path);
    if (is_in_place(path)) return write_in_place(path, bytes);
    Temporary temporary(path);
    int error = write_and_close(temporary.file, bytes, durable);
    if (error == 0) error = temporary.rename_to(path);
    if (error != 0) not_written(path, error);
    forget_output(path);
}

}   // namespace rayclock
