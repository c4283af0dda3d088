#pragma once
// Reads and writes waveforms in GTKWave's format FST, with GTKWave's own code: fstapi, which comes with
// Verilator. Only this folder uses fstapi.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rayclock {

/// Writes a waveform. The caller first declares all scopes and signals, then sets rising times and values.
/// The unit of time is a nanosecond.
class FstWriter {
public:
    FstWriter();
    ~FstWriter();
    FstWriter(const FstWriter&) = delete;

    void open_scope(const std::string& name);
    void close_scope();

    using Signal = std::uint32_t;
    /// Declares a signal of bits. A name of several bits gets a range.
    Signal add_bits(const std::string& name, int width);
    /// Declares a signal whose values viewers show as text.
    Signal add_text(const std::string& name);
    /// Declares another name of a signal of the same width. A name of several bits gets a range.
    void add_alias(const std::string& name, int width, Signal signal);

    void set_time(std::uint64_t time);
    /// Sets a value from digits 0, 1 and x, one for each bit. An unchanged value is not written again.
    void set_bits(Signal signal, std::string_view digits);
    void set_value(Signal signal, std::uint64_t value);
    void set_text(Signal signal, std::string_view text);

    /// Returns the file's bytes and ends the writer's use. Throws UserError if a temporary file could not be
    /// written completely.
    std::string finish();

private:
    struct File;
    std::unique_ptr<File> file_;
};

/// Callbacks of read_fst(): first the scopes and signals in declaration order, then all changes in order of
/// time.
struct FstVisitor {
    std::function<void(const std::string& name)> open_scope;
    std::function<void()> close_scope;
    /// Signals with the same number share their values. Names of several bits end in a range, as in GTKWave:
    /// "x[3:0]".
    std::function<void(std::uint32_t signal, const std::string& name, int width, bool is_parameter)> signal;
    std::function<void(std::uint64_t time, std::uint32_t signal, std::string_view value)> change;
};
/// Reads a waveform. Throws UserError if the file is not in FST format.
void read_fst(const std::string& path, const FstVisitor& visitor);

/// Returns "x[3:0]" for x with 4 bits, and x for one bit.
std::string ranged(const std::string& name, int width);

/// Returns `count` bits of a payload, from bit `at` up, as digits.
std::string digits_of(const std::vector<std::uint32_t>& words, int at, int count);

}   // namespace rayclock
