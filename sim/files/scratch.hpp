#pragma once
// What the program writes under temporary names, and how it disappears.
#include <cstddef>
#include <filesystem>
#include <string>

namespace rayclock {

/// Names a file or folder that is to disappear if the program is ended before this object is. Ended by
/// remove_scratch(), that is: a program that is killed (SIGKILL) leaves it.
class Scratch {
public:
    Scratch() = default;
    explicit Scratch(const std::filesystem::path& path) { name(path); }
    ~Scratch() { forget(); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    void name(const std::filesystem::path& path);
    /// The name was removed or renamed.
    void forget();

private:
    static constexpr std::size_t none = std::size_t(-1);
    std::size_t slot_ = none;
};

/// Removes all that is named by a Scratch. For handlers of signals: it allocates nothing.
void remove_scratch() noexcept;

/// A new folder among the temporary files that belongs to this user alone, removed in the end. `beside` is
/// another folder to make it in. Throws UserError if it cannot be made.
class TemporaryFolder {
public:
    explicit TemporaryFolder(const std::string& prefix, const std::filesystem::path& beside = {});
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    Scratch scratch_;
};

}   // namespace rayclock
