#pragma once
// Catch2 3 under the names of Catch2 2, so that tests compile with both. CMake adds this folder to the
// include path if Catch2 3 is installed (Debian 13), and omits it for Catch2 2 (Debian 12).
#include <string>

#include <catch2/catch_all.hpp>

using Catch::Approx;

namespace Catch {

inline auto Contains(const std::string& text) { return Matchers::ContainsSubstring(text); }
inline auto StartsWith(const std::string& text) { return Matchers::StartsWith(text); }
inline auto EndsWith(const std::string& text) { return Matchers::EndsWith(text); }

}   // namespace Catch
