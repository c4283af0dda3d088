// Measures primary rays per second of the reference tracer and of Embree 3, and their ratio. Both trace the
// same rays of gears:8, one at a time, in one thread and one process. Embree runs with its default flags and
// with RTC_SCENE_FLAG_ROBUST. It computes in single precision with the host's widest vectors, the reference
// in double precision for baseline x86-64. The reference's target is a quarter of Embree's speed. Times cover
// only trace().
#include <algorithm>
#include <cstdio>
#include <map>

#include <benchmark/benchmark.h>

#include "model/scene/builtin.hpp"
#include "sim/judge/reference/reference.hpp"
#include "tests/support/scenes/embree_scene.hpp"

namespace {

using namespace rayclock;

const FrameSize size{512, 384};

const Scene& gears() {
    static const Scene scene = make_builtin("gears:8");
    return scene;
}

struct Rays {
    glm::dvec3 eye{0};
    std::vector<glm::dvec3> directions;
};

const Rays& rays() {
    static const Rays all = [] {
        const Scene& scene = gears();
        const double aspect = static_cast<double>(size.width) / size.height;
        const PixelRays pixels = pixel_rays(scene.camera ? *scene.camera : fit_camera(scene, aspect), size);
        Rays made{pixels.eye, {}};
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                made.directions.push_back(glm::normalize(pixels.direction(x, y)));
        return made;
    }();
    return all;
}

template <typename Tracer> void trace_all(benchmark::State& state, const Tracer& tracer) {
    std::uint64_t hits = 0;
    for (auto _ : state) {
        hits = 0;
        for (const glm::dvec3& direction : rays().directions)
            hits += tracer.trace(rays().eye, direction).primitive != no_primitive;
        benchmark::DoNotOptimize(hits);
    }
    const auto count = static_cast<double>(rays().directions.size());
    state.counters["rays/s"] = benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["hit"] = static_cast<double>(hits) / count;
}

void reference(benchmark::State& state) {
    static const Reference tracer(gears());
    trace_all(state, tracer);
}

void embree_default(benchmark::State& state) {
    static const EmbreeScene tracer(gears(), RTC_SCENE_FLAG_NONE);
    trace_all(state, tracer);
}

void embree_robust(benchmark::State& state) {
    static const EmbreeScene tracer(gears(), RTC_SCENE_FLAG_ROBUST);
    trace_all(state, tracer);
}

void reference_build(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(Reference(gears()));
    const auto count = static_cast<double>(gears().triangles.size());
    state.counters["triangles/s"] = benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(reference)->Unit(benchmark::kMillisecond)->MinTime(2);
BENCHMARK(embree_default)->Unit(benchmark::kMillisecond)->MinTime(2);
BENCHMARK(embree_robust)->Unit(benchmark::kMillisecond)->MinTime(2);
BENCHMARK(reference_build)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Prints the usual table, and the ratios between the best speeds of the tracers.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    RatioReporter() : ConsoleReporter(OO_Tabular) {}   // no colours, because the output may go to a file
    void ReportRuns(const std::vector<Run>& runs) override {
        benchmark::ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs)
            if (const auto rate = run.counters.find("rays/s"); rate != run.counters.end())
                best_[run.run_name.function_name] =
                    std::max(best_[run.run_name.function_name], rate->second.value);
    }
    void print_ratios() {
        for (const char* embree : {"embree_default", "embree_robust"})
            if (best_.count("reference") != 0 && best_.count(embree) != 0)
                std::printf("reference / %s: %.2f\n", embree, best_["reference"] / best_[embree]);
    }

private:
    std::map<std::string, double> best_;
};

}   // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    std::printf("gears:8, %zu triangles, %dx%d primary rays\n", gears().triangles.size(), size.width,
                size.height);
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.print_ratios();
    return 0;
}
