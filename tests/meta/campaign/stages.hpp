#pragma once
// What faults are given to, one after the other. Each stage skips what it has judged before.
#include <filesystem>
#include <string>

namespace rayclock::campaign {

/// The torture set on every fault of the RTL in FOLDER.
void torture_rtl(const std::filesystem::path& folder);
/// The same on the model's; this program must hold them.
void torture_model(const std::filesystem::path& folder);

/// What the torture set did not notice is given to the test programs of the build folder: tests of that unit
/// first, then the whole programs. `slow`: what the quick tests did not notice either, to the slow ones. The
/// page says what changes nothing.
void test_survivors(const std::filesystem::path& folder, const std::filesystem::path& build,
                    const std::filesystem::path& page, bool slow);

/// Counts what was noticed. False below `percent`.
bool report(const std::filesystem::path& folder, const std::filesystem::path& page, double percent);

}   // namespace rayclock::campaign
