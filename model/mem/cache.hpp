#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/core/config.hpp"
#include "model/base/ring.hpp"

namespace rayclock {

/// Size of a cache. A word is what memory gives in one answer, 64 bytes.
struct CacheShape {
    int sets = 64, ways = 4;
    int words = 1;   ///< of a line
    int mshrs = 8;   ///< lines that may be on their way
    int queue = 4;   ///< answers that may wait
    int ids = 64;    ///< requests are told apart by 0..ids-1; one with the same id is made only after the
                     ///< answer
};
CacheShape node_cache_shape(const Config& config);
CacheShape prim_cache_shape(const Config& config);
CacheShape surf_cache_shape(const Config& config);
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

/// Non-blocking, set-associative cache: when things happen; what lies in the lines is memory's business.
/// Misses to a line that is on its way merge, hits pass misses, and any number of requests may wait for one
/// line: a chain through their ids.
///
/// A request enters a queue of two. Its head is looked up, one in every cycle: a hit reads the data memory
/// and is answered 3 cycles after it was accepted; a miss takes a free MSHR and the set's
/// pseudo-least-recently-used way (the lowest way that is not waiting for a line, if that one is), and asks
/// for the line's words one by one. Words come back in any order. When the last is there, those who wait are
/// answered first, in the order of their requests, one a cycle, from the cycle after; a way is not given away
/// before. A look-up that cannot go on stays at the head. Mirror of rtl/mem/rc_cache.sv.
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

    /// One clock edge at the end of cycle `now`: what came in (null if nothing), and which outputs were
    /// taken.
    CacheDeed clock(std::uint64_t now, const Request* request, bool answer_taken,
                    const std::uint32_t* fill_id, bool miss_taken) {
        // What is looked up or drained was there at the beginning of the cycle; a place in the answers'
        // queue, too.
        const bool room = answers_.ready(), draining = !filled_.empty();
        CacheDeed deed = CacheDeed::starved;
        if (draining || !in_.empty())
            deed = !room ? CacheDeed::answers : draining ? drain(now) : look_up(now);
        if (answer_taken) answers_.leave();
        if (miss_taken) next_word();
        if (fill_id) fill(*fill_id);
        if (request) in_.push(*request);
        return deed;
    }

    std::uint64_t due() const { return answers_.due(); }   ///< cycle of the next answer
    bool waits() const { return busy_ > 0; }               ///< lines are on their way
    /// Where a request is, for people; empty if not here.
    std::string where(std::uint32_t id) const;

private:
    struct Mshr {
        bool busy = false;
        std::uint32_t line = 0, set = 0, way = 0, head = 0, tail = 0, words = 0;
    };
    /// A way of a set: the line that it holds, and the MSHR that it waits for.
    struct Way {
        std::uint32_t line = 0;   ///< + 1; 0: nothing
        std::uint32_t mshr = 0;   ///< + 1; 0: the line is there
    };
    CacheDeed look_up(std::uint64_t now);
    CacheDeed drain(std::uint64_t now);
    CacheDeed ask(const Request& request, std::uint32_t line, std::uint32_t set);
    void next_word();
    void fill(std::uint32_t id);
    int victim(std::uint32_t set) const;

    // A bit of the tree points to the half that was used longer ago: using a way turns the bits above it away
    // from it.
    void touch(std::uint32_t set, std::uint32_t way) {
        recent_[set] = std::uint8_t((recent_[set] & keep_[way]) | turn_[way]);
        last_[set] = std::uint8_t(way);
    }

    CacheShape shape_;
    int word_bits_, way_bits_;
    std::uint32_t set_mask_;
    std::vector<Way> ways_;              ///< [set * ways + way]
    std::vector<std::uint8_t> recent_;   ///< [set]: bits of the tree, node 1 at bit 1
    std::vector<std::uint8_t> last_;     ///< [set]: way used last; where to look first, nothing more
    std::array<std::uint8_t, 8> keep_{}, turn_{};
    std::vector<Mshr> mshrs_;
    int busy_ = 0;
    std::vector<std::uint32_t> next_;   ///< [id]: who waits after it
    Ring<Request, 2> in_{2};
    Ring<std::uint32_t, 64> misses_, filled_;
    std::uint32_t miss_word_ = 0;
    Pipe<std::uint32_t> answers_;
};

inline CacheDeed Cache::look_up(std::uint64_t now) {
    const Request request = in_.front();
    const std::uint32_t line = request.addr >> word_bits_, set = line & set_mask_;
    const Way* ways = &ways_[std::size_t(set) << way_bits_];
    std::uint32_t way = last_[set];   // a guess
    if (ways[way].line != line + 1) way = 0;
    while (way < std::uint32_t(shape_.ways) && ways[way].line != line + 1) ++way;
    if (way == std::uint32_t(shape_.ways)) return ask(request, line, set);
    in_.pop();
    touch(set, way);
    if (const std::uint32_t m = ways[way].mshr) {
        next_[mshrs_[m - 1].tail] = request.id;
        mshrs_[m - 1].tail = request.id;
        return CacheDeed::merge;
    }
    answers_.admit(now) = request.id;
    return CacheDeed::hit;
}

}   // namespace rayclock
