#pragma once
// Serial ports and pseudo-terminals as a channel to the board.
#include <filesystem>
#include <string>

#include "sim/board/link.hpp"

namespace rayclock {

/// A serial port or a pseudo-terminal: eight bits, no parity, one stop bit, no flow control, every byte as it
/// is. Only one program can have it open at a time.
class Port : public Channel {
public:
    /// Opens a port at a rate in bits per second, up to 3,000,000, and discards bytes that wait in it. A
    /// pseudo-terminal takes any of these rates. Throws UserError if the port is missing, is not a
    /// terminal or lacks the rate. Throws it too if the user may not open it or another program uses it.
    Port(const std::filesystem::path& path, std::uint32_t baud);
    ~Port() override;
    Port(const Port&) = delete;

    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) override;
    LinkTime now() override;
    const std::string& name() const { return name_; }
    /// True if a program is at the other end, and not a cable. A board behind it may be simulated.
    bool is_pseudo_terminal() const { return is_pseudo_terminal_; }

private:
    std::string name_;
    int file_ = -1;
    bool is_pseudo_terminal_ = false;
};

/// Returns the sentence for a port that cannot be opened, from the error number of the system.
std::string port_problem(const std::string& name, int error);

}   // namespace rayclock
