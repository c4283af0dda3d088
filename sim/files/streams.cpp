// Guarding the standard streams with POSIX calls, and remembering the first error of a write.
#include "sim/files/streams.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace rayclock {

void guard_streams() {
    // Opened for the opposite direction on purpose: reading and writing still fail, as on a closed stream.
    for (const int stream : {0, 1, 2})
        if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF)
            (void)::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
    // Install an empty handler instead of SIG_IGN: child programs would inherit SIG_IGN.
    struct sigaction nothing {};
    nothing.sa_handler = [](int) {};
    nothing.sa_flags = SA_RESTART;
    ::sigaction(SIGPIPE, &nothing, nullptr);
    ::sigaction(SIGXFSZ, &nothing, nullptr);
}

namespace {

int first_error = 0;   // errno of the first failed write_output()

}   // namespace

void write_output(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() && first_error == 0)
        first_error = errno;
}

std::string finish_output() {
    errno = 0;
    const bool had_error = std::ferror(stdout) != 0;
    // close() instead of fclose(): std::cout is flushed once more when the program ends.
    const bool has_arrived = std::fflush(stdout) == 0 && ::close(STDOUT_FILENO) == 0;
    if (has_arrived && !had_error) return {};
    if (first_error != 0) return std::strerror(first_error);
    return errno != 0 ? std::strerror(errno) : "something printed was lost";
}

}   // namespace rayclock
