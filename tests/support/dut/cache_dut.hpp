#pragma once
// One interface for the model and the RTL of the caches, and the shapes in which they are tested.
#include "model/engine/engines.hpp"
#include "model/mem/cache.hpp"
#include "model/engine/check.hpp"
#include "model/mem/ideal_memory.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// Returns the memory's content at an address in units of 64 bytes: a function of the address.
inline Line line_at(std::uint32_t addr) {
    Rng rng{addr};
    Line line;
    for (auto& word : line) word = std::uint32_t(rng.next() >> 32);
    return line;
}

// ---- The three caches. A request's address is in parts of a memory word.

struct NodeCache {
    using Req = NodeReq;
    using Rsp = NodeRsp;
    using Miss = NodeMiss;
    using Fill = NodeFill;
    static constexpr const char* name = "rc_node_cache";
    static constexpr std::uint32_t parts = 1;
    static CacheShape shape(const Config& c) { return node_cache_shape(c); }
    static int ids(const Config& c) { return c.contexts; }
    static std::uint32_t id(const Req& req) { return req.ray; }
    static std::uint32_t id(const Rsp& rsp) { return rsp.ray; }
    static Rsp answer(const Req& req, const Config& c) {
        NodeRsp rsp;
        rsp.ray = req.ray;
        with_engine(c.engine(), [&]<class E>(E) {
            rsp.of<E>().node = unpack<typename E::Node>(line_at(req.addr).data(), c);
        });
        return rsp;
    }
};
struct PrimCache {
    using Req = PrimReq;
    using Rsp = PrimRsp;
    using Miss = PrimMiss;
    using Fill = PrimFill;
    static constexpr const char* name = "rc_prim_cache";
    static constexpr std::uint32_t parts = 2;
    static CacheShape shape(const Config& c) { return prim_cache_shape(c); }
    static int ids(const Config& c) { return c.contexts; }
    static std::uint32_t id(const Req& req) { return req.ray; }
    static std::uint32_t id(const Rsp& rsp) { return rsp.ray; }
    static Rsp answer(const Req& req, const Config& c) {
        return {req.ray, unpack<PrimData>(line_at(req.addr / 2).data() + 8 * (req.addr % 2), c)};
    }
};
struct SharedCache {
    using Req = L2Req;
    using Rsp = L2Rsp;
    using Miss = MemReq;
    using Fill = MemRsp;
    static constexpr const char* name = "rc_l2";
    static constexpr std::uint32_t parts = 1;
    static CacheShape shape(const Config& c) { return l2_shape(c); }
    static int ids(const Config& c) { return 1 << c.client_id_bits(); }
    static std::uint32_t id(const Req& req) { return req.id; }
    static std::uint32_t id(const Rsp& rsp) { return rsp.id; }
    static Rsp answer(const Req& req, const Config&) { return {req.id, line_at(req.addr)}; }
};

/// The links of a cache's model and RTL.
template <class K> struct CacheLinks {
    using CacheKind = K;
    Wire<typename K::Req> req;
    Wire<typename K::Rsp> rsp;
    Wire<typename K::Miss> miss;
    std::optional<typename K::Fill> fill;
    /// Known after commit() in the model, after eval() in the RTL.
    CacheOutcome outcome = CacheOutcome::starved;
};

template <class K> class CacheModel : public CacheLinks<K> {
public:
    explicit CacheModel(const Config& config, int = 1)
        : config_(config), cache_(K::shape(config)), requested_(std::size_t(K::shape(config).ids)) {}
    void eval() {
        this->req.ready = cache_.ready();
        this->rsp.offer.reset();
        if (cache_.valid()) this->rsp.offer = K::answer(requested_[cache_.answer()], config_);
        this->miss.offer.reset();
        if (cache_.miss_valid()) this->miss.offer = typename K::Miss{cache_.miss().id, cache_.miss().addr};
    }
    void commit() {
        Cache::Request request;
        if (this->req.fires()) {
            request = {K::id(*this->req.offer), this->req.offer->addr / K::parts};
            requested_[request.id] = *this->req.offer;
        }
        if (this->miss.fires()) cache_.take_miss();
        this->outcome = cache_.clock(this->req.fires(), request, this->rsp.fires(),
                                     this->fill ? &this->fill->id : nullptr);
    }

private:
    Config config_;
    Cache cache_;
    std::vector<typename K::Req> requested_;   // by id: the last request
};

template <class K> class CacheRtl : public CacheLinks<K> {
public:
    explicit CacheRtl(const Config& config, int seed = 1) : links_(config, K::name, seed) { reset(); }
    void reset() {
        static_cast<CacheLinks<K>&>(*this) = {};
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_in("req", this->req);
        links_.read_out("rsp", this->rsp);
        links_.read_out("miss", this->miss);
        this->outcome = CacheOutcome(links_.plain("outcome"));
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_in("req", this->req);
        links_.drive_out("rsp", this->rsp);
        links_.drive_out("miss", this->miss);
        links_.drive_listen("fill", this->fill);
    }
    RtlLinks links_;
};

/// Returns a shape for tests of the caches; all three caches of a configuration have the same.
inline Config cache_config(const std::string& name) {
    Config c = named_config(name == "four" ? "small" : "default");
    c.name = name;
    const auto all = [&](int sets, int ways, int line, int mshrs) {
        c.node_sets = c.prim_sets = c.l2_sets = sets;
        c.node_ways = c.prim_ways = c.l2_ways = ways;
        c.node_line = c.prim_line = c.l2_line = line;
        c.node_mshrs = c.prim_mshrs = c.l2_mshrs = mshrs;
    };
    if (name == "default")
        c.l2_sets = 64;
    else if (name == "smallest") {
        all(1, 1, 64, 1);
        c.contexts = 4;
        c.cache_queue = 2;
    } else if (name == "one context") {
        all(1, 1, 256, 1);
        c.contexts = 1;
        c.cache_queue = 2;
    } else if (name == "direct")
        all(16, 1, 128, 2);
    else if (name == "wide") {
        all(4, 8, 256, 16);
        c.cache_queue = 8;
    } else if (name == "four")
        all(4, 2, 64, 4);
    else if (name == "set") {
        all(1, 4, 128, 64);
        c.contexts = 256;
    } else
        throw std::logic_error("no cache is called " + name);
    check_config(c, name);
    return c;
}

}   // namespace rayclock::test
