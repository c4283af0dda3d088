#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "model/core/config.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// Size of a cache. A word is what memory gives in one answer, 64 bytes.
struct CacheShape {
    int sets = 64, ways = 4;
    int words = 1;     ///< of a line
    int mshrs = 8;     ///< lines that may be on their way
    int queue = 4;     ///< answers that may wait
    int ids = 64;      ///< requests are told apart by 0..ids-1; one with the same id is made only after the answer
};
CacheShape node_cache_shape(const Config& config);
CacheShape prim_cache_shape(const Config& config);
CacheShape l2_shape(const Config& config);

/// What a cache did in a cycle.
enum class CacheDeed : std::uint8_t {
    hit,        ///< looked a request up: there
    miss,       ///< not there: asked for the line
    merge,      ///< the line is on its way already: the request waits with the others
    drain,      ///< answered a request that had waited for its line
    starved,    ///< had nothing to look up
    mshrs,      ///< could not ask for the line: too many are on their way
    conflict,   ///< could not ask for the line: all ways of its set wait for others
    answers,    ///< its answers are not taken
};
constexpr std::size_t cache_deeds = 8;

/// Non-blocking, set-associative cache: when things happen; what lies in the lines is memory's business. Misses to a line
/// that is on its way merge, hits pass misses, and any number of requests may wait for one line: a chain through their ids.
///
/// A request enters a queue of two. Its head is looked up, one in every cycle: a hit reads the data memory and is answered
/// 3 cycles after it was accepted; a miss takes a free MSHR and the set's pseudo-least-recently-used way (the lowest way
/// that is not waiting for a line, if that one is), and asks for the line's words one by one. Words come back in any order.
/// When the last is there, those who wait are answered first, in the order of their requests, one a cycle, from the cycle
/// after; a way is not given away before. A look-up that cannot go on stays at the head. Mirror of rtl/mem/rc_cache.sv.
class Cache {
public:
    struct Request {
        std::uint32_t id = 0;
        std::uint32_t addr = 0;   ///< in words
    };
    /// A word asked of memory. Its id is mshr * words + word of the line.
    using Miss = Request;

    explicit Cache(const CacheShape& shape);

    bool ready() const { return !in_.full(); }
    bool valid(std::uint64_t now) const { return answers_.valid(now); }
    std::uint32_t answer() const { return answers_.front(); }   ///< id of the request that is answered
    bool miss_valid() const { return !misses_.empty(); }
    Miss miss() const {
        const std::uint32_t m = misses_.front();
        return {m << word_bits_ | miss_word_, mshrs_[m].line << word_bits_ | miss_word_};
    }

    /// One clock edge at the end of cycle `now`: what came in (null if nothing), and which outputs were taken.
    CacheDeed clock(std::uint64_t now, const Request* request, bool answer_taken, const std::uint32_t* fill_id, bool miss_taken);

    /// True while clock() without input and output would change nothing and find nothing to do.
    bool idle() const { return in_.empty() && filled_.empty(); }
    bool waits() const { return busy_ > 0; }   ///< lines are on their way

private:
    struct Mshr {
        bool busy = false;
        std::uint32_t line = 0, set = 0, way = 0, head = 0, tail = 0, words = 0;
    };
    CacheDeed look_up(std::uint64_t now);
    CacheDeed drain(std::uint64_t now);
    CacheDeed ask(const Request& request, std::uint32_t line, std::uint32_t set);
    Mshr* on_its_way(std::uint32_t set, std::uint32_t way);
    int victim(std::uint32_t set) const;
    void touch(std::uint32_t set, std::uint32_t way);

    CacheShape shape_;
    int word_bits_, set_bits_;
    std::vector<std::uint32_t> tags_;    ///< [set * ways + way]: line + 1, 0: nothing
    std::vector<std::uint8_t> recent_;   ///< [set]: bits of the tree, node 1 at bit 1
    std::vector<Mshr> mshrs_;
    int busy_ = 0;
    std::vector<std::uint32_t> next_;    ///< [id]: who waits after it
    Ring<Request> in_{2};
    Ring<std::uint32_t> misses_, filled_;
    std::uint32_t miss_word_ = 0;
    Pipe<std::uint32_t> answers_;
};

} // namespace rayclock
