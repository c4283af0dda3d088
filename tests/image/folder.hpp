#pragma once
// A temporary folder for pictures.
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "model/base/error.hpp"
#include "sim/files/image/image.hpp"

namespace rayclock {

/// A new folder that is deleted with its content.
class TestFolder {
public:
    TestFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "rayclock-image-XXXXXX").string();
        REQUIRE(::mkdtemp(pattern.data()) != nullptr);
        path_ = pattern;
    }
    ~TestFolder() { std::filesystem::remove_all(path_); }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    const std::filesystem::path& path() const { return path_; }
    int files() const {
        const std::filesystem::directory_iterator all(path_);
        return static_cast<int>(std::distance(begin(all), end(all)));
    }

private:
    std::filesystem::path path_;
};

/// Returns the message of a UserError; empty if the call succeeds.
template <typename Call> std::string complaint(const Call& call) {
    try {
        call();
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

inline Picture grey_picture(FrameSize size, float value) {
    return {size,
            std::vector<glm::vec3>(static_cast<std::size_t>(size.width) * size.height, glm::vec3(value))};
}

inline HitFrame no_hits(FrameSize size) {
    return {size, std::vector<Hit>(static_cast<std::size_t>(size.width) * size.height)};
}

}   // namespace rayclock
