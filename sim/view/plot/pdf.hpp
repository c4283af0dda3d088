#pragma once
#include <string>

namespace rayclock::plot {

/// The program that makes PDFs, of Debian's librsvg2-bin.
constexpr const char* pdf_program = "rsvg-convert";

/// An SVG file as PDF. Throws std::runtime_error.
std::string pdf(const std::string& svg);
/// Throws UserError if what makes PDFs is not installed; `path` is what was to be one.
void check_pdf(const std::string& path);

}   // namespace rayclock::plot
