// Walks single pixels of the whole frame, draws parts, replays them in chains, and estimates.
#include "sim/run/sample/sample.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"
#include "model/engine/engines.hpp"
#include "model/machine/machine.hpp"
#include "model/machine/stuck_rays.hpp"
#include "model/trace/on_demand.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/files/process/stopping.hpp"

namespace rayclock::sample {

namespace {

/// Estimates the cycles that one pipeline needs for a pixel, from its work alone: the largest of several
/// lower bounds. The cycles of a part of the frame are nearly proportional to this estimate.
class Pace {
public:
    explicit Pace(const Config& config)
        : contexts_(std::uint64_t(config.contexts)),
          visit_(std::uint64_t(config.box_interval())),
          test_(std::uint64_t(config.tri_interval)),
          ray_(std::uint64_t(config.raygen_interval)),
          instance_(std::uint64_t(config.xform_interval) - 1),
          visit_latency_(std::uint64_t(node_latency(config)) + around_unit),
          test_latency_(std::uint64_t(config.tri_latency()) + around_unit),
          ray_latency_(std::uint64_t(config.raygen_latency()) + around_unit +
                       (config.has_shade() ? std::uint64_t(config.shade_latency()) : 0)) {}

    WorkCounts of(const PixelWork& work) const {
        const RecordTotals& steps = work.steps;
        const std::uint64_t rays = work.rays.all();
        const std::uint64_t cycles =
            std::max({unit * steps.visits * visit_ + unit * steps.instances * instance_ / 2,
                      unit * steps.triangle_tests * test_, unit * rays * ray_,
                      unit *
                          (steps.visits * visit_latency_ + steps.triangle_tests * test_latency_ +
                           rays * ray_latency_) /
                          contexts_,
                      unit});
        return {cycles,
                steps.visits,
                steps.box_tests,
                steps.triangle_tests,
                work.rays.primary,
                work.rays.shadow,
                work.rays.reflection,
                work.rays.refraction,
                work.rays.primary_hits,
                steps.instances,
                1};
    }
    /// The work of a slot outside the picture: sched takes a cycle for it.
    static WorkCounts outside() {
        WorkCounts counts{};
        counts[std::size_t(Work::expected_cycles)] = unit;
        counts[std::size_t(Work::slots)] = 1;
        return counts;
    }

private:
    static constexpr std::uint64_t unit = 64;   ///< of a cycle
    /// Cycles that a request and its answer spend in queues and caches, apart from the unit.
    static constexpr std::uint64_t around_unit = 6;
    std::uint64_t contexts_, visit_, test_, ray_, instance_, visit_latency_, test_latency_, ray_latency_;
};

/// The first phase: x of two single pixels in each block of slots.
struct Coarse {
    std::vector<std::uint64_t> work;   ///< [part]: the expected cycles of these pixels
    std::array<Auxiliary, work_kinds> works;
    std::uint64_t pixels = 0;
};

/// The data that all parts of a sample share.
struct Plan {
    const Job& job;
    Parts parts;
    Pace pace;
    OnDemandJob shared;
    std::optional<OnDemandJob> before;   ///< the previous frame of a film, whose lines are in the caches
    std::uint64_t seed;
    std::uint32_t strata;   ///< samples of different size have independent random numbers
    Disturbance disturbance;
    int threads;
    Progress progress;

