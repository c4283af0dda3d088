// The tables of docs/origins.md: how often each scheme of secondary-ray origins is wrong. Usage: rc_origins [rays per cell]
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "sim/stress/shadow_scenes.hpp"
#include "sim/stress/shadows.hpp"

using namespace rayclock;

namespace {

using Kind = OriginScheme::Kind;
const std::vector<OriginScheme> schemes{{Kind::excluded, 0},  {Kind::pushed, 0},    {Kind::epsilon, 16},  {Kind::surface, 4},
                                        {Kind::surface, 6},   {Kind::surface, 8},   {Kind::surface, 12},  {Kind::surface, 16}};
const int bits[] = {12, 14, 16, 18, 20};
constexpr std::size_t widths = std::size(bits);

/// counts[scheme][scene][width]
using Counts = std::vector<std::vector<std::array<ShadowCounts, widths>>>;

Counts count_all(std::uint64_t rays) {
    const auto& scenes = shadow_scenes();
    Counts counts(schemes.size(), std::vector<std::array<ShadowCounts, widths>>(scenes.size()));
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t job; (job = next++) < scenes.size() * widths;) {
            const std::size_t scene = job / widths, width = job % widths;
            const Shadows world(scenes[scene].make(bits[width]), bits[width]);
            for (std::size_t s = 0; s < schemes.size(); ++s) counts[s][scene][width] = world.count(1000 + job, rays, schemes[s]);
            std::fprintf(stderr, "%s, N = %d\n", scenes[scene].name.c_str(), bits[width]);
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
    for (auto& thread : threads) thread.join();
    return counts;
}

double per_million(std::uint64_t count, std::uint64_t rays) { return rays == 0 ? 0 : 1e6 * double(count) / double(rays); }

void print_row(const std::string& name, const ShadowCounts& c, bool surface) {
    std::printf("| %s | %llu | %llu | %llu | %.0f |", name.c_str(), static_cast<unsigned long long>(c.rays),
                static_cast<unsigned long long>(c.false_shadows), static_cast<unsigned long long>(c.light_leaks), per_million(c.either, c.rays));
    if (surface) std::printf(" %.1f | %.1f |\n", per_million(c.moved_shadows, c.rays), per_million(c.moved_leaks, c.rays));
    else std::printf(" - | - |\n");
}
void print_head(const char* what) {
    std::printf("\n| %s | rays | false shadows | light leaks | either, per million | moved shadows, per million | moved leaks, per million |\n"
                "|---|---|---|---|---|---|---|\n", what);
}

} // namespace

int main(int argc, char** argv) {
    const std::uint64_t rays = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 50000;
    const Counts counts = count_all(rays);
    const auto& scenes = shadow_scenes();
    print_head("scheme");
    for (std::size_t s = 0; s < schemes.size(); ++s) {
        ShadowCounts sum;
        for (const auto& scene : counts[s])
            for (const ShadowCounts& c : scene) sum += c;
        print_row(schemes[s].name(), sum, schemes[s].kind == Kind::surface);
    }
    print_head("on the surface, B = 16: scene");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        ShadowCounts sum;
        for (const ShadowCounts& c : counts.back()[i]) sum += c;
        print_row(scenes[i].name + ": " + scenes[i].what, sum, true);
    }
    std::printf("\nFalse shadows and light leaks per million rays, by scene:\n\n| scene |");
    for (std::size_t s = 0; s < schemes.size(); ++s) std::printf(" %s |", schemes[s].name().c_str());
    std::printf("\n|---|");
    for (std::size_t s = 0; s < schemes.size(); ++s) std::printf("---|");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::printf("\n| %s |", scenes[i].name.c_str());
        for (std::size_t s = 0; s < schemes.size(); ++s) {
            ShadowCounts sum;
            for (const ShadowCounts& c : counts[s][i]) sum += c;
            std::printf(" %.0f, %.0f |", per_million(sum.false_shadows, sum.rays), per_million(sum.light_leaks, sum.rays));
        }
    }
    std::printf("\n");
    return 0;
}
