#pragma once
// Rows of tests/meta/mutants/*.cmake, as CMake has written them into the build folder, as faults that a
// schema can hold.
#include "tests/meta/campaign/schema.hpp"

namespace rayclock::campaign {

/// The row in the folder `row`, as one or several changed expressions with the same number; none if it
/// changes what is decided when the machine is built (a width), or what no expression holds.
std::vector<Mutant> of_row(const std::filesystem::path& source, const std::filesystem::path& row, int number);

/// All rows below `rows` of files that begin with `folder`; their numbers follow first_row. `others`: names
/// of rows that a schema cannot hold.
std::vector<Mutant> all_rows(const std::filesystem::path& source, const std::filesystem::path& rows,
                             const std::string& folder, std::vector<std::string>& others);

}   // namespace rayclock::campaign
