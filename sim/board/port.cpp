// Serial ports by termios.
#include "sim/board/port.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <fmt/format.h>

#include "model/base/quote.hpp"

namespace rayclock {

namespace {

constexpr std::pair<std::uint32_t, speed_t> rates[] = {
    {9600, B9600},       {19200, B19200},     {38400, B38400},     {57600, B57600},    {115200, B115200},
    {230400, B230400},   {460800, B460800},   {500000, B500000},   {921600, B921600},  {1000000, B1000000},
    {1500000, B1500000}, {2000000, B2000000}, {2500000, B2500000}, {3000000, B3000000}};

std::string error_text(int error) { return std::strerror(error); }

}   // namespace

std::string port_problem(const std::string& name, int error) {
    switch (error) {
        case ENOENT:
        case ENOTDIR: return name + ": there is no such port; is the board plugged in?";
        case EACCES:
        case EPERM:
            return name + ": no permission to open this port; on many systems the group dialout may open it";
        case EBUSY:
        case EWOULDBLOCK: return name + ": another program uses this port";
        case ENOTTY:
        case EISDIR: return name + ": this is not a serial port";
        case ENXIO:
        case ENODEV: return name + ": no device is behind this port; is the board plugged in?";
        default: return fmt::format("{}: this port cannot be opened ({})", name, error_text(error));
    }
}

Port::Port(const std::filesystem::path& path, std::uint32_t baud) : name_(printable(path.string())) {
    speed_t speed = B0;
    for (const auto& [rate, code] : rates)
        if (rate == baud) speed = code;
    if (speed == B0)
        throw UserError(
            fmt::format("{}: no serial port has {} baud; 115200 and 3000000 are usual", name_, baud));

    file_ = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0) throw UserError(port_problem(name_, errno));
    const auto refuse = [&](int error) {
        close(file_);
        file_ = -1;
        throw UserError(port_problem(name_, error));
    };
    if (!isatty(file_)) refuse(ENOTTY);
    char path_of_device[256] = "";
    is_pseudo_terminal_ = ttyname_r(file_, path_of_device, sizeof path_of_device) == 0 &&
                          std::string_view(path_of_device).starts_with("/dev/pts/");
    // TIOCEXCL keeps others from opening the port, except the superuser. The lock keeps out this program. A
    // pseudo-terminal would stay exclusive after a program that was killed, until its other end is closed.
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) refuse(errno);
    if (!is_pseudo_terminal_) ioctl(file_, TIOCEXCL);

    termios settings{};
    if (tcgetattr(file_, &settings) != 0) refuse(errno);
    cfmakeraw(&settings);
    settings.c_cflag &= tcflag_t(~(CSTOPB | CRTSCTS | PARENB));
    settings.c_cflag |= CS8 | CLOCAL | CREAD;
    settings.c_cc[VMIN] = 0;
    settings.c_cc[VTIME] = 0;
    if (cfsetspeed(&settings, speed) != 0 || tcsetattr(file_, TCSANOW, &settings) != 0) refuse(errno);
    // tcsetattr() succeeds if it could make any of the changes.
    termios taken{};
    if (tcgetattr(file_, &taken) != 0) refuse(errno);
    if (cfgetospeed(&taken) != speed) {
        close(file_);
        file_ = -1;
        throw UserError(fmt::format("{}: this port does not have {} baud", name_, baud));
    }
    tcflush(file_, TCIOFLUSH);
}

Port::~Port() {
    if (file_ < 0) return;
    if (!is_pseudo_terminal_) ioctl(file_, TIOCNXCL);
    close(file_);
}

LinkTime Port::now() {
    return std::chrono::duration_cast<LinkTime>(std::chrono::steady_clock::now().time_since_epoch());
}

Channel::Moved Port::exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) {
    const auto gone = [&](const std::string& how) {
        return LinkLost(fmt::format("{}: the port is gone ({}); plug the board in again", name_, how));
    };
    pollfd poller{file_, short(POLLIN | (out.empty() ? 0 : POLLOUT)), 0};
    const LinkTime end = now() + most;
    for (;;) {
        // Rounded up, so that a wait of less than a millisecond is not a busy loop.
        const auto left = std::max<std::int64_t>(0, (end - now()).count() + 999) / 1000;
        const int ready = poll(&poller, 1, int(std::min<std::int64_t>(left, 60'000)));
        if (ready < 0 && errno != EINTR) throw gone(error_text(errno));
        if (ready >= 0) break;
    }
    Moved moved;
    if (poller.revents & POLLIN) {
        const ssize_t bytes = ::read(file_, in.data(), in.size());
        if (bytes < 0 && errno != EAGAIN && errno != EINTR) throw gone(error_text(errno));
        if (bytes > 0) moved.read = std::size_t(bytes);
    }
    if (moved.read == 0 && (poller.revents & (POLLHUP | POLLERR | POLLNVAL))) throw gone("it was closed");
    if (poller.revents & POLLOUT) {
        const ssize_t bytes = ::write(file_, out.data(), out.size());
        if (bytes < 0 && errno != EAGAIN && errno != EINTR) throw gone(error_text(errno));
        if (bytes > 0) moved.written = std::size_t(bytes);
    }
    return moved;
}

}   // namespace rayclock
