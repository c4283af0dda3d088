#pragma once
// Writing several files that belong together: they appear together or not at all.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/scratch.hpp"

namespace rayclock {

/// A folder that is written under a temporary name beside its own, and renamed in the end. If it is not
/// published, nothing of it stays.
class NewFolder {
public:
    /// Throws UserError unless `path` is the name of a new folder, or of an empty one.
    explicit NewFolder(const std::string& path);
    ~NewFolder();
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    /// A file in it; `name` may lead through folders, which are made. Throws UserError.
    void write(const std::string& name, std::string_view bytes) const;
    /// Gives the folder its name. Throws UserError.
    void publish();

private:
    std::string path_;   ///< as it was given
    std::filesystem::path target_, temporary_;
    Scratch scratch_;
};

/// Files for a folder that may hold others, and older ones of the same names. They are written to a folder of
/// their own in it, and moved out in the end, once all of them are whole. If they are not published, the
/// folder is as it was.
class StagedFiles {
public:
    /// Makes the folder if it is not there. Throws UserError.
    explicit StagedFiles(const std::string& folder);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Where files are written until they are published.
    const std::filesystem::path& stage() const { return stage_; }
    /// Moves all files to the folder, where they replace those of the same names; then removes `outdated`
    /// ones there. Throws UserError.
    void publish(const std::vector<std::string>& outdated = {});

private:
    std::filesystem::path folder_, made_, stage_;   ///< made_: the first folder that was not there
    Scratch scratch_;
};

}   // namespace rayclock
