#pragma once
// The other end of a serial port: a pseudo-terminal, through which programs reach a simulated board.
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include "sim/board/link.hpp"
#include "sim/files/scratch.hpp"

namespace rayclock {

/// A pseudo-terminal with a name that other programs open like a serial port, one after the other. It passes
/// every byte as it is.
class PseudoTerminal {
public:
    /// `link`: a symbolic link to make to the terminal; empty: none. The destructor removes it. So does a
    /// signal that ends the program. Throws UserError if the file exists, or if the system has no terminal
    /// left.
    explicit PseudoTerminal(const std::filesystem::path& link = {});
    ~PseudoTerminal();
    PseudoTerminal(const PseudoTerminal&) = delete;

    const std::string& name() const { return name_; }   ///< "/dev/pts/5"

    /// True from the moment when the last program has closed the terminal until another opens it.
    bool is_left() const;
    /// Reads bytes that were sent. Does not wait. Returns their number.
    std::size_t read(std::span<std::uint8_t> in);
    /// True once after a program has flushed the terminal, as Port does when it opens it. Bytes that read()
    /// returns from then on are that program's.
    bool was_flushed() { return std::exchange(was_flushed_, false); }
    /// Sends bytes, as many as the terminal takes at once. Returns their number.
    std::size_t write(std::span<const std::uint8_t> out);
    /// Waits until there are bytes to read, but not longer than `most`.
    void wait(LinkTime most);

private:
    std::string name_;
    int file_ = -1;
    bool was_flushed_ = false;
    std::filesystem::path link_;
    Scratch scratch_;
};

}   // namespace rayclock
