#pragma once
// A drawing as a list of shapes, and its output as SVG and PDF.
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace rayclock::plot {

/// A position in pixels from the top left corner.
struct PixelPosition {
    double x = 0, y = 0;
};
using Colour = std::array<std::uint8_t, 3>;   ///< sRGB

struct Line {
    std::vector<PixelPosition> points;
    Colour colour{};
    double width = 1;
};
struct Disc {
    PixelPosition centre;
    double radius = 1;
    Colour colour{};
};
struct Ring {
    PixelPosition centre;
    double radius = 1;
    Colour colour{};
    double width = 1;
};
enum class Anchor { start, middle, end };
struct Text {
    PixelPosition base;   ///< the anchor on the baseline
    std::string text;     ///< printable ASCII
    double size = 12;     ///< about 4/3 of a capital letter's height
    Colour colour{};
    Anchor anchor = Anchor::start;
    bool upright = false;   ///< turned to read upwards
};
/// Filled rectangles of one colour. One shape for all keeps files with thousands of rectangles small.
struct Boxes {
    struct Box {
        double x = 0, y = 0, width = 0, height = 0;   ///< (x, y) is the top left corner
    };
    std::vector<Box> boxes;
    Colour colour{};
};
using Shape = std::variant<Line, Disc, Ring, Text, Boxes>;

struct Drawing {
    double width = 0, height = 0;
    std::vector<Shape> shapes;   ///< later shapes cover earlier ones
};

/// Returns the width of a text in pixels.
double text_width(const std::string& text, double size);

/// Returns the drawing as an SVG file. Texts stay texts, stretched to the width of text_width().
std::string svg(const Drawing& drawing);

/// Writes `name` if it ends in .svg or .pdf, else `name`.svg. The file is complete or absent. Throws
/// UserError.
void write_plot(const std::string& name, const Drawing& drawing);
/// Throws UserError if write_plot() could not write this file, so that a command can fail early.
void check_plot_path(const std::string& name);

}   // namespace rayclock::plot
