// Writes drawings as SVG.
#include <string_view>

#include <fmt/format.h>

#include "sim/files/image/image.hpp"
#include "sim/view/plot/drawing.hpp"
#include "sim/view/plot/pdf.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::plot {

namespace {

// Widths of the letters '!' to '~', in sevenths of a capital's height. The file prescribes these widths for
// any font, so that labels stay where they were placed.
constexpr std::string_view widths =
    "02444402244130444444444440144444444444442444445"
    "45444444444242441444443440131444443434444442024";
constexpr double between_letters = 1.7, blank = 0.8;

double width_of(char c) {
    if (c == ' ') return blank;
    return double(widths[std::size_t((c < ' ' || c > '~' ? '?' : c) - '!')] - '0');
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else
            out += c;
    }
    return out;
}

std::string hex(const Colour& c) { return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]); }

struct Element {
    std::string operator()(const Line& line) const {
        std::string points;
        for (const PixelPosition& p : line.points)
            points += fmt::format("{}{:.2f},{:.2f}", points.empty() ? "" : " ", p.x, p.y);
        return fmt::format(
            R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="{:.2f}" stroke-linecap="round" stroke-linejoin="round"/>)",
            points, hex(line.colour), line.width);
    }
    std::string operator()(const Disc& d) const {
        return fmt::format(R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:.2f}" fill="{}"/>)", d.centre.x,
                           d.centre.y, d.radius, hex(d.colour));
    }
    std::string operator()(const Ring& r) const {
        return fmt::format(
            R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:.2f}" fill="none" stroke="{}" stroke-width="{:.2f}"/>)",
            r.centre.x, r.centre.y, r.radius, hex(r.colour), r.width);
    }
    std::string operator()(const Text& t) const {
        constexpr const char* anchors[] = {"start", "middle", "end"};
        const std::string turn =
            t.upright ? fmt::format(R"~( transform="rotate(-90 {:.2f} {:.2f})")~", t.base.x, t.base.y) : "";
        return fmt::format(
            R"(<text x="{:.2f}" y="{:.2f}" font-family="sans-serif" font-size="{:.1f}" textLength="{:.1f}" lengthAdjust="spacingAndGlyphs" )"
            R"(text-anchor="{}" fill="{}"{}>{}</text>)",
            t.base.x, t.base.y, t.size, text_width(t.text, t.size), anchors[int(t.anchor)], hex(t.colour),
            turn, escaped(t.text));
    }
    std::string operator()(const Boxes& b) const {
        std::string path;
        for (const Boxes::Box& box : b.boxes)
            path +=
                fmt::format("M{:g} {:g}h{:g}v{:g}h-{:g}z", box.x, box.y, box.width, box.height, box.width);
        return fmt::format(R"(<path d="{}" fill="{}"/>)", path, hex(b.colour));
    }
};

/// Returns the file to which a plot of this name is written.
std::string plot_path(const std::string& name) {
    return name.ends_with(".svg") || name.ends_with(".pdf") ? name : name + ".svg";
}

}   // namespace

double text_width(const std::string& text, double size) {
    double width = text.empty() ? 0 : -between_letters;
    for (const char c : text) width += width_of(c) + between_letters;
    return width * size * 0.72 / 7;
}

std::string svg(const Drawing& drawing) {
    std::string text = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" viewBox="0 0 {0:.0f} {1:.0f}">)"
        "\n"
        R"(<rect width="100%" height="100%" fill="#ffffff"/>)"
        "\n",
        drawing.width, drawing.height);
    for (const Shape& shape : drawing.shapes) text += std::visit(Element{}, shape) + "\n";
    return text + "</svg>\n";
}

void check_plot_path(const std::string& name) {
    check_writable(plot_path(name));
    if (name.ends_with(".pdf")) check_pdf(name);
}

void write_plot(const std::string& name, const Drawing& drawing) {
    write_file(plot_path(name), name.ends_with(".pdf") ? pdf(svg(drawing)) : svg(drawing));
}

}   // namespace rayclock::plot
