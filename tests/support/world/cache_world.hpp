#pragma once
// The environment of a cache in a test: rays that send requests, and a memory that answers late and in any
// order. Also a plain description of the line that a set evicts.
#include <map>
#include <set>

#include "tests/support/dut/cache_dut.hpp"
#include "tests/support/world/traffic.hpp"

namespace rayclock::test {

/// A plain tree-PLRU: the ways of a set are halved repeatedly, and each pair of halves records which one was
/// used last.
class OldestWay {
public:
    explicit OldestWay(int ways) : ways_(ways) {}
    void use(int way) {
        for (int from = 0, count = ways_; count > 1;) {
            count /= 2;
            const bool upper = way >= from + count;
            upper_was_last_[{from, count}] = upper;
            if (upper) from += count;
        }
    }
    int oldest() const {
        int from = 0;
        for (int count = ways_; count > 1;) {
            count /= 2;
            const auto last = upper_was_last_.find({from, count});
            if (last != upper_was_last_.end() && !last->second) from += count;
        }
        return from;
    }

private:
    int ways_;
    std::map<std::pair<int, int>, bool> upper_was_last_;   // before any use the lower half is older
};

/// The lines in a set.
class SetJudge {
public:
    explicit SetJudge(int ways) : lines_(std::size_t(ways)), age_(ways) {}
    bool has(std::uint32_t line) const {
        return std::find(lines_.begin(), lines_.end(), line) != lines_.end();
    }
    int oldest() const { return age_.oldest(); }
    std::optional<std::uint32_t> line(int way) const { return lines_[std::size_t(way)]; }
    /// Requests `line` and returns its way. It may not evict the ways in `waiting`.
    int request(std::uint32_t line, const std::set<int>& waiting = {}) {
        const auto at = std::find(lines_.begin(), lines_.end(), line);
        int way = int(at - lines_.begin());
        if (at == lines_.end()) {
            way = age_.oldest();
            if (waiting.count(way))
                for (way = 0; waiting.count(way); ++way) {}
            lines_[std::size_t(way)] = line;
        }
        age_.use(way);
        return way;
    }

private:
    std::vector<std::optional<std::uint32_t>> lines_;
    OldestWay age_;
};

/// Sends requests with all ids to lines that hit, miss, merge and evict each other. The memory has random
/// latency and reorders words. Checks that every request is answered once with the memory's content. Each
/// word of a line must be requested once, while a request waits for it.
template <class K> class CacheWorld {
public:
    using Req = typename K::Req;
    CacheWorld(const Config& config, unsigned seed, const Pace& pace, int requests)
        : config_(config),
          shape_(K::shape(config)),
          flow_(pace),
          draw_(seed),
          left_(requests),
          requested_(std::size_t(K::ids(config))),
          lines_(std::size_t(shape_.mshrs)),
          rsp_(config),
          miss_(config),
          slowest_(1 << draw_.below(7)),
          rest_(draw_.below(2) * 40) {}

    bool finished() const { return left_ == 0 && !pending_ && under_way_ == 0; }
    int answers() const { return answers_; }

    /// Sets the inputs of one cycle, equal for every machine that receives them.
    void drive(CacheLinks<K>& dut) {
        if (!pending_ && left_ > 0 && !draw_.percent(flow_.idle_percent)) make_request();
        dut.req.offer = pending_;
        dut.rsp.ready = !draw_.percent(flow_.stall_percent);
        dut.miss.ready = !draw_.percent(rest_);
        dut.fill.reset();
        std::vector<std::size_t> due;
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (words_[i].due <= now_) due.push_back(i);
        if (due.empty() || draw_.percent(rest_)) return;
        const std::size_t i = due[std::size_t(draw_.below(int(due.size())))];
        dut.fill = typename K::Fill{words_[i].id, line_at(words_[i].addr)};
        words_.erase(words_.begin() + std::ptrdiff_t(i));
    }

    /// Checks the transfers of the cycle.
    void watch(const CacheLinks<K>& dut) {
        rsp_.check(dut.rsp);
        miss_.check(dut.miss);
        if (dut.rsp.fires()) answered(*dut.rsp.offer);
        if (dut.fill) filled(dut.fill->id);
        if (dut.req.fires()) {
            requested_[K::id(*pending_)] = pending_;
            pending_.reset();
            ++under_way_;
        }
        if (dut.miss.fires()) missed(dut.miss.offer->id, dut.miss.offer->addr);
        ++now_;
    }

private:
    struct Word {
        std::uint32_t id, addr;
        int due;
    };
    struct OnItsWay {
        std::uint32_t line = 0, requested = 0, came = 0;   // `requested` and `came`: a bit for each word
    };
    std::uint32_t words() const { return std::uint32_t(shape_.words); }
    std::uint32_t line_of(const Req& req) const { return req.addr / K::parts / words(); }
    std::uint32_t all() const { return (1u << words()) - 1; }

    void make_request() {
        std::vector<std::uint32_t> free;
        for (std::uint32_t id = 0; id < requested_.size(); ++id)
            if (!requested_[id]) free.push_back(id);
        if (free.empty()) return;
        const int room = shape_.sets * shape_.ways, kind = draw_.below(100);
        const std::uint32_t lines = (1u << max_addr_bits) / words();
        if (kind < 40)
            line_ = std::uint32_t(draw_.below((room + 1) / 2));
        else if (kind < 60)
            line_ = std::uint32_t(draw_.below(3 * room));
        else if (kind < 80)
            line_ = (line_ + std::uint32_t(shape_.sets * draw_.below(8))) % lines;   // in the same set
        else if (kind < 85)
            line_ = std::uint32_t(draw_.natural(max_addr_bits)) / words();
        Req req;
        const std::uint32_t id = free[std::size_t(draw_.below(int(free.size())))];
        if constexpr (requires { req.ray; })
            req.ray = id;
        else
            req.id = id;
        req.addr = line_ * words() * K::parts + std::uint32_t(draw_.below(int(words() * K::parts)));
        pending_ = req;
        --left_;
    }

    void answered(const typename K::Rsp& rsp) {
        auto& requested = requested_.at(K::id(rsp));
        INFO("id " << K::id(rsp));
        REQUIRE(requested);
        REQUIRE(same(rsp, K::answer(*requested, config_), config_));
        REQUIRE(came_.count(line_of(*requested)) == 1);
        requested.reset();
        --under_way_;
        ++answers_;
    }

    void missed(std::uint32_t id, std::uint32_t addr) {
        const std::uint32_t word = id % words(), line = addr / words();
        INFO("word " << word << " of line " << line << " requested with id " << id);
        REQUIRE(addr % words() == word);
        OnItsWay& mine = lines_.at(id / words());
        if (mine.requested == all()) REQUIRE(mine.came == all());
        if (mine.came == all()) mine = {};
        if (mine.requested == 0) {
            for (const OnItsWay& other : lines_)
                REQUIRE_FALSE((other.line == line && other.requested != 0 && other.came != all()));
            mine.line = line;
            REQUIRE(std::any_of(requested_.begin(), requested_.end(),
                                [&](const auto& req) { return req && line_of(*req) == line; }));
        }
        REQUIRE(mine.line == line);
        REQUIRE((mine.requested >> word & 1) == 0);
        mine.requested |= 1u << word;
        words_.push_back({id, addr, now_ + 1 + draw_.below(slowest_)});
    }

    void filled(std::uint32_t id) {
        OnItsWay& mine = lines_[id / words()];
        mine.came |= 1u << id % words();
        if (mine.came == all()) came_.insert(mine.line);
    }

    Config config_;
    CacheShape shape_;
    Pace flow_;
    Draw draw_;
    int left_, under_way_ = 0, answers_ = 0, now_ = 0;
    std::vector<std::optional<Req>> requested_;   // by id
    std::vector<OnItsWay> lines_;                 // by MSHR
    std::vector<Word> words_;
    std::set<std::uint32_t> came_;   // lines that have ever arrived
    Steady<typename K::Rsp> rsp_;
    Steady<typename K::Miss> miss_;
    int slowest_, rest_;
    std::uint32_t line_ = 0;
    std::optional<Req> pending_;
};

/// Runs single cycles by hand. Memory answers only on request of the test.
template <class Dut> class CacheBench {
public:
    using K = typename Dut::CacheKind;
    explicit CacheBench(const Config& config_) : config(config_), shape(K::shape(config_)), dut(config_) {
        dut.rsp.ready = dut.miss.ready = true;
    }

    /// Returns the address of a part of a line; `part` counts through the line's words.
    std::uint32_t addr(std::uint32_t line, std::uint32_t part = 0) const { return line * parts() + part; }
    std::uint32_t parts() const { return std::uint32_t(shape.words) * K::parts; }

    CacheLinks<K> cycle(std::optional<typename K::Req> req = {}, std::optional<std::uint32_t> word = {}) {
        dut.req.offer = req;
        dut.fill.reset();
        if (word) dut.fill = typename K::Fill{*word, line_at(wanted.at(*word))};
        dut.eval();
        CacheLinks<K> seen = dut;
        dut.commit();
        seen.outcome = dut.outcome;
        if (seen.miss.fires()) {
            wanted[seen.miss.offer->id] = seen.miss.offer->addr;
            ++misses;
        }
        return seen;
    }
    CacheLinks<K> look_up(std::uint32_t id, std::uint32_t address) { return cycle(request(id, address)); }
    static typename K::Req request(std::uint32_t id, std::uint32_t address) {
        typename K::Req req;
        if constexpr (requires { req.ray; })
            req.ray = id;
        else
            req.id = id;
        req.addr = address;
        return req;
    }
    bool right(const std::optional<typename K::Rsp>& rsp, std::uint32_t id, std::uint32_t address) const {
        return rsp && same(*rsp, K::answer(request(id, address), config), config);
    }
    /// Requests an address and waits for the answer of an immediate memory. Returns true for a hit.
    bool get(std::uint32_t address) {
        const int before = misses;
        std::deque<std::uint32_t> words;
        CacheLinks<K> seen = look_up(0, address);
        REQUIRE(seen.req.fires());
        for (int n = 0; n < 100; ++n) {
            if (seen.miss.fires()) words.push_back(seen.miss.offer->id);
            if (seen.rsp.fires()) {
                REQUIRE(right(seen.rsp.offer, 0, address));
                return misses == before;
            }
            std::optional<std::uint32_t> word;
            if (!words.empty()) {
                word = words.front();
                words.pop_front();
            }
            seen = cycle({}, word);
        }
        FAIL("no answer");
        return false;
    }

    Config config;
    CacheShape shape;
    Dut dut;
    std::map<std::uint32_t, std::uint32_t> wanted;   ///< addresses by the id of their memory request
    int misses = 0;                                  ///< number of requested words
};

}   // namespace rayclock::test
