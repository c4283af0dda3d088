#pragma once
// A drawing as a list of shapes, and as an SVG file.
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace rayclock::plot {

/// Pixels from the top left corner.
struct Place {
    double x = 0, y = 0;
};
using Colour = std::array<std::uint8_t, 3>;   ///< sRGB

struct Line {
    std::vector<Place> points;
    Colour colour{};
    double width = 1;
};
struct Disc {
    Place centre;
    double radius = 1;
    Colour colour{};
};
struct Ring {
    Place centre;
    double radius = 1;
    Colour colour{};
    double width = 1;
};
enum class Anchor { start, middle, end };
struct Text {
    Place base;         ///< of the baseline at the anchor
    std::string text;   ///< printable ASCII
    double size = 12;   ///< height of a capital letter and a third
    Colour colour{};
    Anchor anchor = Anchor::start;
    bool upright = false;   ///< reads from below to above
};
/// Filled rectangles of one colour: thousands take little more place in a file than one.
struct Boxes {
    struct Box {
        double x = 0, y = 0, width = 0, height = 0;   ///< from the top left corner
    };
    std::vector<Box> boxes;
    Colour colour{};
};
using Shape = std::variant<Line, Disc, Ring, Text, Boxes>;

struct Drawing {
    double width = 0, height = 0;
    std::vector<Shape> shapes;   ///< later ones cover earlier ones
};

/// How wide a text is drawn.
double text_width(const std::string& text, double size);

/// As a whole SVG file. Texts are texts, set to the width that text_width() says.
std::string svg(const Drawing& drawing);

/// Writes NAME.svg, whole or not at all. Throws UserError.
void write_plot(const std::string& name, const Drawing& drawing);
/// Fails early (UserError) if write_plot() could not write it.
void check_plot_path(const std::string& name);

}   // namespace rayclock::plot
