#pragma once
// What a module that was built for waveforms offers beside sim/run/rtl/abi.hpp: every signal of it, written
// by Verilator as an FST file over any stretch of time.

extern "C" {

struct RcWave {
    void (*begin)(void* handle, const char* path);   ///< to a new file, from the next dump on
    void (*dump)(void* handle, unsigned long long time);
    int (*end)(void* handle);   ///< 0, or the number of the error that has cut the file
};
}
