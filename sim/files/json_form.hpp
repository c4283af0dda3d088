#pragma once
// Reading documents that other programs wrote: every error in their form becomes a UserError.
#include <string>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/json_value.hpp"

namespace rayclock {

/// Returns the result of `read`, and turns the library's exceptions into a UserError. Use it for documents in
/// which the order of keys matters. `file` names the document and the program that writes it: "interface.json
/// of yosys".
template <class Read> auto understood(const std::string& file, Read read) {
    try {
        return read();
    } catch (const nlohmann::json::exception&) {
        throw UserError(printable(file) +
                        " is not in the expected form: a key is missing, or a value has another type");
    }
}

/// Calls take(key, value) for every member of an object. Throws UserError if `object` is not an object.
template <class Take> void for_each(const JsonValue& object, Take take) {
    for (const auto& [key, ignored] : object.object().raw().items()) take(key, object.at(key));
}

}   // namespace rayclock
