// A glTF document as a whole: whether it is one that can be read, and where its tree of nodes begins.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/files/json_value.hpp"
#include "sim/files/text.hpp"

namespace rayclock {

/// Before anything else, because version 1 has objects where 2 has arrays, and need not say that it is
/// version 1. Throws UserError.
void check_gltf_version(const JsonValue& document, const Place& at);

/// The nodes of the default scene; without any scene, the nodes that have no parent. `count`: nodes of the
/// document.
std::vector<std::uint64_t> gltf_roots(const JsonValue& document, std::size_t count);

}   // namespace rayclock