    Rng rng(std::uint64_t purpose, std::uint64_t number) const {
        Rng seeds(seed);
        const std::uint64_t first = seeds.next() ^ Rng(strata).next();
        return Rng(first ^ Rng(seeds.next() + (purpose << 32) + number).next());
    }
};

constexpr std::uint64_t coarse_goal = 16384;   // the largest number of single pixels, except in huge frames

Coarse walk_single_pixels(const Plan& w) {
    const SlotOrder& order = w.parts.order;
    std::uint64_t block = 16;
    while (block < 4096 && 2 * order.slots() / block > coarse_goal) block *= 2;
    const std::uint32_t parts = w.parts.count;
    Coarse coarse;
    coarse.work.resize(parts);
    struct Sums {
        std::array<double, work_kinds> totals{}, squares{};
        std::uint64_t pixels = 0;
    };
    constexpr std::uint32_t pieces = 16;
    std::vector<Sums> sums(pieces);
    parallel::for_each(pieces, w.threads, [&](std::size_t piece) {
        OnDemandRecorder recorder(w.shared);
        Sums& sum = sums[piece];
        for (auto part = std::uint32_t(parts * piece / pieces); part < parts * (piece + 1) / pieces; ++part) {
            stop_if_interrupted();
            Rng rng = w.rng(1, part);
            const std::uint64_t end = w.parts.end_tile(part) * order.tile_slots();
            for (std::uint64_t at = w.parts.first_tile(part) * order.tile_slots(); at < end; at += block) {
                const std::uint64_t size = std::min(block, end - at), a = below(rng, size),
                                    b = size > 1 ? below(rng, size - 1) : 0;
                const std::uint64_t slots[2] = {at + a, size > 1 ? at + (b < a ? b : b + 1) : at};
                WorkCounts counts[2] = {Pace::outside(), Pace::outside()};
                for (int i = 0; i < 2; ++i) {
                    const SlotOrder::Pixel p = order.pixel(slots[i]);
                    if (!order.is_inside(p)) continue;
                    counts[i] = w.pace.of(recorder.walk(p.x, p.y));
                    ++sum.pixels;
                }
                coarse.work[part] += counts[0][0] + counts[1][0];
                if (part == 0 || part + 1 == parts) continue;
                const double n = double(size);
                for (std::size_t k = 0; k < work_kinds; ++k) {
                    const double first = double(counts[0][k]), second = double(counts[1][k]);
                    sum.totals[k] += n * (first + second) / 2;
                    sum.squares[k] += n * std::max(0.0, n - 2) * (first - second) * (first - second) / 4;
                }
            }
        }
    });
    for (const Sums& sum : sums) {
        for (std::size_t k = 0; k < work_kinds; ++k) {
            coarse.works[k].total += sum.totals[k];
            coarse.works[k].variance += sum.squares[k];
        }
        coarse.pixels += sum.pixels;
    }
    return coarse;
}

/// Replays some of the measured parts on one machine, in their order.
class Chain {
public:
    Chain(const Plan& w, std::span<const std::uint32_t> numbers) : w_(w), recorder_(w.shared) {
        for (const std::uint32_t number : numbers) add(number, number == numbers.back());
    }
    std::uint64_t pixels() const { return pixels_; }

    /// Replays all parts at one clock.
    std::vector<Sampled::Measured> replay(int khz) {
        Machine machine(w_.job.config, khz, w_.disturbance);
        if (places_.front().number > 0)
            warm(machine, 0);
        else if (w_.before)
            warm_from_end(machine);
        std::vector<Stretch> stretches;
        for (const PartPlace& place : places_) stretches.push_back(place.stretch);
        machine.start(w_.job.frame, recorder_.trace(), std::move(stretches), pixels_);
        std::vector<Sampled::Measured> measured;
        const std::uint64_t limit = patience(w_.job.config, khz, w_.disturbance);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (i > 0) warm(machine, i);
            run(machine, places_[i].begin, limit);
            const std::uint64_t cycles = machine.cycle();
            const Accounts accounts = machine.accounts();
            const MemoryStats memory = machine.memory().stats();
            run(machine, places_[i].end, limit);
            Sampled::Measured part;
            part.timing.cycles = machine.cycle() - cycles;
            part.timing.accounts = machine.accounts() - accounts;
            part.timing.memory = machine.memory().stats() - memory;
            add_work(places_[i].number, part);
            measured.push_back(part);
        }
        return measured;
    }

private:
    struct PartPlace {
        std::uint32_t number = 0, first_tile = 0, end_tile = 0;
        Stretch stretch;
        std::uint64_t begin = 0, end = 0;   ///< pixels that the machine has finished when it is measured
    };

