#pragma once
// The temporary folder of a test.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include <stdlib.h>

namespace rayclock::test {

/// Returns the content of a file.
inline std::string content_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

/// A new temporary folder. The destructor removes it with its content.
class TestFolder {
public:
    TestFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "rayclock-test-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder can be made");
        path_ = name;
    }
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Returns the path of a file in the folder.
    std::string name(const std::string& file) const { return (path_ / file).string(); }
    /// Writes a file, and returns its path.
    std::string write(const std::string& file, const std::string& bytes) const {
        std::ofstream(path_ / file, std::ios::binary) << bytes;
        return name(file);
    }
    /// Returns every file and folder in it, including hidden ones, with the content of files.
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
            all[std::filesystem::relative(entry.path(), path_).string()] =
                entry.is_regular_file() ? content_of(entry.path().string()) : "folder";
        return all;
    }
    /// Returns the number of files and folders directly in it.
    int files() const {
        const std::filesystem::directory_iterator all(path_);
        return int(std::distance(begin(all), end(all)));
    }

private:
    std::filesystem::path path_;
};

}   // namespace rayclock::test
