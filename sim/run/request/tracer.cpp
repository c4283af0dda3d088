// The values of the option --engine.
#include "sim/run/request/tracer.hpp"

#include <optional>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

namespace {

std::optional<Tracer> find_tracer(const std::string& text) {
    for (const Tracer tracer : {Tracer::reference, Tracer::model, Tracer::rtl})
        if (text == name_of(tracer)) return tracer;
    return std::nullopt;
}

}   // namespace

const char* name_of(Tracer tracer) {
    switch (tracer) {
        case Tracer::reference: return "reference";
        case Tracer::model: return "model";
        default: return "rtl";
    }
}

Tracer parse_tracer(const std::string& text) {
    if (const std::optional<Tracer> tracer = find_tracer(text)) return *tracer;
    throw UserError("--engine: " + shown(text) + " is not reference, model or rtl");
}

Tracer parse_machine(const std::string& text) {
    const std::optional<Tracer> tracer = find_tracer(text);
    if (tracer && *tracer != Tracer::reference) return *tracer;
    throw UserError("--engine: " + shown(text) + " is not model or rtl");
}

}   // namespace rayclock
