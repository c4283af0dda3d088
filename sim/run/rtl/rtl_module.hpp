#pragma once
// A verilated module of the RTL in a shared library.
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "model/core/layout.hpp"
#include "sim/run/rtl/abi.hpp"
#include "sim/run/rtl/compile.hpp"
#include "sim/run/rtl/wave_abi.hpp"

namespace rayclock {

/// Reports a failed assertion of the RTL. Verilator has printed which one on standard output.
struct RtlAssertion : std::runtime_error {
    RtlAssertion() : std::runtime_error("an assertion of the RTL failed, see the line above") {}
};

/// A module of the RTL under Verilator. Registers without reset start at random values.
class RtlModule {
public:
    /// Builds the module if necessary. Throws as build_rtl() does.
    RtlModule(const Config& config, const std::string& module, int seed = 1, Waves waves = Waves::no);
    ~RtlModule();
    RtlModule(const RtlModule&) = delete;

    /// Returns the port called `name`. Outputs and taps are valid after settle(); set inputs before it.
    /// Throws std::logic_error if there is none.
    const RcPort& port(const std::string& name) const;

    /// Holds reset for four full cycles, or as many as the largest cache takes to clear its sets. Set static
    /// inputs before it.
    void reset();

    /// Evaluates the combinational paths from inputs to outputs, without a clock edge.
    void settle();
    /// Performs the clock edge. Throws RtlAssertion.
    void clock();

    /// Records the signals of a module that has waves to a new file, from the next dump on. Times must rise.
    void begin_wave(const std::string& path) { wave_->begin(handle_, path.c_str()); }
    void dump_wave(std::uint64_t time) { wave_->dump(handle_, time); }
    int end_wave() { return wave_->end(handle_); }   ///< 0, or errno

private:
    void* library_ = nullptr;
    const RcModule* module_ = nullptr;
    const RcWave* wave_ = nullptr;
    void* handle_ = nullptr;
    const RcPort* ports_ = nullptr;
    unsigned count_ = 0;
    int reset_cycles_;
};

/// Copies a packed payload to a port, or reads one from it.
template <class P> void set_data(const RcPort& port, const P& payload, const Config& config);
template <class P> P get_data(const RcPort& port, const Config& config) {
    if (port.bytes >= 4) return unpack<P>(port.data, config);
    // A port of up to 16 bits is shorter than a word, and its payload fits one. GCC 14 does not see that and
    // warns about words beyond it (array-bounds), so `words` has room for every member.
    std::array<std::uint32_t, sizeof(P) / sizeof(std::uint32_t) + 1> words{};
    std::memcpy(words.data(), port.data, port.bytes);
    return unpack<P>(words.data(), config);
}
void copy_words(const RcPort& port, const Words& words);

template <class P> void set_data(const RcPort& port, const P& payload, const Config& config) {
    copy_words(port, pack(payload, config));
}

}   // namespace rayclock
