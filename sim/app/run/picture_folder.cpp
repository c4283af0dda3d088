// Checks and writes folders of pictures.
#include "sim/app/run/picture_folder.hpp"

#include <filesystem>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

namespace fs = std::filesystem;

void check_picture_folder(const std::string& folder, const std::vector<std::string>& names) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        throw UserError(printable(folder) + ": is a file, not a folder for pictures");
    const std::string ending = fs::path(folder).extension().string();
    if (!fs::exists(folder, error) && (ending == ".png" || ending == ".exr"))
        throw UserError("-o: " + shown(folder) + " names a picture, but a folder is required");
    fs::path there = fs::absolute(folder);
    while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
    for (const std::string& name : names) check_writable((there / name).string());
}

void write_pictures(const StagedFiles& staged, const std::vector<NamedPicture>& pictures) {
    const std::string stage = staged.stage().string(), folder = staged.stage().parent_path().string();
    for (const NamedPicture& p : pictures) try {
            write_picture((fs::path(stage) / p.name).string(), p.picture, p.hits);
        } catch (const UserError& error) {
            // Replace the temporary path of the picture in the message by its final path.
            std::string sentence = error.what();
            if (const std::size_t at = sentence.find(stage); at != sentence.npos)
                sentence.replace(at, stage.size(), folder);
            throw UserError(sentence);
        }
}

void write_pictures(const std::string& folder, const std::vector<NamedPicture>& pictures) {
    StagedFiles staged(folder);
    write_pictures(staged, pictures);
    staged.publish();
}

std::string picture_paths(const std::string& folder, const std::vector<NamedPicture>& pictures) {
    std::string paths;
    for (const NamedPicture& p : pictures)
        paths += (paths.empty() ? "" : " ") + printable(folder) + "/" + p.name;
    return paths;
}

}   // namespace rayclock
