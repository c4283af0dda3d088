#pragma once
// The folder into which a command writes its pictures.
#include <string>
#include <vector>

#include "sim/files/folder.hpp"
#include "sim/files/image/image.hpp"

namespace rayclock {

struct NamedPicture {
    std::string name;   ///< "model.png"
    const Picture& picture;
    const HitFrame& hits;
};

/// Fails early (UserError) if files of these names could not be written to the folder later. Makes nothing:
/// the work may still fail.
void check_picture_folder(const std::string& folder, const std::vector<std::string>& names);

/// Writes the pictures to where they wait for others. Throws UserError.
void write_pictures(const StagedFiles& staged, const std::vector<NamedPicture>& pictures);

/// Makes the folder and writes the pictures, all of them or none. Throws UserError.
void write_pictures(const std::string& folder, const std::vector<NamedPicture>& pictures);

/// "out/model.png out/rtl.png"
std::string picture_paths(const std::string& folder, const std::vector<NamedPicture>& pictures);

}   // namespace rayclock
