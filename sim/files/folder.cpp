// NewFolder and StagedFiles: a temporary folder of the name `.rayclock-<pid>-<i>.part`, then rename().
#include "sim/files/folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/input_registry.hpp"
#include "sim/files/output.hpp"

namespace rayclock {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse_folder(const std::string& path, const std::string& why) {
    throw UserError(fmt::format("{}: {}", printable(path), why));
}

/// Writes a new file and creates its parent folders. Error messages call it `shown`. Throws UserError if it
/// cannot write.
void write_into(const fs::path& file, const fs::path& shown, std::string_view bytes) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (error || !stream)
        refuse_folder(shown.string(), fmt::format("cannot be written: {}", std::strerror(error ? error.value()
                                                                                         : errno ? errno
                                                                                                 : EIO)));
}

}   // namespace

NewFolder::NewFolder(const std::string& path) : path_(path) {
    if (path.empty()) throw UserError("the name of the folder to write is empty");
    if (path.find('\0') != path.npos) refuse_folder(path, "the name has a zero byte in it");
    target_ = fs::path(path).lexically_normal();
    if (!target_.has_filename()) target_ = target_.parent_path();   // drop a trailing slash
    std::error_code error;
    const fs::file_status status = fs::symlink_status(target_, error);
    if (fs::is_symlink(status)) refuse_folder(path, "is a symbolic link; name the folder that it points to");
    if (fs::exists(status) && !fs::is_directory(status))
        refuse_folder(path, "is a file, not a folder to write");
    if (fs::exists(status) && (!fs::is_empty(target_, error) || error))
        refuse_folder(path, "is not empty; name a new folder");
    if (!target_.has_filename() || target_.filename() == "." || target_.filename() == "..")
        refuse_folder(path, "cannot be replaced; name a new folder");
    const fs::path parent = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::is_directory(parent, error))
        refuse_folder(path, fmt::format("the folder {} does not exist", printable(parent.string())));
    for (int i = 0; temporary_.empty(); ++i) {
        const fs::path name = parent / fmt::format(".rayclock-{}-{}.part", ::getpid(), i);
        if (::mkdir(name.c_str(), 0777) == 0)
            temporary_ = name;
        else if (errno != EEXIST)
            refuse_folder(path, fmt::format("cannot be written: {}", std::strerror(errno)));
    }
    scratch_.name(temporary_);
}

NewFolder::~NewFolder() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void NewFolder::write(const std::string& name, std::string_view bytes) const {
    write_into(temporary_ / name, fs::path(path_) / name, bytes);
}

void NewFolder::publish() {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0)
        refuse_folder(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
    temporary_.clear();
}

StagedFiles::StagedFiles(const std::string& folder) : folder_(fs::absolute(folder).lexically_normal()) {
    if (!folder_.has_filename()) folder_ = folder_.parent_path();   // drop a trailing slash
    for (fs::path place = folder_; !fs::exists(place) && place.has_relative_path();
         place = place.parent_path())
        made_ = place;
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) refuse_folder(folder, "cannot be made (" + error.message() + ")");
    for (int i = 0; stage_.empty(); ++i) {
        const fs::path name = folder_ / fmt::format(".rayclock-{}-{}.part", ::getpid(), i);
        if (::mkdir(name.c_str(), 0777) == 0)
            stage_ = name;
        else if (errno != EEXIST)
            refuse_folder(folder, fmt::format("cannot be written: {}", std::strerror(errno)));
    }
    scratch_.name(stage_);
}

StagedFiles::~StagedFiles() {
    std::error_code ignored;
    fs::remove_all(stage_, ignored);
    if (made_.empty()) return;
    for (fs::path place = folder_; fs::remove(place, ignored) && place != made_;) place = place.parent_path();
}

void StagedFiles::publish(const std::vector<std::string>& outdated) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(stage_))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) check_writable((folder_ / name).string());
    scratch_.forget();
    made_.clear();
    for (const std::string& name : names) {
        const std::string path = (folder_ / name).string();
        if (::rename((stage_ / name).c_str(), path.c_str()) != 0)
            refuse_folder(path, fmt::format("cannot be written: {}", std::strerror(errno)));
        forget_output(path);
    }
    std::error_code ignored;
    for (const std::string& name : outdated) fs::remove(folder_ / name, ignored);
    // The folder is empty now, and forget() took it off the list that a signal handler removes.
    fs::remove(stage_, ignored);
}

}   // namespace rayclock
