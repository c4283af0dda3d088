#pragma once
#include <filesystem>

namespace rayclock {

/// A file that appears whole or not at all: written under a temporary name in the same folder, then renamed.
/// Unless publish() is reached, the temporary file is removed and whatever stood at `target` is untouched.
class OutputFile {
public:
    explicit OutputFile(std::filesystem::path target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::filesystem::path& temporary() const { return temporary_; }

    /// Throws UserError if the file cannot take its place.
    void publish();

private:
    std::filesystem::path target_, temporary_;
    bool published_ = false;
};

/// A name next to `target` that no file has; nothing is created.
std::filesystem::path temporary_beside(const std::filesystem::path& target);

} // namespace rayclock
