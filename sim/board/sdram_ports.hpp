#pragma once
// The SDRAM's pins as ports of a verilated module of rtl/board.
#include <cstdint>

#include "sim/board/sdram_chip.hpp"
#include "sim/run/rtl/signal.hpp"

namespace rayclock {

/// The SDRAM's pins of a module.
class SdramPorts {
public:
    explicit SdramPorts(const RtlModule& rtl)
        : cke_(rtl, "sd_cke"),
          cs_(rtl, "sd_cs"),
          ras_(rtl, "sd_ras"),
          cas_(rtl, "sd_cas"),
          we_(rtl, "sd_we"),
          ba_(rtl, "sd_ba"),
          a_(rtl, "sd_a"),
          dqm_(rtl, "sd_dqm"),
          oe_(rtl, "sd_dq_oe"),
          out_(rtl, "sd_dq_out"),
          in_(rtl, "sd_dq") {}
    SdramChipPins get() const {
        return {cke_ != 0,          cs_ != 0,          ras_ != 0,           cas_ != 0, we_ != 0,
                std::uint32_t(ba_), std::uint32_t(a_), std::uint32_t(dqm_), oe_ != 0,  std::uint16_t(out_)};
    }
    void set_dq(std::uint16_t value) { in_ = value; }

private:
    Signal cke_, cs_, ras_, cas_, we_, ba_, a_, dqm_, oe_, out_, in_;
};

}   // namespace rayclock
