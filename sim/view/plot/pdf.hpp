#pragma once
// Conversion of diagrams to PDF.
#include <string>

namespace rayclock::plot {

/// The program that writes PDFs, from Debian's librsvg2-bin.
constexpr const char* pdf_program = "rsvg-convert";

/// Converts an SVG file to PDF. Throws std::runtime_error if the program fails.
std::string pdf(const std::string& svg);
/// Throws UserError if the program is not installed. `path` is the PDF that was requested.
void check_pdf(const std::string& path);

}   // namespace rayclock::plot
