// Checks a whole configuration, including the bits of its nodes.
#include "model/engine/check.hpp"

#include "model/base/error.hpp"
#include "model/core/lines.hpp"
#include "model/engine/engines.hpp"

namespace rayclock {

void check_config(const Config& c, const std::string& where) {
    check_parameters(c, where);
    if (c.has_textures())
        if (const int bits = bits_of<Surface>(c); bits > line_bits)
            throw UserError(where + ": textures=1 needs a surface of at most 512 bits, and it has " +
                            std::to_string(bits) + ": coord_bits or addr_bits must be smaller");
    if (!c.has_instances()) return;
    for (const Structure s : {c.structure, c.lower_structure()})
        if (const int bits = node_bits(c, Config::engine_of(s)); bits > line_bits - line_kind_bits)
            throw UserError(where + ": levels=2 needs two free bits in every line, and a node of structure=" +
                            name_of(s) + " leaves " + std::to_string(line_bits - bits) +
                            " of 512: coord_bits or addr_bits must be smaller");
}

}   // namespace rayclock
