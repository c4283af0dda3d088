#pragma once
// Fields of the payloads of links, as names and places of their bits.
#include <string>
#include <vector>

#include "model/machine/links.hpp"

namespace rayclock {

struct PayloadField {
    std::string name;   ///< elements of an array one by one: "len_0"
    int at = 0, width = 0;
    bool is_signed = false;
};
/// From the top down.
std::vector<PayloadField> payload_fields(Link link, const Config& config);

/// A number of up to 64 bits in decimal, a longer one in hexadecimal.
std::string field_text(const PayloadField& field, const Words& payload);

}   // namespace rayclock
