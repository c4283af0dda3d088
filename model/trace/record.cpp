// Compiles the recorder for the baseline and for AVX2.
#include "model/trace/record.hpp"

#include <algorithm>

#include "model/base/morton.hpp"
#include "model/engine/bvh/slab.hpp"
#include "model/trace/trace.hpp"
#include "model/trace/tree_walk.hpp"
#include "model/unit/tri/any_primitive.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

namespace {

/// Decides for a ray through an edge, which needs the triangle itself.
[[gnu::noinline, gnu::cold]] bool takes_on_edge(const RecordJob& job, std::uint32_t half_line,
                                                const Vec3i& d) {
    TriRsp rsp;
    tri_test(job.frame().eye, d, job.triangle(half_line), {}, job.config(), rsp);
    return rsp.closer;
}

static_assert(RecordBlock::side <= 64);

}   // namespace

namespace plain {
#include "model/engine/bvh/slab.inl"
#include "model/trace/tree_walk.inl"
#include "model/trace/record.inl"
}   // namespace plain

void record_block_plain(const RecordJob& job, const RecordBlock& block, RecordScratch& scratch, Closest* hits,
                        RecordTotals& totals) {
    plain::record(job, block, scratch, hits, totals);
}

std::size_t record_any_plain(const Decoder& decoder, const Config& config, std::uint32_t root, const Ray& ray,
                             std::size_t at, RecordScratch& scratch, RecordTotals& totals, Closest& hit) {
    return plain::record_any(decoder, config, root, ray, at, scratch, totals, hit);
}

#ifdef RAYCLOCK_AVX2
#pragma GCC push_options
#pragma GCC target("avx2,bmi,bmi2,lzcnt,popcnt")
#define RAYCLOCK_WITH_AVX2
namespace avx2 {
#include "model/engine/bvh/slab.inl"
#include "model/trace/tree_walk.inl"
#include "model/trace/record.inl"
}   // namespace avx2
#undef RAYCLOCK_WITH_AVX2
#pragma GCC pop_options

static bool is_able() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt") &&
           __builtin_cpu_supports("lzcnt");
}
RecordFunction* record_block() { return is_able() ? avx2::record : record_block_plain; }
RecordRayFunction* record_any() { return is_able() ? avx2::record_any : record_any_plain; }
#else
RecordRayFunction* record_any() { return record_any_plain; }
RecordFunction* record_block() { return record_block_plain; }
#endif

}   // namespace rayclock
