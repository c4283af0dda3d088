#include "sim/image/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "sim/image/image.hpp"

namespace rayclock {
namespace fs = std::filesystem;

fs::path temporary_beside(const fs::path& target) {
    for (int i = 0;; ++i) {
        fs::path name = target;
        name.replace_filename(fmt::format(".{}.{}-{}.part", target.filename().string(), ::getpid(), i));
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(name, ignored))) return name;
    }
}

OutputFile::OutputFile(fs::path target) : target_(std::move(target)), temporary_(temporary_beside(target_)) {}

OutputFile::~OutputFile() {
    std::error_code ignored;
    if (!published_) fs::remove(temporary_, ignored);
}

void OutputFile::publish() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) throw UserError(fmt::format("{}: cannot be written: {}", target_.string(), error.message()));
    published_ = true;
}

void check_writable(const std::string& path) {
    if (path.empty()) throw UserError("the name of the file to write is empty");
    const fs::path target(path);
    std::error_code error;
    if (fs::is_directory(target, error) || !target.has_filename())
        throw UserError(fmt::format("{}: is a directory, not a file to write", path));
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::exists(folder, error))
        throw UserError(fmt::format("{}: the folder {} does not exist", path, folder.string()));
    if (!fs::is_directory(folder, error))
        throw UserError(fmt::format("{}: {} is not a folder", path, folder.string()));
    if (fs::exists(target, error) && ::access(path.c_str(), W_OK) != 0)
        throw UserError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
    // Only trying tells: permission bits do not know read-only file systems, nor do they bind every user.
    const fs::path probe = temporary_beside(target);
    const int file = ::open(probe.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0600);
    if (file < 0) throw UserError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
    ::close(file);
    fs::remove(probe, error);
}

} // namespace rayclock
