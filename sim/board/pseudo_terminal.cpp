// Pseudo-terminals of POSIX, and a link to one.
#include "sim/board/pseudo_terminal.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/uio.h>
#include <termios.h>
#include <unistd.h>

#include <fmt/format.h>

#include "model/base/quote.hpp"

namespace rayclock {

namespace {

namespace fs = std::filesystem;

}   // namespace

PseudoTerminal::PseudoTerminal(const fs::path& link) {
    const auto refuse = [&](const std::string& what) {
        if (file_ >= 0) close(file_);
        throw UserError(what);
    };
    file_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    char name[256] = "";
    // The terminal must not echo what the board sends before a program has opened it.
    termios settings{};
    bool is_good = file_ >= 0 && grantpt(file_) == 0 && unlockpt(file_) == 0 &&
                   ptsname_r(file_, name, sizeof name) == 0 && tcgetattr(file_, &settings) == 0;
    if (is_good) {
        cfmakeraw(&settings);
        int packet_mode = 1;
        is_good = tcsetattr(file_, TCSANOW, &settings) == 0 && ioctl(file_, TIOCPKT, &packet_mode) == 0;
    }
    if (!is_good) refuse(fmt::format("there is no pseudo-terminal for the board: {}", std::strerror(errno)));
    name_ = name;
    if (link.empty()) return;
    std::error_code error;
    if (fs::exists(fs::symlink_status(link, error)))
        refuse(fmt::format("{}: this exists already; give a new name for the board's port, or remove it",
                           printable(link.string())));
    fs::create_symlink(name_, link, error);
    if (error) refuse(fmt::format("{}: {}", printable(link.string()), error.message()));
    link_ = link;
    scratch_.name(fs::absolute(link));
}

PseudoTerminal::~PseudoTerminal() {
    std::error_code ignored;
    if (!link_.empty()) fs::remove(link_, ignored);
    close(file_);
}

bool PseudoTerminal::is_left() const {
    pollfd poller{file_, 0, 0};
    return poll(&poller, 1, 0) > 0 && (poller.revents & POLLHUP);
}

std::size_t PseudoTerminal::read(std::span<std::uint8_t> in) {
    // In packet mode a byte precedes the data. It is 0, or it reports an event, and then no data follow.
    std::uint8_t what = 0;
    const iovec parts[] = {{&what, 1}, {in.data(), in.size()}};
    const ssize_t bytes = readv(file_, parts, 2);
    if (bytes <= 0) return 0;
    if (what & (TIOCPKT_FLUSHREAD | TIOCPKT_FLUSHWRITE)) was_flushed_ = true;
    return std::size_t(bytes) - 1;
}

std::size_t PseudoTerminal::write(std::span<const std::uint8_t> out) {
    const ssize_t bytes = out.empty() ? 0 : ::write(file_, out.data(), out.size());
    return bytes > 0 ? std::size_t(bytes) : 0;
}

void PseudoTerminal::wait(LinkTime most) {
    pollfd poller{file_, POLLIN | POLLPRI, 0};
    const auto milliseconds = int(most.count() / 1000);
    // While no program has the terminal open, each poll returns at once.
    if (poll(&poller, 1, milliseconds) > 0 && (poller.revents & POLLHUP)) std::this_thread::sleep_for(most);
}

}   // namespace rayclock
