// Draws panels with axes, points and labels.
#include "sim/view/plot/chart.hpp"

#include <algorithm>
#include <optional>

#include "model/base/split.hpp"
#include "sim/view/plot/axis.hpp"

namespace rayclock::plot {

namespace {

constexpr Colour black{0x22, 0x22, 0x22}, grey{0x66, 0x66, 0x66}, pale{0xe4, 0xe4, 0xe4},
    blue{0x1f, 0x5f, 0xa8}, other{0xa9, 0xb4, 0xc2}, red{0xc8, 0x2a, 0x2a};
constexpr double panel_width = 560, panel_height = 400, left = 76, right = 18, top = 92, bottom = 84;
constexpr double label_size = 11.5, point_radius = 3.6;

struct Rect {
    double x0, y0, x1, y1;
    bool meets(const Rect& r) const { return x0 < r.x1 && r.x0 < x1 && y0 < r.y1 && r.y0 < y1; }
    bool inside(const Rect& r) const { return x0 >= r.x0 && y0 >= r.y0 && x1 <= r.x1 && y1 <= r.y1; }
};

class PanelPainter {
public:
    PanelPainter(Drawing& drawing, const Panel& panel, double x, double down)
        : drawing_(drawing),
          panel_(panel),
          xs_(values(&Mark::x), false),
          ys_(values(&Mark::y), panel.log_y),
          area_{x + left, down + top, x + panel_width - right, down + top + panel_height - bottom} {}

    void paint() {
        frame();
        front_line();
        for (const bool on_front : {false, true})
            for (const Mark& m : panel_.marks)
                if (m.on_front == on_front) point(m);
        for (const int rank : {0, 1, 2})
            for (const Mark& m : panel_.marks)
                if (rank == (m.is_knee ? 0 : m.on_front ? 1 : 2)) label(m);
    }

private:
    std::vector<double> values(double Mark::*side) const {
        std::vector<double> all;
        for (const Mark& m : panel_.marks) all.push_back(m.*side);
        return all;
    }
    double x_of(double value) const { return area_.x0 + xs_.place(value) * (area_.x1 - area_.x0); }
    double y_of(double value) const { return area_.y1 - ys_.place(value) * (area_.y1 - area_.y0); }
    PixelPosition place(const Mark& m) const { return {x_of(m.x), y_of(m.y)}; }
    void line(double x0, double y0, double x1, double y1, const Colour& colour, double width) {
        drawing_.shapes.emplace_back(Line{{{x0, y0}, {x1, y1}}, colour, width});
    }

    void frame() {
        for (const Scale::Tick& t : xs_.ticks()) {
            line(x_of(t.value), area_.y0, x_of(t.value), area_.y1, pale, 1);
            drawing_.shapes.emplace_back(
                Text{{x_of(t.value), area_.y1 + 18}, t.label, 12, grey, Anchor::middle});
        }
        for (const Scale::Tick& t : ys_.ticks()) {
            line(area_.x0, y_of(t.value), area_.x1, y_of(t.value), pale, 1);
            drawing_.shapes.emplace_back(
                Text{{area_.x0 - 8, y_of(t.value) + 4}, t.label, 12, grey, Anchor::end});
        }
        drawing_.shapes.emplace_back(
            Line{{{area_.x0, area_.y0}, {area_.x0, area_.y1}, {area_.x1, area_.y1}}, grey, 1.2});
        const double middle = (area_.x0 + area_.x1) / 2;
        drawing_.shapes.emplace_back(Text{{middle, area_.y0 - 12}, panel_.title, 14, black, Anchor::middle});
        drawing_.shapes.emplace_back(
            Text{{middle, area_.y1 + 40}, panel_.x_label, 12.5, black, Anchor::middle});
        drawing_.shapes.emplace_back(Text{
            {area_.x0 - 56, (area_.y0 + area_.y1) / 2}, panel_.y_label, 12.5, black, Anchor::middle, true});
    }

