// The rare events of the cache's model: misses, merges, drains and fills. Hits are in the header.
#include "model/mem/cache.hpp"

#include <bit>

#include "model/core/stages.hpp"

namespace rayclock {

namespace {
CacheShape shape(const Config& config, int sets, int ways, int line, int mshrs, int id_bits) {
    const int delay = Stages(config).cache_delay;
    return {sets, ways, line / line_bytes, mshrs, config.cache_queue, 1 << id_bits, delay};
}
int log2_of(int n) { return std::countr_zero(unsigned(n)); }
}   // namespace

CacheShape node_cache_shape(const Config& c) {
    return shape(c, c.node_sets, c.node_ways, c.node_line, c.node_mshrs, c.ray_bits());
}
CacheShape prim_cache_shape(const Config& c) {
    return shape(c, c.prim_sets, c.prim_ways, c.prim_line, c.prim_mshrs, c.ray_bits());
}
CacheShape surf_cache_shape(const Config& c) {
    return shape(c, c.surf_sets, c.surf_ways, c.surf_line, c.surf_mshrs, c.ray_bits());
}
CacheShape stream_cache_shape(const Config& c) {
    return shape(c, c.stream_sets, c.stream_ways, c.stream_line, c.stream_mshrs, c.ray_bits());
}
CacheShape tex_cache_shape(const Config& c) {
    return shape(c, c.tex_sets, c.tex_ways, c.tex_line, c.tex_mshrs, c.ray_bits());
}
CacheShape l2_shape(const Config& c) {
    return shape(c, c.l2_sets, c.l2_ways, c.l2_line, c.l2_mshrs, c.client_id_bits());
}

Cache::Cache(const CacheShape& shape)
    : shape_(shape),
      word_bits_(log2_of(shape.words)),
      set_mask_(std::uint32_t(shape.sets - 1)),
      sets_(std::size_t(shape.sets)),
      mshrs_(std::size_t(shape.mshrs)),
      next_(std::size_t(shape.ids)),
      in_(shape.cut ? 1 : 2),
      misses_(shape.mshrs),
      filled_(shape.mshrs),
      answers_(shape.queue) {
    for (std::uint32_t way = 0; way < std::uint32_t(shape.ways); ++way) {
        std::uint32_t values = 0, others = ~0u;
        for (std::uint32_t node = way + std::uint32_t(shape.ways); node > 1; node >>= 1) {
            const std::uint32_t bit = 1u << (node >> 1);
            others &= ~bit;
            if (!(node & 1)) values |= bit;
        }
        uses_[way] = values | others << 8;
    }
}

/// The line is not present. If it is in flight, the request joins the end of its chain. Otherwise it takes
/// an MSHR and a way.
CacheOutcome Cache::miss(const Request& request, std::uint32_t line, Set& set, std::uint64_t now) {
    for (std::uint32_t way = 0; way < std::uint32_t(shape_.ways); ++way) {
        if (set.lines[way] != ((line + 1) | in_flight)) continue;
        set.recent = after(set.recent, uses_[way]);
        Mshr& m = mshrs_[set.mshrs[way]];
        next_[m.tail] = request.id;
        m.tail = request.id;
        in_.pop();
        return CacheOutcome::merge;
    }
    if (busy_ == shape_.mshrs) return CacheOutcome::mshrs;
    const int place = victim(set);
    if (place < 0) return CacheOutcome::conflict;
    const auto way = std::uint32_t(place);
    std::uint32_t m = 0;
    while (mshrs_[m].busy) ++m;
    mshrs_[m] = {true, line, line & set_mask_, way, request.id, request.id, 0};
    ++busy_;
    set.lines[way] = (line + 1) | in_flight;
    set.mshrs[way] = std::uint8_t(m);
    set.recent = after(set.recent, uses_[way]);
    misses_.push({m, now});
    in_.pop();
    return CacheOutcome::miss;
}

bool Cache::warm(std::uint32_t addr) {
    const std::uint32_t line = addr >> word_bits_;
    Set& set = sets_[line & set_mask_];
    std::uint32_t way = 0;
    while (way < std::uint32_t(shape_.ways) && (set.lines[way] & ~in_flight) != line + 1) ++way;
    const bool present = way < std::uint32_t(shape_.ways);
    if (!present) {
        const int place = victim(set);
        if (place < 0) return false;
        way = std::uint32_t(place);
        set.lines[way] = line + 1;
    }
    set.recent = after(set.recent, uses_[way]);
    return present;
}

Cache::LookUp Cache::drain(bool room) {
    if (!room) return {CacheOutcome::answers, {}};
    Mshr& m = mshrs_[filled_.front()];
    const LinkRay answer{true, m.head};
    if (m.head == m.tail) {
        m.busy = false;
        --busy_;
        filled_.pop();
        sets_[m.set].lines[m.way] &= ~in_flight;
    } else {
        m.head = next_[m.head];
    }
    return {CacheOutcome::drain, answer};
}

std::array<LinkRay, 2> Cache::take_answers() {
    std::array<LinkRay, 2> answers{LinkRay{valid<true>(), answers_.front()}, {read_, 0}};
    answers_.pop(answers[0].valid);
    answers[1].ray = answers_.front();
    answers_.pop(answers[1].valid);
    return answers;
}

void Cache::put_answers(const std::array<LinkRay, 2>& answers) {
    for (const LinkRay& answer : answers) answers_.push(answer.ray, answer.valid);
    read_ = answers[1].valid;
}

void Cache::fill(std::uint32_t id) {
    const std::uint32_t m = id >> word_bits_;
    if (++mshrs_[m].words == std::uint32_t(shape_.words)) filled_.push(m);
}

int Cache::victim(const Set& set) const {
    const std::uint32_t ways = std::uint32_t(shape_.ways);
    std::uint32_t node = 1;
    while (node < ways) node = 2 * node + (set.recent >> node & 1);
    if (!waits(set, node - ways)) return int(node - ways);
    for (std::uint32_t way = 0; way < ways; ++way)
        if (!waits(set, way)) return int(way);
    return -1;
}

std::string Cache::where(std::uint32_t id) const {
    for (const auto* queue : {&in_, &input_queue_})
        for (std::size_t i = 0; i < queue->size(); ++i)
            if (queue->at(i).id == id) return "waits to be looked up";
    for (const Mshr& m : mshrs_) {
        if (!m.busy) continue;
        for (std::uint32_t waiting = m.head;; waiting = next_[waiting]) {
            if (waiting == id) return "waits for line " + std::to_string(m.line);
            if (waiting == m.tail) break;
        }
    }
    return answers_.contains(id) ? "answered, not taken" : "";
}

}   // namespace rayclock
