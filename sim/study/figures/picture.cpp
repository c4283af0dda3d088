// Compares pictures and prepares them for display.
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/files/image/image.hpp"
#include "sim/study/figures/figures_page.hpp"

namespace rayclock::figures {

Distance distance(const Picture& a, const Picture& b) {
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::dvec3 d = glm::abs(glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]));
        squares += glm::dot(d, d);
        sum += d.x + d.y + d.z;
    }
    const double values = 3.0 * double(a.pixels.size());
    return {std::sqrt(squares / values), sum / values, compare(a, b).psnr_db};
}

Picture amplified_difference(const Picture& a, const Picture& b, double factor) {
    Picture out{a.size, {}};
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        out.pixels.push_back(glm::min(float(factor) * glm::abs(a.pixels[i] - b.pixels[i]), glm::vec3(1)));
    return out;
}

double mean_of(const Picture& picture) {
    double sum = 0;
    for (const glm::vec3& p : picture.pixels) sum += double(p.x) + double(p.y) + double(p.z);
    return sum / (3.0 * double(picture.pixels.size()));
}

Picture magnified(const Picture& picture, int x, int y, int w, int h, int factor) {
    Picture out{{w * factor, h * factor}, {}};
    for (int j = 0; j < h * factor; ++j)
        for (int i = 0; i < w * factor; ++i)
            out.pixels.push_back(
                picture.pixels[std::size_t(y + j / factor) * std::size_t(picture.size.width) +
                               std::size_t(x + i / factor)]);
    return out;
}

}   // namespace rayclock::figures
