#include "sim/load/file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "model/core/error.hpp"
#include "sim/load/text.hpp"

namespace rayclock {

std::string read_file(const std::filesystem::path& path) {
    const Place at{path.string()};
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) at.refuse("there is no such file");
    if (error) at.refuse("cannot be read (" + error.message() + ")");
    if (std::filesystem::is_directory(status)) at.refuse("is a directory, not a file");
    // A pipe or a device may never end, and cannot be read twice.
    if (!std::filesystem::is_regular_file(status)) at.refuse("is not an ordinary file");

    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) at.refuse(std::string("cannot be read (") + std::strerror(errno) + ")");
    std::string bytes(static_cast<std::size_t>(std::filesystem::file_size(path, error)), '\0');
    if (error) at.refuse("cannot be read (" + error.message() + ")");
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
    if (std::ferror(file.get())) at.refuse(std::string("cannot be read (") + std::strerror(errno) + ")");
    if (bytes.empty()) at.refuse("the file is empty");
    return bytes;
}

std::string extension(const std::filesystem::path& path) {
    const std::string dotted = lower(path.extension().string());
    return dotted.empty() ? dotted : dotted.substr(1);
}

} // namespace rayclock
