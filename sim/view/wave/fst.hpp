#pragma once
// Waveforms in GTKWave's format FST, written and read by GTKWave's own code (fstapi, which comes with
// Verilator). Only this folder knows it.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rayclock {

/// Writes a waveform. First all scopes and signals are declared; then times rise, and values change. A unit
/// of time is a nanosecond.
class FstWriter {
public:
    FstWriter();
    ~FstWriter();
    FstWriter(const FstWriter&) = delete;

    void open_scope(const std::string& name);
    void close_scope();

    using Signal = std::uint32_t;
    /// The name of several bits gets their range.
    Signal add_bits(const std::string& name, int width);
    /// Viewers show its values as they are: names, not numbers.
    Signal add_text(const std::string& name);
    /// Another name of a signal of this width, likewise.
    void add_alias(const std::string& name, int width, Signal signal);

    void set_time(std::uint64_t time);
    /// Digits 0, 1 and x, as many as the signal has bits. What a signal has already is not written again.
    void set_bits(Signal signal, std::string_view digits);
    void set_value(Signal signal, std::uint64_t value);
    void set_text(Signal signal, std::string_view text);

    /// The file's bytes; the writer is of no use afterwards. Throws UserError if the disk for temporary files
    /// did not take all of them.
    std::string finish();

private:
    struct File;
    std::unique_ptr<File> file_;
};

/// Who reads a waveform is told of its scopes and signals in their order, then of all changes in the order of
/// time.
struct FstVisitor {
    std::function<void(const std::string& name)> open_scope;
    std::function<void()> close_scope;
    /// Signals of the same number have the same values. Names of several bits end in their range, as GTKWave
    /// shows them: "x[3:0]".
    std::function<void(std::uint32_t signal, const std::string& name, int width, bool is_parameter)> signal;
    std::function<void(std::uint64_t time, std::uint32_t signal, std::string_view value)> change;
};
/// Throws UserError if the file is no such waveform.
void read_fst(const std::string& path, const FstVisitor& visitor);

/// "x[3:0]" of x with 4 bits, x of one bit.
std::string ranged(const std::string& name, int width);

/// `count` bits of a payload's words from bit `at` up, as digits.
std::string digits_of(const std::vector<std::uint32_t>& words, int at, int count);

}   // namespace rayclock
