#pragma once
// The folder to which a command writes its pictures.
#include <string>
#include <vector>

#include "sim/files/folder.hpp"
#include "sim/files/image/image.hpp"

namespace rayclock {

/// A picture with its file name.
struct NamedPicture {
    std::string name;   ///< "model.png"
    const Picture& picture;
    const HitFrame& hits;
};

/// Throws UserError if files of these names could not be written to the folder later. Creates nothing,
/// because the work may still fail.
void check_picture_folder(const std::string& folder, const std::vector<std::string>& names);

/// Writes the pictures to the staging folder. Throws UserError.
void write_pictures(const StagedFiles& staged, const std::vector<NamedPicture>& pictures);

/// Creates the folder and writes all pictures or none. Throws UserError.
void write_pictures(const std::string& folder, const std::vector<NamedPicture>& pictures);

/// Returns the paths: "out/model.png out/rtl.png"
std::string picture_paths(const std::string& folder, const std::vector<NamedPicture>& pictures);

}   // namespace rayclock
