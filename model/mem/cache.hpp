#pragma once
// The caches of the machine, cycle by cycle.
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "model/core/config.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// Size of a cache. A word is one answer of the memory, 64 bytes.
struct CacheShape {
    int sets = 64, ways = 4;
    int words = 1;   ///< words per line
    int mshrs = 8;   ///< most lines in flight
    int queue = 4;   ///< most waiting answers
    int ids = 64;    ///< request ids lie in 0..ids-1; an id is used again only after its answer
    int cut = 0;     ///< 1: a register before the look-up, and one after the data
};
CacheShape node_cache_shape(const Config& config);
CacheShape prim_cache_shape(const Config& config);
CacheShape surf_cache_shape(const Config& config);
CacheShape stream_cache_shape(const Config& config);
CacheShape tex_cache_shape(const Config& config);
CacheShape l2_shape(const Config& config);

/// The outcome of a cache in a cycle.
enum class CacheOutcome : std::uint8_t {
    hit,        ///< looked up a request, and the line is present
    miss,       ///< the line is absent: requested it
    merge,      ///< the line is in flight: the request joined its chain
    drain,      ///< answered a request that had waited for its line
    starved,    ///< nothing to look up
    mshrs,      ///< stalled on a miss: no MSHR is free
    conflict,   ///< stalled on a miss: all ways of the set wait for lines
    answers,    ///< stalled: the answers are not accepted
};
constexpr std::size_t cache_outcomes = 8;

/// Non-blocking, set-associative cache in time only; the memory image holds the data. Misses to a line in
/// flight merge. Hits pass misses. Any number of requests may wait for one line, in a chain through their
/// ids.
///
/// A request enters a queue of two. The cache looks up the queue's head, one in every cycle:
/// - A hit reads the data memory, and answers 3 cycles after the request was accepted.
/// - A miss takes a free MSHR and the set's pseudo-least-recently-used way. If that way waits for a line, it
///   takes the lowest way that does not. It requests the line's words one by one.
///
/// Words come back in any order. From the cycle after the last word, the cache answers the waiting requests,
/// one per cycle, in the order of the requests. This has priority over look-ups, and the way stays until
/// then. A look-up that stalls stays at the head. With `cut` the head waits for its look-up in a register,
/// and an answer takes two cycles more. Mirror of rtl/mem/rc_cache.sv.
class Cache {
public:
    struct Request {
        std::uint32_t id = 0;
        std::uint32_t addr = 0;   ///< in words
    };
    /// A word requested from memory. Its id is mshr * words + word of the line.
    using Miss = Request;

    explicit Cache(const CacheShape& shape);

    // `uncut`: the caller knows that the shape has no `cut`.
    template <bool uncut = false> bool ready() const {
        return !(!uncut && shape_.cut ? input_queue_.full() : in_.full());
    }
    template <bool uncut = false> bool valid() const {
        return answers_.size() > std::uint32_t(read_) + std::uint32_t(!uncut && reading_);
    }
    std::uint32_t answer() const { return answers_.front(); }   ///< id of the answered request
    /// True if a request to memory is on offer in cycle `now` of clock().
    bool miss_valid(std::uint64_t now = ~std::uint64_t(0)) const {
        return !misses_.empty() && misses_.front().since < now;
    }
    /// Returns the cycle from which on the first request to memory is on offer; never, if there is none.
    std::uint64_t next_miss() const {
        return misses_.empty() ? ~std::uint64_t(0) : misses_.front().since + 1;
    }
    Miss miss() const {
        const std::uint32_t m = misses_.front().mshr;
        return {m << word_bits_ | miss_word_, mshrs_[m].line << word_bits_ | miss_word_};
    }

    /// One clock edge. `asked`: `request` was accepted. `fill_id`: the id of the word that came, or null.
    /// `answer_taken`: this output was accepted. `now`: the number of the cycle, if miss_valid() needs it.
    template <bool uncut = false> CacheOutcome clock(bool asked, const Request& request, bool answer_taken,
                                                     const std::uint32_t* fill_id, std::uint64_t now = 0) {
        // Look-ups, drains and the room for answers depend on the state at the beginning of the cycle.
        const bool room = !answers_.full();
        CacheOutcome outcome;
        if (!filled_.empty()) [[unlikely]]
            outcome = drain(room, answer_taken);
        else
            outcome = look_up<uncut>(room, answer_taken, now);
        if (fill_id) [[unlikely]]
            fill(*fill_id);
        if (!uncut && shape_.cut)
            load(asked, request);
        else
            in_.push(request, asked);
        return outcome;
    }

    /// The offered request to memory was accepted. Call it before or after the cycle's clock().
    void take_miss() {
        if (++miss_word_ < std::uint32_t(shape_.words)) return;
        misses_.pop();
        miss_word_ = 0;
    }

    /// A word came from memory, in the cycle of the last clock() without a fill.
    void fill(std::uint32_t id);

    /// Looks up a word in no simulated time, for samples of a frame. If its line is absent, it immediately
    /// replaces another one. Returns true if the line was present.
    bool warm(std::uint32_t addr);
    int words() const { return shape_.words; }   ///< of a line

