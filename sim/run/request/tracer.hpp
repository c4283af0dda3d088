#pragma once
// The choice of the option --engine: what traces a picture or a stream. In the code an *engine* is only the
// hardware that walks a ray through one kind of structure (docs/glossary.md).
#include <string>

namespace rayclock {

/// The software tracer, the golden model or the RTL.
enum class Tracer { reference, model, rtl };

/// Returns the tracer's name in options and reports.
const char* name_of(Tracer tracer);
/// Parses the value of --engine: "reference", "model" or "rtl". Throws UserError.
Tracer parse_tracer(const std::string& text);
/// Parses the value of --engine where only a machine makes sense: "model" or "rtl". Throws UserError.
Tracer parse_machine(const std::string& text);

}   // namespace rayclock