    void front_line() {
        std::vector<PixelPosition> points;
        for (const Mark& m : panel_.marks)
            if (m.on_front) points.push_back(place(m));
        std::sort(points.begin(), points.end(), [](const PixelPosition& a, const PixelPosition& b) {
            return a.x != b.x ? a.x < b.x : a.y < b.y;
        });
        if (points.size() > 1) drawing_.shapes.emplace_back(Line{points, blue, 1.6});
    }

    void point(const Mark& m) {
        const PixelPosition at = place(m);
        drawing_.shapes.emplace_back(Disc{at, m.on_front ? point_radius : point_radius - 0.8,
                                          m.is_knee    ? red
                                          : m.on_front ? blue
                                                       : other});
        if (m.is_knee) drawing_.shapes.emplace_back(Ring{at, 8, red, 2});
        const double r = m.is_knee ? 9 : point_radius;
        taken_.push_back({at.x - r, at.y - r, at.x + r, at.y + r});
    }

    /// Places a label next to its point, where it covers no point and no other label. If no such place exists
    /// the label is omitted, except for the knee.
    void label(const Mark& m) {
        const PixelPosition at = place(m);
        const double size = m.is_knee ? label_size + 1.5 : label_size, wide = text_width(m.label, size),
                     high = size * 0.72;
        const double gap = m.is_knee ? 12 : 6;
        const std::array<PixelPosition, 8> starts{{{at.x + gap, at.y + gap + high},
                                                   {at.x + gap, at.y - gap},
                                                   {at.x + gap, at.y + high / 2},
                                                   {at.x - gap - wide, at.y - gap},
                                                   {at.x - gap - wide, at.y + gap + high},
                                                   {at.x - gap - wide, at.y + high / 2},
                                                   {at.x - wide / 2, at.y - gap - 2},
                                                   {at.x - wide / 2, at.y + gap + high + 2}}};
        for (const PixelPosition& p : starts) {
            const Rect box{p.x - 2, p.y - high - 2, p.x + wide + 2, p.y + 2};
            const bool free =
                std::none_of(taken_.begin(), taken_.end(), [&](const Rect& r) { return r.meets(box); });
            if (!free || !box.inside(area_)) continue;
            write(m, p, size, box);
            return;
        }
        if (m.is_knee)
            write(m, starts[0], size, {starts[0].x, starts[0].y - high, starts[0].x + wide, starts[0].y});
    }
    void write(const Mark& m, const PixelPosition& at, double size, const Rect& box) {
        drawing_.shapes.emplace_back(Text{at, m.label, size, m.is_knee ? red : m.on_front ? blue : grey});
        taken_.push_back(box);
    }

    Drawing& drawing_;
    const Panel& panel_;
    Scale xs_, ys_;
    Rect area_;
    std::vector<Rect> taken_;
};

}   // namespace

namespace {

/// Breaks text into lines of at most this width. A longer word has its own line.
std::vector<std::string> lines_of(const std::string& text, double size, double width) {
    std::vector<std::string> lines{""};
    for (const std::string& word : split(text, ' ')) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || text_width(longer, size) <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
    }
    return lines;
}

}   // namespace

Drawing chart(const std::string& title, const std::string& note, const std::vector<Panel>& panels) {
    const double width = panel_width * double(panels.size());
    Drawing drawing{width, 0, {}};
    double y = 32;
    const auto write = [&](const std::string& text, double size, double leading, const Colour& colour) {
        const std::vector<std::string> lines = lines_of(text, size, width - left - right);
        for (const std::string& line : lines) {
            drawing.shapes.emplace_back(Text{{left, y}, line, size, colour});
            y += leading;
        }
        return leading * double(lines.size() - 1);
    };
    double down = write(title, 17, 22, black);
    down += write(note, 12.5, 17, grey);
    drawing.height = top + panel_height - 20 + down;
    for (std::size_t i = 0; i < panels.size(); ++i)
        PanelPainter(drawing, panels[i], panel_width * double(i), down).paint();
    return drawing;
}

}   // namespace rayclock::plot
