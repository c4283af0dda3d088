// Reading a whole file through one descriptor, so that the checks and the bytes concern the same file.
#include "sim/files/input.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/input_registry.hpp"
#include "sim/files/text.hpp"

namespace rayclock {
namespace {

class Reader {
public:
    Reader(const std::filesystem::path& path, const std::string& asked_by)
        : at_{path.string()}, asked_by_(asked_by) {
        if (path.native().find('\0') != std::string::npos) refuse("the name has a zero byte in it");
        // O_NONBLOCK: opening a pipe would otherwise wait for a writer. The type of the opened file is
        // checked rather than that of the name, because the name may come to mean another file.
        file_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
        if (file_ < 0 && errno == ENOENT) refuse("there is no such file");
        if (file_ < 0 && errno == ENXIO) refuse("is not an ordinary file");
        if (file_ < 0) refuse(std::string("cannot be read (") + std::strerror(errno) + ")");
    }
    ~Reader() {
        if (file_ >= 0) ::close(file_);
    }
    Reader(const Reader&) = delete;

    std::string all(std::uint64_t most, Owner owner) const {
        struct stat status {};
        if (::fstat(file_, &status) != 0)
            refuse(std::string("cannot be read (") + std::strerror(errno) + ")");
        if (S_ISDIR(status.st_mode)) refuse("is a directory, not a file");
        if (!S_ISREG(status.st_mode)) refuse("is not an ordinary file");
        if (owner == Owner::user) note_input(at_.file, status);
        const auto size = static_cast<std::uint64_t>(status.st_size);
        if (size > most) refuse(fmt::format("has {} bytes; the most is {}", size, most));
        std::string bytes(size, '\0');
        std::size_t have = 0;
        while (have < bytes.size()) {
            const ssize_t got = ::read(file_, bytes.data() + have, bytes.size() - have);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) refuse(std::string("cannot be read (") + std::strerror(errno) + ")");
            if (got == 0) break;
            have += static_cast<std::size_t>(got);
        }
        bytes.resize(have);
        if (bytes.empty()) refuse("the file is empty");
        return bytes;
    }

private:
    [[noreturn]] void refuse(const std::string& sentence) const {
        at_.refuse(asked_by_.empty() ? sentence
                                     : fmt::format("{} ({} asks for it)", sentence, printable(asked_by_)));
    }

    SourcePosition at_;
    const std::string& asked_by_;
    int file_ = -1;
};

}   // namespace

std::string read_file(const std::filesystem::path& path, const std::string& asked_by, std::uint64_t most,
                      Owner owner) {
    return Reader(path, asked_by).all(most, owner);
}

std::string read_if_there(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::string bytes(error ? 0 : std::size_t(size), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), std::streamsize(bytes.size()));
    bytes.resize(std::size_t(std::max<std::streamsize>(0, file.gcount())));
    return bytes;
}

std::string extension(const std::filesystem::path& path) {
    const std::string dotted = lower(path.extension().string());
    return dotted.empty() ? dotted : dotted.substr(1);
}

}   // namespace rayclock
