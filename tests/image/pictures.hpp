#pragma once
// Plain pictures and empty frames.
#include "sim/files/image/image.hpp"

namespace rayclock {

inline Picture grey_picture(FrameSize size, float value) {
    return {size,
            std::vector<glm::vec3>(static_cast<std::size_t>(size.width) * size.height, glm::vec3(value))};
}

inline HitFrame no_hits(FrameSize size) {
    return {size, std::vector<Hit>(static_cast<std::size_t>(size.width) * size.height)};
}

}   // namespace rayclock
