#include "model/mem/cache.hpp"

#include <bit>

namespace rayclock {

namespace {
CacheShape shape(int sets, int ways, int line, int mshrs, int queue, int id_bits) {
    return {sets, ways, line / line_bytes, mshrs, queue, 1 << id_bits};
}
int log2_of(int n) { return std::countr_zero(unsigned(n)); }
} // namespace

CacheShape node_cache_shape(const Config& c) { return shape(c.node_sets, c.node_ways, c.node_line, c.node_mshrs, c.cache_queue, c.ray_bits()); }
CacheShape prim_cache_shape(const Config& c) { return shape(c.prim_sets, c.prim_ways, c.prim_line, c.prim_mshrs, c.cache_queue, c.ray_bits()); }
CacheShape l2_shape(const Config& c) { return shape(c.l2_sets, c.l2_ways, c.l2_line, c.l2_mshrs, c.cache_queue, c.client_id_bits()); }

Cache::Cache(const CacheShape& shape)
    : shape_(shape), word_bits_(log2_of(shape.words)), set_bits_(log2_of(shape.sets)), tags_(std::size_t(shape.sets * shape.ways)),
      recent_(std::size_t(shape.sets)), mshrs_(std::size_t(shape.mshrs)), next_(std::size_t(shape.ids)), misses_(shape.mshrs),
      filled_(shape.mshrs), answers_(1, shape.queue) {}

CacheDeed Cache::clock(std::uint64_t now, const Request* request, bool answer_taken, const std::uint32_t* fill_id, bool miss_taken) {
    // What is looked up or drained was there at the beginning of the cycle; a place in the answers' queue, too.
    CacheDeed deed = CacheDeed::starved;
    const bool draining = !filled_.empty();
    const bool room = answers_.ready();
    if (miss_taken && ++miss_word_ == std::uint32_t(shape_.words)) {
        misses_.pop();
        miss_word_ = 0;
    }
    if (draining || !in_.empty()) deed = !room ? CacheDeed::answers : draining ? drain(now) : look_up(now);
    if (answer_taken) answers_.leave();
    if (fill_id) {
        const std::uint32_t m = *fill_id >> word_bits_;
        if (++mshrs_[m].words == std::uint32_t(shape_.words)) filled_.push(m);
    }
    if (request) in_.push(*request);
    return deed;
}

CacheDeed Cache::look_up(std::uint64_t now) {
    const Request request = in_.front();
    const std::uint32_t line = request.addr >> word_bits_, set = line & std::uint32_t(shape_.sets - 1);
    const std::uint32_t* tags = &tags_[set * std::size_t(shape_.ways)];
    std::uint32_t way = 0;
    while (way < std::uint32_t(shape_.ways) && tags[way] != line + 1) ++way;
    if (way == std::uint32_t(shape_.ways)) return ask(request, line, set);
    in_.pop();
    touch(set, way);
    if (Mshr* m = busy_ ? on_its_way(set, way) : nullptr) {
        next_[m->tail] = request.id;
        m->tail = request.id;
        return CacheDeed::merge;
    }
    answers_.admit(now) = request.id;
    return CacheDeed::hit;
}

CacheDeed Cache::ask(const Request& request, std::uint32_t line, std::uint32_t set) {
    if (busy_ == shape_.mshrs) return CacheDeed::mshrs;
    const int way = victim(set);
    if (way < 0) return CacheDeed::conflict;
    std::uint32_t m = 0;
    while (mshrs_[m].busy) ++m;
    mshrs_[m] = {true, line, set, std::uint32_t(way), request.id, request.id, 0};
    ++busy_;
    tags_[set * std::size_t(shape_.ways) + std::size_t(way)] = line + 1;
    touch(set, std::uint32_t(way));
    misses_.push(m);
    in_.pop();
    return CacheDeed::miss;
}

CacheDeed Cache::drain(std::uint64_t now) {
    Mshr& m = mshrs_[filled_.front()];
    answers_.admit(now) = m.head;
    if (m.head == m.tail) {
        m.busy = false;
        --busy_;
        filled_.pop();
    } else {
        m.head = next_[m.head];
    }
    return CacheDeed::drain;
}

Cache::Mshr* Cache::on_its_way(std::uint32_t set, std::uint32_t way) {
    for (Mshr& m : mshrs_)
        if (m.busy && m.set == set && m.way == way) return &m;
    return nullptr;
}

int Cache::victim(std::uint32_t set) const {
    std::uint32_t waiting = 0;
    if (busy_)
        for (const Mshr& m : mshrs_) waiting |= std::uint32_t(m.busy && m.set == set) << m.way;
    std::uint32_t node = 1;
    while (node < std::uint32_t(shape_.ways)) node = 2 * node + (recent_[set] >> node & 1);
    const std::uint32_t way = node - std::uint32_t(shape_.ways);
    if (!(waiting >> way & 1)) return int(way);
    const int lowest = std::countr_one(waiting);
    return lowest < shape_.ways ? lowest : -1;
}

// A bit of the tree points to the half that was used longer ago.
void Cache::touch(std::uint32_t set, std::uint32_t way) {
    for (std::uint32_t node = way + std::uint32_t(shape_.ways); node > 1; node >>= 1) {
        const std::uint32_t bit = 1u << (node >> 1);
        recent_[set] = std::uint8_t(node & 1 ? recent_[set] & ~bit : recent_[set] | bit);
    }
}

} // namespace rayclock
