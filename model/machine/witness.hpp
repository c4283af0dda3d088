#pragma once
// The payload of every transfer, for lockstep.
#include <deque>
#include <unordered_map>

#include "model/machine/machine.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/unit/shade/shader.hpp"
#include "model/trace/walk.hpp"

namespace rayclock {

/// Computes the payload of every transfer of a machine, ray by ray, from the units' pure functions. The
/// machine itself holds only timing.
class Witness {
public:
    Witness(const MemoryImage& image, const Config& config)
        : image_(image), config_(config), decoder_(image, config) {}

    void start(const Frame& frame) {
        frame_ = frame;
        walks_.clear();
        for (int i = 0; i < config_.pipelines * config_.contexts; ++i)
            walks_.emplace_back(frame_, config_, decoder_);
        if (config_.has_shade()) shaders_.assign(walks_.size(), Shader(frame_, config_, image_));
        words_.clear();
    }

    /// Calls `see(pipeline, link, payload)` with the payload of a transfer. Call it in the order of the
    /// machine's cycles.
    template <class See> void operator()(const Move& m, See&& see);

private:
    Shader& shader(const Move& m) { return shaders_[std::size_t(m.pipeline * config_.contexts) + m.id]; }
    Walk& walk(const Move& m) { return walks_[std::size_t(m.pipeline * config_.contexts) + m.id]; }
    Line line(std::uint32_t addr) const {
        Line words;
        std::copy_n(image_.line(addr), words.size(), words.begin());
        return words;
    }
    /// Returns the stored address of a cache's request. It stays until the answer, which has the same id.
    std::uint32_t& asked(const Move& m, Link request) {
        return words_[std::uint64_t(m.pipeline) << 40 | std::uint64_t(index(request)) << 32 | m.id];
    }

    const MemoryImage& image_;
    Config config_;
    Decoder decoder_;
    Frame frame_;
    std::deque<Walk> walks_;        // [pipeline * contexts + context]
    std::vector<Shader> shaders_;   // [pipeline * contexts + context], if the chip shades
    std::unordered_map<std::uint64_t, std::uint32_t> words_;   // requested addresses
};

template <class See> void Witness::operator()(const Move& m, See&& see) {
    const auto tell = [&](const auto& payload) { see(m.pipeline, m.link, payload); };
    const auto ask = [&]<class E>(E) {   // trav -> the unit that decides nodes
        Walk& w = walk(m);
        tell(E::request(m.id, w.form<E>(), unpack<typename E::Node>(image_.line(w.node()), config_)));
        w.test_node();
    };
    const auto answer = [&] {
        tell(walk(m).boxes());
        bool done = false;
        if (!walk(m).has_leaves()) walk(m).decide(done);   // trav makes no request to list
    };
    switch (m.link) {
        case Link::tile: return tell(Tile{m.x, m.y});
        case Link::slot:
            if (!config_.is_stream()) walk(m).start({m.id, m.x, m.y});
            if (config_.has_shade()) shader(m).start({m.id, m.x, m.y});
            return tell(Slot{m.id, m.x, m.y});
        case Link::ray:
            if (config_.has_shade()) shader(m).sent(walk(m).ray());
            return tell(walk(m).ray());
        case Link::node_req: return tell(NodeReq{m.id, walk(m).node()});
        case Link::xform_req: {
            Walk& w = walk(m);
            tell(XformReq{m.id, w.ray().o, w.ray().d, unpack<Placement>(image_.line(w.node()), config_),
                          w.ray().kind, w.ray().home});
            w.test_node();
            return;
        }
        case Link::change: {
            tell(walk(m).change());
            bool done = false;
            walk(m).decide(done);
            return;
        }
#define RAYCLOCK_CASES(with, structure, unit, Engine) \
    case Link::unit##_req: return ask(Engine{});      \
    case Link::unit##_rsp: return answer();
            RAYCLOCK_ENGINES(RAYCLOCK_CASES, )
#undef RAYCLOCK_CASES
        case Link::leaves:
            if (config_.is_list()) walk(m).test_node();
            return tell(walk(m).leaves());
        case Link::prim_req: return tell(PrimReq{m.id, walk(m).prim()});
        case Link::tri_req: {
            Walk& w = walk(m);
            const Ray& r = w.ray();
            tell(TriReq{m.id, w.o(), w.d(), w.primitive(), w.best(), r.shear, r.kind, r.self, r.inside,
                        r.partial});
            w.test_triangle();
            return;
        }
        case Link::tri_rsp:
            tell(walk(m).tri());
            walk(m).advance();
            return;
        case Link::tested: {
            bool done = false;
            tell(walk(m).tested());
            walk(m).decide(done);
            return;
        }
        case Link::hit:
            if (!config_.has_shade()) return tell(HitOut{m.x, m.y, walk(m).closest(), {}});
            return tell(HitOut{m.x, m.y, shader(m).pixel().first, shader(m).pixel().colour});
        case Link::closest:
            tell(walk(m).closest());
            shader(m).arrived(walk(m).closest());
            if (!shader(m).wants_surface()) shader(m).run();
            return;
        case Link::surf_req: return tell(SurfReq{m.id, shader(m).next_line()});
        case Link::surf_rsp:
            tell(SurfRsp{m.id, unpack<Surface>(image_.line(shader(m).next_line()), config_)});
            if (!shader(m).got_line()) return;
            shader(m).run();
            return;
        case Link::spawn:
            tell(shader(m).spawn());
            walk(m).start_at(spawn_ray(shader(m).spawn(), frame_, config_));
            return;
        case Link::record: {
            const StreamRsp given{m.id,
                                  unpack<RayRecord>(image_.record(m.y << config_.pixel_bits | m.x), config_)};
            walk(m).start_at(recorded_ray(given.record, m.id, config_));
            return tell(given);
        }
        case Link::stream_miss: asked(m, Link::stream_miss) = m.addr; return tell(StreamMiss{m.id, m.addr});
        case Link::stream_fill: return tell(StreamFill{m.id, line(asked(m, Link::stream_miss))});
        case Link::surf_miss: asked(m, Link::surf_miss) = m.addr; return tell(SurfMiss{m.id, m.addr});
        case Link::surf_fill: return tell(SurfFill{m.id, line(asked(m, Link::surf_miss))});
        case Link::node_miss: asked(m, Link::node_miss) = m.addr; return tell(NodeMiss{m.id, m.addr});
        case Link::prim_miss: asked(m, Link::prim_miss) = m.addr; return tell(PrimMiss{m.id, m.addr});
        case Link::l2_req: asked(m, Link::l2_req) = m.addr; return tell(L2Req{m.id, m.addr});
        case Link::mem_req: return tell(MemReq{m.id, m.addr});
        case Link::node_fill: return tell(NodeFill{m.id, line(asked(m, Link::node_miss))});
        case Link::prim_fill: return tell(PrimFill{m.id, line(asked(m, Link::prim_miss))});
        case Link::l2_rsp: return tell(L2Rsp{m.id, line(asked(m, Link::l2_req))});
        case Link::mem_rsp: return tell(MemRsp{m.id, line(m.addr)});
    }
}

}   // namespace rayclock