    /// Adds a part. If its warm-up would begin before the end of the last tail, the tiles of the frame
    /// continue there instead: a tile that runs twice would find its own lines in the caches. At the end of a
    /// chain dispatch needs tiles for the queues of sched, as in a whole frame.
    void add(std::uint32_t number, bool ends_chain) {
        const Parts& u = w_.parts;
        const SlotOrder& order = u.order;
        const bool is_first = number == 0, is_last = number + 1 == u.count;
        const std::uint32_t part = u.first_tile(number),
                            last_end = places_.empty() ? 0 : places_.back().end_tile,
                            first =
                                is_first ? 0 : std::max(last_end, part - std::min(part, u.lengths.warm_up)),
                            ahead = ends_chain ? 3 * std::uint32_t(w_.job.config.pipelines) : 0,
                            end = is_last
                                      ? order.tiles()
                                      : std::min(order.tiles(), u.end_tile(number) + u.lengths.tail + ahead);
        // Pixels of the chain before a tile. The part may begin in the last tail, before `first`.
        const auto pixels_before = [&](std::uint32_t tile) {
            return pixels_ + order.pixels_before(tile) - order.pixels_before(first);
        };
        places_.push_back({number,
                           first,
                           end,
                           {order.tile(first), end - first},
                           pixels_before(part),
                           pixels_before(u.end_tile(number))});
        pixels_ = pixels_before(end);
    }

    /// Puts lines into the caches that the row of tiles before a place would have left there.
    void warm(Machine& machine, std::size_t i) {
        const SlotOrder& order = w_.parts.order;
        const PartPlace& place = places_[i];
        constexpr std::uint32_t margin = 2;   // tiles to both sides
        const std::uint32_t columns = order.columns(), span = place.end_tile - place.first_tile,
                            back = columns + std::min(span, columns) / 2,
                            after = i > 0 ? places_[i - 1].end_tile : 0,
                            first = std::max(place.first_tile - std::min(place.first_tile, back),
                                             std::min(after, place.first_tile));
        look_up(machine, recorder_, first, place.first_tile, place.number, [&](std::uint32_t tile) {
            const std::uint32_t above = tile + columns;
            return above + margin >= place.first_tile && above < place.end_tile + margin;
        });
    }

    /// Puts lines into the caches that the end of the previous frame has left there.
    void warm_from_end(Machine& machine) {
        OnDemandRecorder recorder(*w_.before);
        const std::uint32_t tiles = w_.parts.order.tiles(), columns = w_.parts.order.columns(),
                            near = 2 * w_.parts.lengths.part, back = std::max(near, columns + columns / 2);
        look_up(machine, recorder, tiles - std::min(tiles, back), tiles, 0,
                [&](std::uint32_t tile) { return tile + near >= tiles; });
    }

    /// Looks up the lines of some pixels of these tiles in the caches: of every second pixel of a tile that
    /// is near, and of every eighth pixel of the others.
    template <class IsNear> void look_up(Machine& machine, OnDemandRecorder& recorder, std::uint32_t first,
                                         std::uint32_t end, std::uint32_t number, IsNear&& is_near) {
        const SlotOrder& order = w_.parts.order;
        Rng rng = w_.rng(2, number);
        std::uint64_t slot = first * order.tile_slots();
        while (slot < end * order.tile_slots()) {
            const auto tile = std::uint32_t(slot / order.tile_slots());
            const SlotOrder::Pixel p = order.pixel(slot);
            if (order.is_inside(p)) machine.warm(tile, recorder.passing(p.x, p.y));
            slot += 1 + below(rng, is_near(tile) ? 3 : 15);
        }
    }

    void run(Machine& machine, std::uint64_t pixels, std::uint64_t limit) {
        constexpr std::uint64_t cycles_between_looks = 1 << 16;
        while (machine.finished_pixels() < pixels) {
            machine.run(machine.cycle() + cycles_between_looks, pixels);
            stop_if_interrupted();
            if (machine.quiet() > limit)
                throw std::runtime_error(fmt::format("model: nothing has moved for {} cycles of a sample\n{}",
                                                     machine.quiet(), describe_stuck_rays(machine)));
        }
    }

