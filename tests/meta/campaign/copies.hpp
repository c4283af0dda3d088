#pragma once
// Copies of the sources with all faults in them, built once.
#include <cstdint>

#include "tests/meta/campaign/schema.hpp"

namespace rayclock::campaign {

/// A request for `count` faults drawn from `seed`, and for the rows that CMake has written into the folder
/// `rows`, unless it is empty.
struct Order {
    std::filesystem::path folder;
    std::uint64_t seed = 0;
    int count = 0;
    std::filesystem::path rows;
};

/// Draws faults of rtl/, and replaces those that Verilator refuses by others. Leaves FOLDER/rtl, whose
/// modules are built on demand, and FOLDER's lists.
void make_rtl_copy(const std::filesystem::path& source, const Order& order);

/// From now on this process, and those that it starts, use FOLDER/rtl.
void use_rtl_copy(const std::filesystem::path& folder);
/// The file that says which of the RTL's faults is awake.
Caller caller_of(const std::filesystem::path& folder);

/// The same of the model's arithmetic. Leaves FOLDER/objects, the faulty files compiled, to be linked in
/// front of the libraries.
void make_model_copy(const std::filesystem::path& source, const Order& order);

/// Links a test program of the build folder once more, to FOLDER, with the model's faults in it; the
/// environment's RC_FAULT says which is awake.
void link_with_faults(const std::filesystem::path& folder, const std::filesystem::path& build,
                      const std::string& program);

/// Runs the command in a shell, and returns its exit status.
int shell(const std::string& command);

}   // namespace rayclock::campaign
