#pragma once
// Explains the cycles and the colour of one pixel, as text and as JSON.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/judge/cause/cause.hpp"
#include "sim/view/observe/story.hpp"

namespace rayclock {

/// A pixel's colour next to the reference's, with the cause of the difference.
struct ColourFinding {
    glm::vec3 machine{0}, reference{0};   ///< linear
    Hit hit, reference_hit;               ///< hits of the first camera ray
    bool is_other = false;                ///< the pixel shows another primitive
    std::optional<PixelCause> cause;      ///< `none` if the colours agree; empty without a judgement
    std::string fault;                    ///< for a bug: the fault
    std::vector<PixelStage> stages;
};

/// Everything that `explain` reports about one pixel, or about one ray of a stream.
struct Explanation {
    const Config& config;
    const FrameCosts& costs;
    int khz = 0;
    PixelStory story;
    std::optional<ColourFinding> colour;

    std::uint64_t slower() const;   ///< Returns the number of pixels of the frame that took longer.
    bool is_of_stream() const { return config.is_stream(); }
    std::uint32_t number() const;   ///< of a ray of a stream
    std::string subject() const;    ///< "pixel (3, 4)" or "ray 7"
    /// Returns the purpose of a ray, or its request if it belongs to a stream.
    const char* purpose(const RayValues& ray) const;
};

nlohmann::ordered_json pixel_cost_json(const FrameCosts& costs, const Explanation& explanation);
nlohmann::ordered_json rays_json(const Explanation& explanation);
nlohmann::ordered_json colour_json(const std::optional<ColourFinding>& colour);

/// Returns the explanation as text. `steps` adds every visit, test and pass.
std::string explanation_text(const Explanation& explanation, bool steps);

/// Returns the reason for a different colour as a sentence; empty without a judgement.
std::string cause_sentence(const ColourFinding& colour);

/// The stays of one visit of a node, one test of a primitive, or one pass of raygen or shade.
struct Step {
    enum class Phase : std::uint8_t { raygen, visit, test, end, shade } phase{};
    std::vector<const Stay*> stays;
    const VisitValues* visit = nullptr;
    const TestValues* test = nullptr;
    std::uint64_t first() const { return stays.front()->first; }
    std::uint64_t cycles() const;
    std::uint64_t work() const;
    std::vector<Stay::Wait> waits() const;
    const Stay* lookup() const;   ///< the stay in a cache, or null
};
std::vector<Step> steps_of(const RayStory& ray);
const char* step_name(Step::Phase phase);

}   // namespace rayclock
