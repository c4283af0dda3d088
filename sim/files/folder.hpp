#pragma once
// Writing whole folders: one appears complete or not at all.
#include <filesystem>
#include <string>
#include <string_view>

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
};

}   // namespace rayclock
