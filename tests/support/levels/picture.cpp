// Traces the tiles of a picture in parallel.
#include "tests/support/levels/picture.hpp"

#include <mutex>

#include "model/compile/frame.hpp"
#include "model/trace/hits.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "sim/judge/reference/tiles.hpp"

namespace rayclock {

LevelsPicture trace_levels(const LevelsImage& levels, const Camera& camera, FrameSize size,
                           const Config& given, int threads, const Progress& progress) {
    const Config config = with_two_levels(given, given.name);
    LevelsPicture picture;
    picture.frame = make_frame(camera, size, levels.image, config);
    picture.hits = {size, std::vector<Hit>(std::size_t(size.width) * std::size_t(size.height))};
    picture.answers.resize(picture.hits.hits.size());
    const Decoder decoder(levels.image, config);
    const HitScale scale(picture.frame, levels.image.lattice, config);
    std::mutex mutex;
    for_each_tile(size, threads, "two levels", progress, [&](const PixelTile& tile) {
        LevelWalk walk(picture.frame, decoder, config);
        for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
            for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                const auto column = std::uint32_t(x), row = std::uint32_t(y);
                const std::size_t at = std::size_t(row) * picture.frame.width + column;
                picture.answers[at] = walk.trace(raygen({0, column, row}, picture.frame, config));
                picture.hits.hits[at] = scale({column, row, picture.answers[at], {}});
            }
        const std::lock_guard lock(mutex);
        picture.counts += walk.counts();
    });
    return picture;
}

}   // namespace rayclock
