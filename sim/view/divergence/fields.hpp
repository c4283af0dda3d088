#pragma once
// The fields of links' payloads: names, and positions of their bits.
#include <string>
#include <vector>

#include "model/machine/links.hpp"

namespace rayclock {

struct PayloadField {
    std::string name;   ///< an array has a field for each element: "len_0"
    int at = 0, width = 0;
    bool is_signed = false;
};
/// Returns the fields from the highest bits to the lowest.
std::vector<PayloadField> payload_fields(Link link, const Config& config);

/// Returns a field's value: a number of up to 64 bits in decimal, a longer one in hexadecimal.
std::string field_text(const PayloadField& field, const Words& payload);

}   // namespace rayclock
