#pragma once
// One port of a verilated module as a number.
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "sim/run/rtl/rtl_module.hpp"

namespace rayclock {

/// A port of up to 64 bits, found once.
class Signal {
public:
    Signal(const RtlModule& rtl, const char* name) : port_(&rtl.port(name)) {}
    void operator=(std::uint64_t value) const {
        std::memcpy(port_->data, &value, std::min(port_->bytes, 8U));
    }
    operator std::uint64_t() const {
        std::uint64_t value = 0;
        std::memcpy(&value, port_->data, std::min(port_->bytes, 8U));
        return value;
    }

private:
    const RcPort* port_;
};

}   // namespace rayclock
