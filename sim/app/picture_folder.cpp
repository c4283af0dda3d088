#include "sim/app/picture_folder.hpp"

#include <filesystem>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

namespace fs = std::filesystem;

void check_picture_folder(const std::string& folder, const std::vector<std::string>& names) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        throw UserError(folder + ": is a file, not a folder for pictures");
    const std::string ending = fs::path(folder).extension().string();
    if (!fs::exists(folder, error) && (ending == ".png" || ending == ".exr"))
        throw UserError("-o: " + shown(folder) + " is the name of a picture, and a folder is asked for");
    fs::path there = fs::absolute(folder);
    while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
    for (const std::string& name : names) check_writable((there / name).string());
}

void write_pictures(const std::string& folder, const std::vector<NamedPicture>& pictures) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw UserError(folder + ": cannot be made (" + error.message() + ")");
    for (const NamedPicture& p : pictures)
        write_picture((fs::path(folder) / p.name).string(), p.picture, p.hits);
}

std::string picture_paths(const std::string& folder, const std::vector<NamedPicture>& pictures) {
    std::string paths;
    for (const NamedPicture& p : pictures)
        paths += (paths.empty() ? "" : " ") + printable(folder) + "/" + p.name;
    return paths;
}

}   // namespace rayclock
