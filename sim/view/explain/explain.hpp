#pragma once
// Why a pixel took as long as it did, and why its colour is what it is: a report for people and for programs.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/judge/cause/cause.hpp"
#include "sim/view/observe/story.hpp"

namespace rayclock {

/// A pixel's colour beside the reference's.
struct ColourFinding {
    glm::vec3 machine{0}, reference{0};   ///< linear
    Hit hit, reference_hit;               ///< of the first camera ray
    bool is_other = false;                ///< holds another primitive
    std::optional<PixelCause> cause;      ///< `none` if it does not differ; nothing without a judge
    std::string fault;                    ///< of a bug: what is wrong
    std::vector<PixelStage> stages;
};

struct Explanation {
    const Config& config;
    const FrameCosts& costs;
    int khz = 0;
    PixelStory story;
    std::optional<ColourFinding> colour;

    std::uint64_t slower() const;   ///< pixels of the frame that took longer
};

nlohmann::ordered_json pixel_cost_json(const FrameCosts& costs, const Explanation& explanation);
nlohmann::ordered_json rays_json(const Explanation& explanation);
nlohmann::ordered_json colour_json(const std::optional<ColourFinding>& colour);

/// `steps`: with every visit, test and pass.
std::string explanation_text(const Explanation& explanation, bool steps);

/// Why the colour differs, as a sentence; empty without a judge.
std::string cause_sentence(const ColourFinding& colour);

/// Stays that belong together: those of one visit of a node, of one test of a primitive, of raygen or shade.
struct Step {
    enum class Kind : std::uint8_t { raygen, visit, test, end, shade } kind{};
    std::vector<const Stay*> stays;
    const VisitValues* visit = nullptr;
    const TestValues* test = nullptr;
    std::uint64_t first() const { return stays.front()->first; }
    std::uint64_t cycles() const;
    std::uint64_t work() const;
    std::vector<Stay::Wait> waits() const;
    const Stay* lookup() const;   ///< of a cache, or null
};
std::vector<Step> steps_of(const RayStory& ray);
const char* step_name(Step::Kind kind);

}   // namespace rayclock
