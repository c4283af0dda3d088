// Notes on settings and options that have no effect.
#include "sim/run/request/ineffective.hpp"

#include <string_view>

#include "model/core/parameters.hpp"
#include "sim/run/request/material.hpp"

namespace rayclock {

std::vector<std::string> ineffective_settings(const Config& config, const std::vector<std::string>& set) {
    std::vector<std::string> sentences;
    for (const std::string& item : set) {
        const Parameter& p = parameter(std::string_view(item).substr(0, item.find('=')));
        if (p.effect->holds(config)) continue;
        const Condition* first = p.effect;   // the condition that decides: others follow from it
        while (first->first && !first->first->holds(config)) first = first->first;
        const std::string decider = first->decider;
        sentences.push_back(std::string(p.key) + " has no effect with " + decider + "=" +
                            value_text(config, parameter(decider)));
    }
    return sentences;
}

std::vector<std::string> ineffective_finish(const Finish& f, const Whitted& settings, const Scene& scene) {
    std::vector<std::string> sentences;
    if (f.depth && settings.depth > 0 && !has_bounces(scene))
        sentences.push_back(
            "--depth " + std::to_string(settings.depth) +
            " draws no reflected or refracted ray, since no material reflects or transmits light" +
            (may_give_material(scene) ? "; --material mirror=0.5 lets reflect what has no material of its own"
                                      : ""));
    if (f.threshold && settings.depth == 0) sentences.push_back("--threshold has no effect with --depth 0");
    if (f.contrast && settings.aa * settings.aa <= int(first_samples))
        sentences.push_back("--contrast has no effect with --aa " + std::to_string(settings.aa) +
                            ", since the first " + std::to_string(first_samples) +
                            " samples are always taken");
    return sentences;
}

}   // namespace rayclock
