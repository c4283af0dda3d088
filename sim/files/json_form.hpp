#pragma once
// Documents of other programs: whatever is wrong with their form is a UserError.
#include <string>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/json_value.hpp"

namespace rayclock {

/// What `read` gives, or a UserError instead of the library's exceptions: for documents whose order matters.
/// `file` names the document, with who writes it: "face.json of yosys".
template <class Read> auto understood(const std::string& file, Read read) {
    try {
        return read();
    } catch (const nlohmann::json::exception&) {
        throw UserError(
            printable(file) +
            " has not the form that it should have: a key is missing, or a value has another type");
    }
}

/// Calls take(key, value) for all of an object.
template <class Take> void for_each(const JsonValue& object, Take take) {
    for (const auto& [key, ignored] : object.object().raw().items()) take(key, object.at(key));
}

}   // namespace rayclock
