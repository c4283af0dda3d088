// What the counters of each scene say, in words. They are of configuration `default`.
#include "sim/pages/structures/page.hpp"

namespace rayclock::structures {

namespace {
struct Reason {
    const char* scene;
    const char* words;
};
constexpr Reason reasons[] = {{"", ""}};
}   // namespace

const char* reason(const std::string& scene) {
    for (const Reason& r : reasons)
        if (scene == r.scene) return r.words;
    return "";
}

}   // namespace rayclock::structures
