#pragma once
// Temporary files and folders, and their removal when the program ends early.
#include <cstddef>
#include <filesystem>
#include <string>

namespace rayclock {

/// Registers a file or folder that must be removed if a signal ends the program before this object. The
/// signal handler calls remove_scratch(); a program that is killed (SIGKILL) leaves the file.
class Scratch {
public:
    Scratch() = default;
    explicit Scratch(const std::filesystem::path& path) { name(path); }
    ~Scratch() { forget(); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    /// Registers `path` in place of the previous one.
    void name(const std::filesystem::path& path);
    /// Withdraws the registration, because the file was removed or renamed.
    void forget();

private:
    static constexpr std::size_t none = std::size_t(-1);
    std::size_t slot_ = none;
};

/// Removes all files and folders that a Scratch registers. Signal handlers may call it: it allocates nothing.
void remove_scratch() noexcept;

/// A new temporary folder that only this user may enter. The destructor removes it. It lies in `parent`, or
/// in the system's temporary folder if `parent` is empty. Throws UserError if it cannot be made.
class TemporaryFolder {
public:
    explicit TemporaryFolder(const std::string& prefix, const std::filesystem::path& parent = {});
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    Scratch scratch_;
};

}   // namespace rayclock
