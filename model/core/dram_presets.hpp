#pragma once
// The memories that a configuration can name.
#include "model/core/dram_parts.hpp"

namespace rayclock {

/// The memories that ship with the program. Each names the source of its figures.
DramPart sdr();
DramPart sdr_half();
DramPart ddr3();
DramPart rpu();
DramPart ddr4();
DramPart lpddr4();
DramPart hbm2();
DramPart board();

}   // namespace rayclock
