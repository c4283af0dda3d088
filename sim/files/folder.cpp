#include "sim/files/folder.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw UserError(fmt::format("{}: {}", printable(path), why));
}

}   // namespace

NewFolder::NewFolder(const std::string& path) : path_(path) {
    if (path.empty()) throw UserError("the name of the folder to write is empty");
    if (path.find('\0') != path.npos) refuse(path, "the name has a zero byte in it");
    target_ = fs::path(path).lexically_normal();
    if (!target_.has_filename()) target_ = target_.parent_path();   // a slash at the end
    std::error_code error;
    const fs::file_status status = fs::symlink_status(target_, error);
    if (fs::is_symlink(status)) refuse(path, "is a symbolic link; name the folder that it points to");
    if (fs::exists(status) && !fs::is_directory(status)) refuse(path, "is a file, not a folder to write");
    if (fs::exists(status) && (!fs::is_empty(target_, error) || error))
        refuse(path, "is not empty; name a new folder");
    if (!target_.has_filename() || target_.filename() == "." || target_.filename() == "..")
        refuse(path, "cannot be replaced; name a new folder");
    const fs::path parent = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::is_directory(parent, error))
        refuse(path, fmt::format("the folder {} does not exist", printable(parent.string())));
    for (int i = 0; temporary_.empty(); ++i) {
        const fs::path name = parent / fmt::format(".rayclock-{}-{}.part", ::getpid(), i);
        if (::mkdir(name.c_str(), 0777) == 0)
            temporary_ = name;
        else if (errno != EEXIST)
            refuse(path, fmt::format("cannot be written: {}", std::strerror(errno)));
    }
}

NewFolder::~NewFolder() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void NewFolder::write(const std::string& name, std::string_view bytes) const {
    const fs::path file = temporary_ / name;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (error || !stream)
        refuse((fs::path(path_) / name).string(),
               fmt::format("cannot be written: {}", std::strerror(error   ? error.value()
                                                                  : errno ? errno
                                                                          : EIO)));
}

void NewFolder::publish() {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0)
        refuse(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
    temporary_.clear();
}

}   // namespace rayclock
