#pragma once
// The additional functions of a module that was built for waveforms; see sim/run/rtl/abi.hpp. Verilator
// writes all of its signals to an FST file, over any period of time.

extern "C" {

/// The functions of the library for waveforms.
struct RcWave {
    void (*begin)(void* handle, const char* path);   ///< to a new file, from the next dump on
    void (*dump)(void* handle, unsigned long long time);
    int (*end)(void* handle);   ///< 0, or the number of the error that truncated the file
};
}
