#include "model/engine/check.hpp"

#include "model/base/error.hpp"
#include "model/engine/engines.hpp"

namespace rayclock {

void check_config(const Config& c, const std::string& where) {
    check_parameters(c, where);
    for (const Structure s : {c.structure, c.lower_structure()})
        if (const int bits = node_bits(c, Config::engine_of(s));
            bits > line_bits - line_kind_bits && c.has_instances())
            throw UserError(where +
                            ": levels=2 says in two bits of a line what it holds, and a node of structure=" +
                            name_of(s) + " leaves " + std::to_string(line_bits - bits) +
                            " of its 512 free: coord_bits or addr_bits must be smaller");
}

}   // namespace rayclock
