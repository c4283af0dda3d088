// Judges all pixels of a picture in parallel.
#include "sim/judge/paths/judge_picture.hpp"

#include <algorithm>
#include <optional>

#include <tbb/enumerable_thread_specific.h>

#include "model/base/stopwatch.hpp"
#include "model/compile/surfaces.hpp"
#include "model/trace/record_shaded.hpp"
#include "sim/judge/paths/camera.hpp"
#include "sim/judge/paths/path.hpp"
#include "sim/judge/reference/tiles.hpp"

namespace rayclock {

namespace {

constexpr std::size_t max_faults = 20;

/// The objects of one thread.
struct Bench {
    ShadedRecorder recorder;
    RecordScratch scratch;
    PathJudge judge;
    std::vector<PictureFault> faults;
    Bench(const MemoryImage& image, const FrameInputs& inputs, const Decoder& decoder, const PathRules& rules)
        : recorder(image, inputs.frame, inputs.config, decoder), scratch(inputs.config), judge(rules) {}
};

void judge_pixel(Bench& bench, std::uint32_t x, std::uint32_t y, std::size_t at, const MachineOutput& given,
                 std::vector<std::uint8_t>& wrong) {
    PathJudge& judge = bench.judge;
    judge.start(x, y);
    const Pixel& pixel = bench.recorder.follow(x, y, bench.scratch, judge);
    judge.finish(given.colours[at]);
    if (!same_hit(pixel.first, given.answers[at]))
        judge.fail("the machine's first hit is not the one that its rays give");
    if (bench.recorder.signature() != given.signatures[at])
        judge.fail("the pixel's rays are not those of the frame");
    if (!judge.is_wrong()) return;
    wrong[at] = 1;
    if (bench.faults.size() < max_faults)
        bench.faults.push_back({x, y, judge.fault().ray, judge.fault().what});
}

}   // namespace

struct PictureJudge::World {
    const MemoryImage& image;
    const Whitted& settings;
    std::optional<Scene> moved;   ///< of one level, with the corners of large triangles on coarser points
    FrameInputs inputs;
    std::vector<oracle::Solid> primitives;
    oracle::Solids solids;
    std::optional<PlacedWorld> placed;
    PathRules rules;
    Decoder decoder;

    World(const FrameInputs& given, const MemoryImage& memory, const Whitted& options)
        : image(memory),
          settings(options),
          moved(given.config.has_instances() ? std::nullopt
                                             : align_large_triangles(given.scene, given.lattice)),
          inputs{moved ? *moved : given.scene, given.camera, given.frame, given.lattice, given.config},
          primitives(given.config.has_instances()
                         ? std::vector<oracle::Solid>{}
                         : solids_of(inputs.scene, inputs.lattice, inputs.config.coord_bits)),
          solids(primitives),
          placed(given.config.has_instances() ? std::make_optional<PlacedWorld>(inputs, image)
                                              : std::nullopt),
          rules{inputs, settings, primitives, solids, placed ? &*placed : nullptr},
          decoder(image, inputs.config) {}
};

PictureJudge::PictureJudge(const FrameInputs& inputs, const MemoryImage& image, const Whitted& settings)
    : world_(std::make_unique<World>(inputs, image, settings)) {}
PictureJudge::~PictureJudge() = default;

const PathRules& PictureJudge::rules() const { return world_->rules; }
const PlacedWorld* PictureJudge::placed() const { return world_->rules.placed; }
ShadedRecorder PictureJudge::recorder() const {
    return {world_->image, world_->inputs.frame, world_->inputs.config, world_->decoder};
}

PictureJudgement PictureJudge::judge(const MachineOutput& given, int threads,
                                     const Progress& progress) const {
    const Stopwatch watch;
    const FrameInputs& inputs = world_->inputs;
    const PlacedWorld* placed = world_->rules.placed;
    const std::uint32_t width = inputs.frame.width, height = inputs.frame.height;

    PictureJudgement j;
    std::vector<std::uint8_t> wrong(std::size_t(width) * height);
    for (const std::string& sentence : judge_registers(inputs, world_->settings))
        j.faults.push_back({0, 0, 0, sentence});
    if (placed)
        for (const std::string& sentence : placed->faults()) j.faults.push_back({0, 0, 0, sentence});
    j.wrong = j.faults.size();
    if (placed && !placed->faults().empty()) {   // rays cannot be traced through wrong memory
        j.pixels.assign(wrong.size(), true);
        j.faults.resize(std::min(j.faults.size(), max_faults));
        j.seconds = watch.seconds();
        return j;
    }
    tbb::enumerable_thread_specific<Bench> benches(
        [&] { return Bench(world_->image, inputs, world_->decoder, world_->rules); });
    const FrameSize size{int(width), int(height)}, row{size.width, 1};
    const auto judge_row = [&](const PixelTile& tile) {
        const auto y = std::uint32_t(tile.rows().begin());
        for (std::uint32_t x = 0; x < width; ++x)
            judge_pixel(benches.local(), x, y, std::size_t(y) * width + x, given, wrong);
    };
    for_each_tile(size, threads, "judging", progress, judge_row, row);
    std::vector<PictureFault> faults;
    for (const Bench& bench : benches) {
        j.rays += bench.judge.rays();
        j.widest = std::max(j.widest, bench.judge.widest());
        faults.insert(faults.end(), bench.faults.begin(), bench.faults.end());
    }
    std::sort(faults.begin(), faults.end(), [](const PictureFault& a, const PictureFault& b) {
        return std::pair(a.y, a.x) < std::pair(b.y, b.x);
    });
    j.faults.insert(j.faults.end(), faults.begin(), faults.end());
    if (j.faults.size() > max_faults) j.faults.resize(max_faults);
    j.pixels.assign(wrong.begin(), wrong.end());
    j.colours = wrong.size();
    j.wrong += std::uint64_t(std::count(wrong.begin(), wrong.end(), 1));
    j.seconds = watch.seconds();
    return j;
}

PictureJudgement judge_picture(const FrameInputs& inputs, const MemoryImage& image, const Whitted& settings,
                               const MachineOutput& given, int threads, const Progress& progress) {
    return PictureJudge(inputs, image, settings).judge(given, threads, progress);
}

}   // namespace rayclock
