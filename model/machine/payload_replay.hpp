#pragma once
// The payload of every transfer, for lockstep.
#include <deque>
#include <unordered_map>

#include "model/layout/words.hpp"
#include "model/machine/machine.hpp"
#include "model/trace/walk.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/unit/shade/shader.hpp"

namespace rayclock {

/// Computes the payload of every transfer of a machine, ray by ray, from the units' pure functions. The
/// machine itself holds only timing.
class PayloadReplay {
public:
    PayloadReplay(const MemoryImage& image, const Config& config)
        : image_(image), config_(config), decoder_(image, config) {}

    void start(const Frame& frame) {
        frame_ = frame;
        walks_.clear();
        for (int i = 0; i < config_.pipelines * config_.contexts; ++i)
            walks_.emplace_back(frame_, config_, decoder_);
        if (config_.has_shade()) shaders_.assign(walks_.size(), Shader(frame_, config_, image_));
        words_.clear();
        records_.clear();
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
    std::uint32_t& requested(const Move& m, Link request) {
        return words_[std::uint64_t(m.pipeline) << 40 | std::uint64_t(index(request)) << 32 | m.id];
    }

    const MemoryImage& image_;
    Config config_;
    Decoder decoder_;
    Frame frame_;
    std::deque<Walk> walks_;        // [pipeline * contexts + context]
    std::vector<Shader> shaders_;   // [pipeline * contexts + context], if the chip shades
    std::unordered_map<std::uint64_t, std::uint32_t> words_;   // requested addresses
    std::deque<HitRecord> records_;                            // answers that are not written yet
    Words scratch_;
};

template <class See> void PayloadReplay::operator()(const Move& m, See&& see) {
    const auto emit = [&](const auto& payload) { see(m.pipeline, m.link, payload); };
    const auto emit_request = [&]<class E>(E) {   // trav -> the node unit
        Walk& w = walk(m);
        emit(E::request(m.id, w.form<E>(), unpack<typename E::Node>(image_.line(w.node()), config_)));
        w.visit_node();
    };
    const auto answer = [&] {
        emit(walk(m).node_answer());
        bool done = false;
        if (!walk(m).has_leaves()) walk(m).decide(done);   // trav makes no request to list
    };
    switch (m.link) {
        case Link::tile: return emit(Tile{m.x, m.y});
        case Link::slot:
            if (!config_.is_stream()) walk(m).start({m.id, m.x, m.y});
            if (config_.has_shade()) shader(m).start({m.id, m.x, m.y});
            return emit(Slot{m.id, m.x, m.y});
        case Link::ray:
            if (config_.has_shade()) shader(m).sent(walk(m).ray());
            return emit(walk(m).ray());
        case Link::node_req: return emit(NodeReq{m.id, walk(m).node()});
        case Link::xform_req: {
            Walk& w = walk(m);
            emit(XformReq{m.id, w.ray().o, w.ray().d, unpack<Placement>(image_.line(w.node()), config_),
                          w.ray().kind, w.ray().home});
            w.visit_node();
            return;
        }
        case Link::change: {
            emit(walk(m).change());
            bool done = false;
            walk(m).decide(done);
            return;
        }
#define RAYCLOCK_CASES(with, structure, unit, Engine)     \
    case Link::unit##_req: return emit_request(Engine{}); \
    case Link::unit##_rsp: return answer();
            RAYCLOCK_ENGINES(RAYCLOCK_CASES, )
#undef RAYCLOCK_CASES
        case Link::leaves:
            if (config_.is_list()) walk(m).visit_node();
            return emit(walk(m).leaves());
        case Link::prim_req: return emit(PrimReq{m.id, walk(m).prim()});
        case Link::tri_req: {
            Walk& w = walk(m);
            const Ray& r = w.ray();
            emit(TriReq{m.id, w.o(), w.d(), w.primitive(), w.best(), r.shear, r.kind, r.self, r.is_inside,
                        r.is_partial});
            w.test_triangle();
            return;
        }
        case Link::tri_rsp:
            emit(walk(m).tri());
            walk(m).advance();
            return;
        case Link::tested: {
            bool done = false;
            emit(walk(m).tested());
            walk(m).decide(done);
            return;
        }
        case Link::hit:
            if (config_.writes_hits()) records_.push_back({1, {m.x, m.y, walk(m).closest(), {}}});
            if (!config_.has_shade()) return emit(HitOut{m.x, m.y, walk(m).closest(), {}});
            return emit(HitOut{m.x, m.y, shader(m).pixel().first, shader(m).pixel().colour});
        case Link::closest:
            emit(walk(m).closest());
            shader(m).arrived(walk(m).closest());
            if (!shader(m).wants_surface()) shader(m).run();
            return;
        case Link::surf_req: return emit(SurfReq{m.id, shader(m).next_line()});
        case Link::surf_rsp:
            emit(SurfRsp{m.id, unpack<Surface>(image_.line(shader(m).next_line()), config_)});
            if (!shader(m).got_line()) return;
            shader(m).run();
            return;
        case Link::spawn:
            emit(shader(m).spawn());
            walk(m).start_at(spawn_ray(shader(m).spawn(), frame_, config_));
            return;
        case Link::record: {
            const StreamRsp given{m.id,
                                  unpack<RayRecord>(image_.record(m.y << config_.pixel_bits | m.x), config_)};
            walk(m).start_at(recorded_ray(given.record, m.id, config_));
            return emit(given);
        }
        case Link::stream_miss:
            requested(m, Link::stream_miss) = m.addr;
            return emit(StreamMiss{m.id, m.addr});
        case Link::stream_fill: return emit(StreamFill{m.id, line(requested(m, Link::stream_miss))});
        // A textured hit reads one texture record and one line of texels; run() has read both.
        case Link::tex_req: requested(m, Link::texel_req) = 0; return emit(shader(m).texture()->request);
        case Link::texel_req: {
            std::uint32_t& addr = requested(m, Link::texel_req);
            const Shader::Texture& read = *shader(m).texture();
            addr = addr == 0 ? read.request.record : read.place.line;
            return emit(TexelReq{m.id, addr});
        }
        case Link::texel_rsp: return emit(TexelRsp{m.id, line(requested(m, Link::texel_req))});
        case Link::tex_rsp: return emit(shader(m).texture()->answer);
        case Link::tex_miss: requested(m, Link::tex_miss) = m.addr; return emit(TexMiss{m.id, m.addr});
        case Link::tex_fill: return emit(TexFill{m.id, line(requested(m, Link::tex_miss))});
        case Link::surf_miss: requested(m, Link::surf_miss) = m.addr; return emit(SurfMiss{m.id, m.addr});
        case Link::surf_fill: return emit(SurfFill{m.id, line(requested(m, Link::surf_miss))});
        case Link::node_miss: requested(m, Link::node_miss) = m.addr; return emit(NodeMiss{m.id, m.addr});
        case Link::prim_miss: requested(m, Link::prim_miss) = m.addr; return emit(PrimMiss{m.id, m.addr});
        case Link::l2_req: requested(m, Link::l2_req) = m.addr; return emit(L2Req{m.id, m.addr});
        case Link::mem_req: {
            MemReq request{m.id, m.addr, m.is_write, {}};
            const std::size_t room = words_per_line / std::size_t(hits_of_line(config_));
            for (std::size_t i = 0; i < m.records; ++i)
                write_payload(records_[i], config_, &request.line[i * room], scratch_);
            if (m.is_write) records_.erase(records_.begin(), records_.begin() + m.records);
            return emit(request);
        }
        case Link::node_fill: return emit(NodeFill{m.id, line(requested(m, Link::node_miss))});
        case Link::prim_fill: return emit(PrimFill{m.id, line(requested(m, Link::prim_miss))});
        case Link::l2_rsp: return emit(L2Rsp{m.id, line(requested(m, Link::l2_req))});
        case Link::mem_rsp: return emit(MemRsp{m.id, line(m.addr)});
    }
}

}   // namespace rayclock
