#pragma once
// A divergence as waveforms for GTKWave.
#include <string>
#include <vector>

#include "sim/view/divergence/capture.hpp"

namespace rayclock {

/// Returns the bytes of an FST file: the RTL's signals from the file that the chip wrote, and every link of
/// model and RTL, "links.box_rsp.t_near_model" and "links.box_rsp.t_near_rtl". Without the model, the links
/// have the RTL's signals only.
std::string waveform(const Capture& capture, const Config& config, const std::string& rtl_wave);

/// Returns GTKWave's save file for it. GTKWave first shows the link of the divergence, then the unit's other
/// links and the unit's own signals.
std::string waveform_view(const Capture& capture, const Config& config, const Divergence& divergence,
                          const std::string& rtl_wave, const std::string& file_name);

/// A signal inside an instance of a unit.
struct InsideSignal {
    std::uint32_t number = 0;     ///< number of the signal in the file
    std::string instance, name;   ///< "TOP.rc_chip...u_trav.", "u_stack.visit_o"
    int width = 0;
};
std::vector<InsideSignal> signals_inside(const std::string& rtl_wave, const std::string& unit, int pipeline);

/// Returns the first cycle in which a value holds that was written at this time.
std::uint64_t cycle_of(std::uint64_t time);

/// A signal of a unit or of an instance inside it, "u_stack.visit_slot_o", in some cycles, in hexadecimal.
struct UnitSignal {
    std::string name;
    std::vector<std::string> values;   ///< [cycle - first]
};
/// Returns the signals that change in the cycles first..last-1.
std::vector<UnitSignal> unit_signals(const std::string& rtl_wave, const std::string& unit, int pipeline,
                                     std::uint64_t first, std::uint64_t last);

}   // namespace rayclock