    void add_work(std::uint32_t number, Sampled::Measured& part) {
        const SlotOrder& order = w_.parts.order;
        const std::uint64_t end = w_.parts.end_tile(number) * order.tile_slots();
        for (std::uint64_t slot = w_.parts.first_tile(number) * order.tile_slots(); slot < end; ++slot) {
            const SlotOrder::Pixel p = order.pixel(slot);
            const bool is_inside = order.is_inside(p);
            const WorkCounts counts = is_inside ? w_.pace.of(recorder_.work(p.x, p.y)) : Pace::outside();
            for (std::size_t k = 0; k < work_kinds; ++k) part.work[k] += counts[k];
            part.timing.pixels += is_inside;
        }
    }

    const Plan& w_;
    OnDemandRecorder recorder_;
    std::vector<PartPlace> places_;
    std::uint64_t pixels_ = 0;
};

}   // namespace

std::uint32_t strata_of(const Frame& frame, const Config& config, double share) {
    const Parts parts = parts_of(frame, config);
    const auto strata = std::max(least_strata, std::uint32_t(std::lround(share * parts.count / 2)));
    if (3 * strata + 2 <= parts.count) return strata;
    const std::uint64_t least =
        std::uint64_t(3 * least_strata + 2) * parts.lengths.part * parts.order.tile_slots();
    throw UserError(
        fmt::format("--sample: {}x{} pixels are too few for a sample; with {} {} and {} contexts a frame "
                    "needs at least {} pixels, in full tiles",
                    frame.width, frame.height, config.pipelines,
                    config.pipelines == 1 ? "pipeline" : "pipelines", config.contexts, least));
}

std::vector<Sampled> run(const Job& job, const std::vector<int>& khz, const Ask& ask, Disturbance disturbance,
                         int threads, const Progress& progress, const Frame* before) {
    const Stopwatch watch;
    const std::uint32_t wanted = strata_of(job.frame, job.config, ask.share);
    Plan w{job,
           parts_of(job.frame, job.config),
           Pace(job.config),
           {job.image, job.frame, job.config},
           {},
           ask.seed,
           wanted,
           disturbance,
           threads,
           progress};
    if (before) w.before.emplace(job.image, *before, job.config);
    const Coarse coarse = walk_single_pixels(w);
    Rng rng = w.rng(0, 0);
    const std::vector<Stratum> strata = draw(coarse.work, wanted, rng);
    std::vector<std::uint32_t> numbers{0, w.parts.count - 1};
    for (const Stratum& s : strata) numbers.insert(numbers.end(), std::begin(s.chosen), std::end(s.chosen));
    std::sort(numbers.begin(), numbers.end());

    // The number of chains is fixed, so that the result does not depend on the number of threads.
    const std::size_t chains = std::clamp<std::size_t>(numbers.size() / 6, 1, 16);
    std::vector<std::vector<std::vector<Sampled::Measured>>> measured(chains);   // [chain][clock][part]
    std::mutex mutex;
    std::uint64_t replayed = 0, done = 0;
    parallel::for_each(chains, threads, [&](std::size_t c) {
        const std::size_t first = numbers.size() * c / chains, end = numbers.size() * (c + 1) / chains;
        Chain chain(w, std::span(numbers).subspan(first, end - first));
        for (const int k : khz) measured[c].push_back(chain.replay(k));
        const std::lock_guard lock(mutex);
        replayed += chain.pixels();
        if (w.progress) w.progress("sample", ++done, chains);
    });

    std::vector<Sampled> sampled;
    for (std::size_t k = 0; k < khz.size(); ++k) {
        std::vector<Sampled::Measured> parts;
        for (const auto& chain : measured) parts.insert(parts.end(), chain[k].begin(), chain[k].end());
        Effort effort{w.parts.count,
                      std::uint32_t(numbers.size()),
                      wanted,
                      job.frame.pixels(),
                      0,
                      replayed,
                      coarse.pixels,
                      watch.seconds()};
        for (const Sampled::Measured& part : parts) effort.measured_pixels += part.timing.pixels;
        sampled.emplace_back(khz[k], effort, strata, std::move(parts), numbers, coarse.works);
    }
    return sampled;
}

UploadTiming upload_timing(const Config& config, int khz, Disturbance disturbance, const Upload& upload) {
    Machine machine(config, khz, disturbance);
    return prepare_frame(machine, 0, [&](std::size_t f) { return f == 0 ? &upload : nullptr; });
}

}   // namespace rayclock::sample
