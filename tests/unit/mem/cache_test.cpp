// cache: the timing of answers, the requests to memory, and the lines that stay.
#include "tests/support/world/cache_rules.hpp"

using namespace rayclock;
using namespace rayclock::test;

#define ALL_CACHES                                                                          \
    CacheModel<NodeCache>, CacheRtl<NodeCache>, CacheModel<PrimCache>, CacheRtl<PrimCache>, \
        CacheModel<SharedCache>, CacheRtl<SharedCache>

TEMPLATE_TEST_CASE("a hit is answered exactly three cycles after it was accepted", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_hit_latency<TestType>);
}

TEMPLATE_TEST_CASE("a miss requests its line after two cycles and is answered three after the last word",
                   "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_miss_latency<TestType>);
}

TEMPLATE_TEST_CASE("a cache answers a hit in every cycle", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_throughput_of_hits<TestType>);
}

TEMPLATE_TEST_CASE("hits go on while a line is on its way", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_hit_under_miss<TestType>);
}

TEMPLATE_TEST_CASE("misses to one line send one request and are answered in order, one a cycle", "[cache]",
                   ALL_CACHES) {
    in_quick_shapes<TestType>(check_merges<TestType>);
}

TEMPLATE_TEST_CASE("the pseudo-LRU way of a set is replaced", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_eviction<TestType>);
}

TEMPLATE_TEST_CASE("a way that waits for its line is not given away", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_waiting_way_stays<TestType>);
}

TEMPLATE_TEST_CASE("a look-up waits while all ways of its set wait", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_conflict<TestType>);
}

TEMPLATE_TEST_CASE("a look-up waits while no MSHR is free", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(check_full_mshrs<TestType>);
}

TEMPLATE_TEST_CASE("a cache stalls while its answers are not accepted, and loses nothing", "[cache]",
                   ALL_CACHES) {
    in_quick_shapes<TestType>(check_answers_not_taken<TestType>);
}

TEMPLATE_TEST_CASE("every request is answered once with what lies in memory", "[cache]", ALL_CACHES) {
    in_quick_shapes<TestType>(
        [](const Config& config) { check_random<TestType>(config, is_model<TestType> ? 5 : 2, 1500); });
}

TEMPLATE_TEST_CASE("model and RTL of a cache do the same in every cycle", "[cache][lockstep]", NodeCache,
                   PrimCache, SharedCache) {
    for (const std::string& name : quick_shapes<TestType>()) lockstep<TestType>(cache_config(name), 3, 2500);
}

TEMPLATE_TEST_CASE("model and RTL of a fast cache do the same in every cycle", "[cache][lockstep][fast]",
                   NodeCache, PrimCache, SharedCache) {
    Config config = cache_config("four");
    config.timing = Timing::fast;
    lockstep<TestType>(config, 3, 2500);
}

TEMPLATE_TEST_CASE("caches of other shapes keep their rules", "[cache][slow]", ALL_CACHES) {
    for (const std::string& name : other_shapes<typename TestType::CacheKind>()) {
        INFO(name);
        const Config config = cache_config(name);
        check_hit_latency<TestType>(config);
        check_miss_latency<TestType>(config);
        check_throughput_of_hits<TestType>(config);
        check_hit_under_miss<TestType>(config);
        check_merges<TestType>(config);
        check_eviction<TestType>(config);
        check_waiting_way_stays<TestType>(config);
        check_conflict<TestType>(config);
        check_full_mshrs<TestType>(config);
        check_answers_not_taken<TestType>(config);
        check_random<TestType>(config, 3, 3000);
    }
}

TEMPLATE_TEST_CASE("model and RTL of caches of other shapes do the same in every cycle",
                   "[cache][lockstep][slow]", NodeCache, PrimCache, SharedCache) {
    for (const std::string& name : other_shapes<TestType>()) lockstep<TestType>(cache_config(name), 5, 5000);
}