    bool answers() const { return !answers_.empty(); }   ///< now or in the next cycle
    bool loaded() const { return loaded_; }              ///< a request has just reached its look-up
    bool has_misses_in_flight() const { return busy_ > 0; }
    /// Returns the place of a request, for messages; empty if it is not here.
    std::string where(std::uint32_t id) const;

private:
    struct Mshr {
        bool busy = false;
        std::uint32_t line = 0, set = 0, way = 0, head = 0, tail = 0, words = 0;
    };
    static constexpr std::uint32_t max_ways = 8;
    /// The lines that a set's ways hold, and the MSHRs that these wait for.
    struct Set {
        std::array<std::uint32_t, max_ways> lines{};   ///< + 1; 0: none
        std::array<std::uint8_t, max_ways> mshrs{};    ///< + 1; 0: the line is present
        std::uint8_t recent = 0;                       ///< bits of the tree, node 1 at bit 1
    };
    template <bool uncut> CacheOutcome look_up(bool room, bool answer_taken, std::uint64_t now);
    std::uint32_t place_of(const Set& set, std::uint32_t line) const;
    CacheOutcome drain(bool room, bool answer_taken);
    template <bool uncut = false> void answer(bool taken, bool given, std::uint32_t id) {
        answers_.pop(taken);
        answers_.push(id, given);
        if (!uncut) reading_ = read_ & (shape_.cut != 0);
        read_ = given;
    }
    /// Moves the head of the queue to its look-up, if that is free.
    void load(bool asked, const Request& request) {
        loaded_ = in_.empty() & !input_queue_.empty();
        in_.push(input_queue_.front(), loaded_);
        input_queue_.pop(loaded_);
        input_queue_.push(request, asked);
    }
    CacheOutcome allocate_mshr(const Request& request, std::uint32_t line, std::uint32_t set,
                               std::uint64_t now);
    CacheOutcome merge_into_mshr(const Request& request, Set& set, std::uint32_t way);
    int victim(const Set& set) const;

    // A bit of the tree points to the half that was used longer ago. Using a way turns the bits above it away
    // from it.
    std::uint8_t touched(const Set& set, std::uint32_t way) const {
        return std::uint8_t((set.recent & plru_keep_[way]) | plru_set_[way]);
    }

    CacheShape shape_;
    int word_bits_;
    std::uint32_t set_mask_;
    std::vector<Set> sets_;
    std::array<std::uint8_t, max_ways> plru_keep_{}, plru_set_{};
    std::vector<Mshr> mshrs_;
    int busy_ = 0;
    std::vector<std::uint32_t> next_;   ///< [id]: the next request in its chain
    // With `cut`, input_queue_ lies before the request that is looked up.
    Ring<Request, 2> in_, input_queue_{2};
    struct Waiting {
        std::uint32_t mshr = 0;
        std::uint64_t since = 0;   ///< cycle of the look-up
    };
    Ring<Waiting> misses_;
    Ring<std::uint32_t> filled_;
    std::uint32_t miss_word_ = 0;
    bool loaded_ = false;
    Ring<std::uint32_t> answers_;
    bool read_ = false, reading_ = false;   // the last answer, and the one before, are still being read
};

/// Returns the way that holds this line, + 1; 0 if there is none. At most one way does.
inline std::uint32_t Cache::place_of(const Set& set, std::uint32_t line) const {
    using Four = std::uint32_t __attribute__((vector_size(16)));
    const auto among = [line](const std::uint32_t* lines, Four numbers) {
        Four held;
        std::memcpy(&held, lines, sizeof held);
        Four place = Four(held == line + 1) & numbers;
        place |= __builtin_shufflevector(place, place, 2, 3, 0, 1);
        place |= __builtin_shufflevector(place, place, 1, 0, 3, 2);
        return place[0];
    };
    std::uint32_t place = among(set.lines.data(), Four{1, 2, 3, 4});
    if (shape_.ways > 4) place |= among(set.lines.data() + 4, Four{5, 6, 7, 8});
    return place;
}

template <bool uncut> inline CacheOutcome Cache::look_up(bool room, bool answer_taken, std::uint64_t now) {
    const Request request = in_.front();
    const bool some = !in_.empty();
    const std::uint32_t line = request.addr >> word_bits_, number = line & set_mask_;
    Set& set = sets_[number];
    const std::uint32_t place = place_of(set, line);
    const bool found = place != 0;
    const std::uint32_t way = place - found;
    const bool hit = some & room & found & (set.mshrs[way] == 0);
    answer<uncut>(answer_taken, hit, request.id);
    set.recent = std::uint8_t(select(hit, touched(set, way), set.recent));
    in_.pop(hit);
    if (some & room & !hit) [[unlikely]]
        return found ? merge_into_mshr(request, set, way) : allocate_mshr(request, line, number, now);
    return !some ? CacheOutcome::starved : room ? CacheOutcome::hit : CacheOutcome::answers;
}

}   // namespace rayclock
