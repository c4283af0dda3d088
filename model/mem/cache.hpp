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
        const LookUp made = look_up_or_drain(!answers_.full(), now);
        answers_.pop(answer_taken);
        answers_.push(made.answer.ray, made.answer.valid);
        if (!uncut) reading_ = read_ & (shape_.cut != 0);
        read_ = made.answer.valid;
        if (fill_id) [[unlikely]]
            fill(*fill_id);
        if (!uncut && shape_.cut)
            load(asked, request);
        else
            in_.push(request, asked);
        return made.outcome;
    }

    /// A look-up or drain, and the request that it answers.
    struct LookUp {
        CacheOutcome outcome;
        LinkRay answer;
    };
    /// True if an answer leaves in the second cycle after its look-up, provided that it is then accepted.
    bool answers_at_once() const { return shape_.cut == 0 && shape_.queue > 2; }
    /// Does the same as clock() without a fill, if answers_at_once() and all answers are accepted. The queue
    /// of answers is not used.
    LookUp clock_unqueued(bool asked, const Request& request, std::uint64_t now) {
        const LookUp made = look_up_or_drain(true, now);
        in_.push(request, asked);
        return made;
    }
    /// Empties the queue of answers before calls of clock_unqueued(). Returns the answers of this cycle and
    /// of the next one.
    std::array<LinkRay, 2> take_answers();
    /// Fills it again, before other calls.
    void put_answers(const std::array<LinkRay, 2>& answers);

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
    /// The lines that a set's ways hold or wait for.
    struct alignas(64) Set {
        std::array<std::uint32_t, max_ways> lines{};   ///< + 1; 0: none
        std::array<std::uint8_t, max_ways> mshrs{};    ///< of lines in flight
        std::uint32_t recent = 0;                      ///< bits of the tree, node 1 at bit 1
    };
    static constexpr std::uint32_t in_flight = 1u << 31;   ///< flag of a line that a way waits for
    static bool waits(const Set& set, std::uint32_t way) { return set.lines[way] & in_flight; }
    LookUp look_up_or_drain(bool room, std::uint64_t now) {
        if (!filled_.empty()) [[unlikely]]
            return drain(room);
        return look_up(room, now);
    }
    LookUp look_up(bool room, std::uint64_t now);
    LookUp drain(bool room);
    std::uint32_t use_of(const Set& set, std::uint32_t line) const;
    CacheOutcome miss(const Request& request, std::uint32_t line, Set& set, std::uint64_t now);
    /// Moves the head of the queue to its look-up, if that is free.
    void load(bool asked, const Request& request) {
        loaded_ = in_.empty() & !input_queue_.empty();
        in_.push(input_queue_.front(), loaded_);
        input_queue_.pop(loaded_);
        input_queue_.push(request, asked);
    }
    int victim(const Set& set) const;

    // A bit of the tree points to the half that was used longer ago. Using a way turns the bits above it away
    // from it: uses_[way] has these bits' new values, then, from bit 8 on, ones for all other bits of the
    // tree. It is never 0.
    static std::uint32_t after(std::uint32_t recent, std::uint32_t use) {
        return (recent & use >> 8) | (use & 0xff);
    }

    CacheShape shape_;
    int word_bits_;
    std::uint32_t set_mask_;
    std::vector<Set> sets_;
    std::array<std::uint32_t, max_ways> uses_{};
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

/// Returns uses_ of the way that holds this line; 0 if none does. At most one way does.
inline std::uint32_t Cache::use_of(const Set& set, std::uint32_t line) const {
    using Four = std::uint32_t __attribute__((vector_size(16)));
    const auto among = [&](std::size_t first) {
        Four held, uses;
        std::memcpy(&held, set.lines.data() + first, sizeof held);
        std::memcpy(&uses, uses_.data() + first, sizeof uses);
        uses &= Four(held == line + 1);
        uses |= __builtin_shufflevector(uses, uses, 2, 3, 0, 1);
        uses |= __builtin_shufflevector(uses, uses, 1, 0, 3, 2);
        return uses[0];
    };
    return shape_.ways > 4 ? among(0) | among(4) : among(0);
}

inline Cache::LookUp Cache::look_up(bool room, std::uint64_t now) {
    const Request request = in_.front();
    const bool some = !in_.empty();
    const std::uint32_t line = request.addr >> word_bits_;
    Set& set = sets_[line & set_mask_];
    const std::uint32_t use = use_of(set, line);
    const bool hit = some & room & (use != 0);
    set.recent = select(hit, after(set.recent, use), set.recent);
    in_.pop(hit);
    if (some & room & !hit) [[unlikely]]
        return {miss(request, line, set, now), {}};
    return {!some  ? CacheOutcome::starved
            : room ? CacheOutcome::hit
                   : CacheOutcome::answers,
            {hit, request.id}};
}

}   // namespace rayclock
