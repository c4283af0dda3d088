#pragma once
// The effect of filters, mip levels and texel formats on pictures, cycles and memory.
#include <array>
#include <string>
#include <vector>

#include "model/scene/hit_shading.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock::texture_study {

/// How a hit reads a texture. A texture whose filter is `nearest` in the scene keeps this filter in all of
/// them.
enum class Filter { nearest, bilinear, levels };
inline constexpr std::array filters{Filter::nearest, Filter::bilinear, Filter::levels};
constexpr std::array<const char*, 3> filter_names{"nearest texel, level 0", "bilinear, level 0",
                                                  "bilinear, mip levels"};
constexpr const char* name_of(Filter f) { return filter_names[std::size_t(f)]; }

/// The form of texels in memory. `blocks` is BC1, which the machine does not have (block.hpp).
enum class Coding { rgb888, rgb565, blocks };
constexpr std::array<const char*, 3> coding_names{"rgb888", "rgb565", "BC1"};
constexpr const char* name_of(Coding c) { return coding_names[std::size_t(c)]; }

/// The machines whose cycles the study compares: settings added to Study::config. The first adds none.
/// The others read texels through a slower memory.
constexpr std::array<std::array<const char*, 2>, 4> machines{
    {{"", ""}, {"dram=sdr", ""}, {"dram=sdr", "pipelines=4"}, {"dram=sdr", "pipelines=8"}}};

/// The input of the study.
struct Study {
    ConfigChoice config;
    std::vector<std::string> scenes;
    FrameSize size;
    int depth = 0;   ///< bounces of a camera ray
    int threads = 0;
};

/// The cost of one frame, with cold caches.
struct Cost {
    std::uint64_t cycles = 0, bytes = 0;    ///< bytes: read from memory by the whole frame
    std::uint64_t look_ups = 0, hits = 0;   ///< of tex_cache
    double hit_rate() const { return look_ups ? double(hits) / double(look_ups) : 0; }
};

using Costs = std::array<Cost, machines.size()>;

/// One filter with one coding. PSNR of 8-bit sRGB, in dB.
struct Row {
    Filter filter;
    Coding coding;
    Picture picture;
    double psnr_samples = 0;   ///< against the reference's picture of 8 x 8 samples in a pixel
    double psnr_exact = 0;     ///< against the reference's picture with one sample and the same filter
    /// The same as psnr_exact, but with 8 bits of alpha in every coding. rgb888 has 8 bits in any case.
    double psnr_exact_alpha8 = 0;
    Costs costs{};   ///< for blocks: from the trace of rgb565 with other lines of texels
    const Cost& cost() const { return costs[0]; }
    std::uint64_t image_bytes = 0, texel_bytes = 0;   ///< of the memory image, and of texels on triangles
};

/// The error of a coding in one picture, over the colours of level 0, as PSNR in dB.
struct CodedTexture {
    std::string name;
    int width = 0, height = 0;
    double rgb565 = 0, blocks = 0;
};

struct SceneFigures {
    std::string scene;
    Picture samples;   ///< the reference's picture of 8 x 8 samples in a pixel
    std::vector<Row> rows;
    std::vector<CodedTexture> textures;
    std::uint64_t texels = 0;   ///< of all levels
    /// The cost with mip levels if each texture had one line of texels. No format can read fewer bytes.
    Costs least{};

    const Row& row(Filter filter, Coding coding) const;
};

/// Runs the study. Throws UserError if a scene has no texture on a triangle, and Interrupted after Ctrl-C.
std::vector<SceneFigures> measure(const Study& study, const Progress& progress);

}   // namespace rayclock::texture_study
