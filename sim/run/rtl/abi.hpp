#pragma once
// The interface between the program and a verilated module in a shared library. It is plain data, so that one
// program can load the RTL of any configuration. sim/run/rtl/adapter.cpp generates the library's side.

extern "C" {

/// One valid/ready link, or data alone (valid and ready are null): a static input or a plain output. The
/// pointers refer to the verilated model and are valid while the handle is open. Data is little-endian 32-bit
/// words, in Verilator's order.
struct RcPort {
    const char* name;
    unsigned char* valid;
    unsigned char* ready;
    unsigned int* data;
    unsigned int bytes;
};

/// The functions of the library.
struct RcModule {
    void* (*open)(int seed);   ///< registers start at seeded random values
    void (*close)(void* handle);
    int (*eval)(void* handle, int clock);    ///< sets clk_i; returns 1 once an assertion has failed
    unsigned char* (*reset)(void* handle);   ///< rst_ni, active low
    unsigned int (*ports)(void* handle, const RcPort** ports);
};
}
