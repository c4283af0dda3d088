// Draws random chips, and runs a stream on them.
#include "sim/explore/torture/streamed.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "model/base/rng.hpp"
#include "model/core/settled.hpp"
#include "model/engine/check.hpp"
#include "sim/explore/torture/random_chip.hpp"

namespace rayclock {

namespace {

constexpr int max_draws = 200;

/// A list tests every triangle for every ray. With more tests Verilator takes minutes.
constexpr double max_list_tests = 2e4;

/// Changes a drawn configuration into a chip that reads rays. Throws UserError if the result is not legal.
Config stream_chip(Config drawn, const StreamInput& input) {
    while (drawn.pixel_bits < max_pixel_bits && std::size_t(1) << 2 * drawn.pixel_bits <= input.rays().size())
        ++drawn.pixel_bits;
    const Config config = settled(streaming(drawn, input.scene()));
    check_config(config, config.name);
    return config;
}

}   // namespace

std::vector<StreamChip> random_stream_chips(const StreamInput& input, std::uint64_t seed, int count,
                                            const Progress& progress) {
    const double tests = double(input.rays().size()) * double(primitive_count(input.scene()));
    std::vector<StreamChip> chips;
    for (int i = 0; i < count; ++i) {
        std::string last;
        StreamChip chip;
        bool found = false;
        for (int draw = 0; draw < max_draws && !found; ++draw) {
            if (interrupted()) throw Interrupted("interrupted: nothing is written");
            Rng dice((seed + std::uint64_t(i)) * 1000 + std::uint64_t(draw));
            chip = {seed + std::uint64_t(i), random_chip(dice.next() >> 16, true), 0, {}};
            try {
                chip.config = stream_chip(chip.config, input);
                if (chip.config.is_list() && tests > max_list_tests) continue;
                chip.config.name = fmt::format("random {}", chip.seed);
                input.job(chip.config, progress);   // throws if the chip's memory or stack is too small
                found = true;
            } catch (const UserError& e) {
                last = e.what();
            }
            chip.khz = 20000 + dice.below(500000);
            chip.disturbance = {dice.below(2) * dice.below(100), dice.below(2) * dice.below(80),
                                dice.next() >> 8};
        }
        if (!found)
            throw UserError(fmt::format(
                "none of {} random chips can trace the stream; the last one's reason: {}", max_draws, last));
        chips.push_back(std::move(chip));
    }
    return chips;
}

StreamChipRun run_stream_chip(const StreamInput& input, const StreamChip& chip, const Progress& progress) {
    StreamJob stream = input.job(chip.config, progress);
    stream.job.khz = chip.khz;
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(stream.job, stream.job.frame, 1, progress));
    StreamChipRun run{run_lockstep(stream.job, frames, chip.disturbance, progress, int(chip.seed)),
                      std::nullopt};
    if (!run.lockstep.model.partial) run.judged = judge_stream(stream, run.lockstep.rtl.answers, 1, progress);
    return run;
}

}   // namespace rayclock
