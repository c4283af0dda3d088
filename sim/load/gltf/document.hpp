#pragma once
// A glTF document as a whole: whether it can be read, and the roots of its tree of nodes.
#include <cstdint>
#include <vector>

#include "sim/files/json_value.hpp"
#include "sim/files/text.hpp"

namespace rayclock {

/// Throws UserError if the version or a required extension is not supported. Call it before anything else:
/// version 1 has objects where version 2 has arrays, and need not state its version.
void check_gltf_version(const JsonValue& document, const SourcePosition& at);

/// Returns the nodes of the default scene. Without any scene, returns the nodes that have no parent. `count`
/// is the number of nodes in the document. Throws UserError if a node does not exist.
std::vector<std::uint64_t> gltf_roots(const JsonValue& document, std::size_t count);

}   // namespace rayclock
