#pragma once
// Writing several files that belong together: either all of them appear, or none does.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/scratch.hpp"

namespace rayclock {

/// Writes a folder under a temporary name next to its target and renames it when it is published. The
/// destructor removes a folder that was not published.
class NewFolder {
public:
    /// Throws UserError unless `path` names a new or an empty folder in an existing folder.
    explicit NewFolder(const std::string& path);
    ~NewFolder();
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    /// Writes a file into the folder. Creates the folders that `name` leads through. Throws UserError if it
    /// cannot write.
    void write(const std::string& name, std::string_view bytes) const;
    /// Renames the folder to its final name. Throws UserError if it cannot.
    void publish();

private:
    std::string path_;   ///< as the caller gave it
    std::filesystem::path target_, temporary_;
    Scratch scratch_;
};

/// Writes files for a folder that may already hold other files and older versions of the same files. The
/// files go to a staging folder inside it first, and move out once all of them are complete. If they are not
/// published, the destructor restores the folder.
class StagedFiles {
public:
    /// Creates the folder if it does not exist. Throws UserError if it cannot.
    explicit StagedFiles(const std::string& folder);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// The folder to write files into until they are published.
    const std::filesystem::path& stage() const { return stage_; }
    /// Moves all staged files to the folder, where they replace files of the same names. Then removes the
    /// `outdated` files from the folder. Throws UserError if it cannot write.
    void publish(const std::vector<std::string>& outdated = {});

private:
    /// `made_`: the topmost folder that had to be created, or empty.
    std::filesystem::path folder_, made_, stage_;
    Scratch scratch_;
};

}   // namespace rayclock
