#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/image/image.hpp"
#include "sim/image/srgb.hpp"
#include "sim/plot/drawing.hpp"
#include "sim/report/text.hpp"

namespace rayclock::plot {

namespace {

/// Draws by distance: a pixel is covered as far as its centre lies within a shape's edge, over one pixel's width.
class Canvas {
public:
    Canvas(Picture& picture, double scale) : picture_(picture), scale_(scale), cover_(picture.pixels.size()) {}

    void operator()(const Line& line) { stroke({line.points}, line.width, line.colour); }
    void operator()(const Text& text) { stroke(strokes_of(text), pen_width(text.size), text.colour); }
    void operator()(const Disc& d) {
        spread(d.centre, d.centre, d.radius, [&](const Place& p) { return std::hypot(p.x - d.centre.x, p.y - d.centre.y) - d.radius; });
        paint(d.colour);
    }
    void operator()(const Ring& r) {
        spread(r.centre, r.centre, r.radius + r.width, [&](const Place& p) {
            return std::abs(std::hypot(p.x - r.centre.x, p.y - r.centre.y) - r.radius) - r.width / 2;
        });
        paint(r.colour);
    }

private:
    /// All strokes are one shape: where they cross nothing is painted twice.
    void stroke(const std::vector<std::vector<Place>>& strokes, double width, const Colour& colour) {
        for (const auto& points : strokes)
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Place a = points[i], b = points[std::min(i + 1, points.size() - 1)];
                spread(a, b, width / 2, [&](const Place& p) { return distance(p, a, b) - width / 2; });
            }
        paint(colour);
    }
    static double distance(const Place& p, const Place& a, const Place& b) {
        const double dx = b.x - a.x, dy = b.y - a.y, size = dx * dx + dy * dy;
        const double t = size > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / size, 0.0, 1.0) : 0;
        return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
    }

    /// Covers pixels around the box from a to b, `reach` beyond it.
    template <class Distance> void spread(const Place& a, const Place& b, double reach, const Distance& outside) {
        const auto pixel = [&](double v, int size) { return std::clamp(int(std::floor(v * scale_)), 0, size - 1); };
        const int x0 = pixel(std::min(a.x, b.x) - reach - 1, picture_.size.width), x1 = pixel(std::max(a.x, b.x) + reach + 1, picture_.size.width);
        const int y0 = pixel(std::min(a.y, b.y) - reach - 1, picture_.size.height), y1 = pixel(std::max(a.y, b.y) + reach + 1, picture_.size.height);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const double cover = std::clamp(0.5 - outside({(x + 0.5) / scale_, (y + 0.5) / scale_}) * scale_, 0.0, 1.0);
                if (cover <= 0) continue;
                const std::size_t at = std::size_t(y) * std::size_t(picture_.size.width) + std::size_t(x);
                if (cover_[at] == 0) touched_.push_back(at);
                cover_[at] = std::max(cover_[at], float(cover));
            }
    }
    void paint(const Colour& colour) {
        const glm::vec3 linear(float(linear_from_srgb(colour[0] / 255.0)), float(linear_from_srgb(colour[1] / 255.0)), float(linear_from_srgb(colour[2] / 255.0)));
        for (const std::size_t at : touched_) {
            picture_.pixels[at] += (linear - picture_.pixels[at]) * cover_[at];
            cover_[at] = 0;
        }
        touched_.clear();
    }

    Picture& picture_;
    double scale_;
    std::vector<float> cover_;
    std::vector<std::size_t> touched_;
};

} // namespace

Picture raster(const Drawing& drawing, int scale) {
    Picture picture{{int(std::lround(drawing.width * scale)), int(std::lround(drawing.height * scale))}, {}};
    picture.pixels.assign(std::size_t(picture.size.width) * std::size_t(picture.size.height), glm::vec3(1));
    Canvas canvas(picture, scale);
    for (const Shape& shape : drawing.shapes) std::visit(canvas, shape);
    return picture;
}

void check_plot_path(const std::string& name) {
    check_writable(name + ".svg");
    check_picture_path(name + ".png");
}

void write_plot(const std::string& name, const Drawing& drawing) {
    const Picture picture = raster(drawing, 2);
    write_file(name + ".svg", svg(drawing));
    write_picture(name + ".png", picture, {picture.size, std::vector<Hit>(picture.pixels.size())});
}

} // namespace rayclock::plot
