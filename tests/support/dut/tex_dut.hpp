#pragma once
// One interface for the model and the RTL of unit tex, and the traffic of its tests.
#include <utility>
#include <vector>

#include "model/unit/tex/texel.hpp"
#include "model/unit/tex/tex.hpp"
#include "tests/support/cases/tex_cases.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// The links of tex. The cache drives `texels_wait`.
struct TexLinks {
    Wire<TexReq> req;
    Wire<TexelReq> texel_req;
    Wire<TexelRsp> texel_rsp;
    bool texels_wait = false;
    std::optional<TexRsp> rsp;
    std::uint32_t cause = 0;
};

/// The model's values and timing together, as pipeline.cpp combines them.
class TexModel : public TexLinks {
public:
    TexModel(const Config& config, const Frame& frame, int = 1)
        : config_(config),
          spread_(frame.shade.spread),
          tex_(config),
          hits_(std::size_t(config.contexts)),
          places_(std::size_t(config.contexts)),
          answers_(std::size_t(config.contexts)),
          reads_texels_(std::size_t(config.contexts)) {}

    void eval() {
        const bool texels = tex_.requests_texels();
        req.ready = texel_req.ready && !texels;
        texel_req.offer.reset();
        if (texels)
            texel_req.offer = TexelReq{tex_.texel_ray(), places_[tex_.texel_ray()].line};
        else if (req.offer)
            texel_req.offer = TexelReq{req.offer->ray, req.offer->record};
        texel_rsp.ready = true;
        rsp.reset();
        if (const LinkRay answer = tex_.answer(now_); answer.valid) rsp = answers_[answer.ray];
        cause = texel_rsp.offer ? 0 : texels_wait ? 1 : 2;
    }
    void commit() {
        if (req.fires()) hits_[req.offer->ray] = *req.offer;
        LinkRay record, texels;
        if (texel_rsp.fires()) {
            const TexelRsp& came = *texel_rsp.offer;
            (reads_texels_[came.ray] ? texels : record) = {true, came.ray};
            if (texels.valid) {
                answers_[came.ray] = filter_texels(came.line, places_[came.ray], config_.texels);
                answers_[came.ray].ray = came.ray;
            } else {
                places_[came.ray] = texel_place(hits_[came.ray], unpack<TexRecord>(came.line.data(), config_),
                                                spread_, config_);
            }
        }
        tex_.clock(now_++, texel_req.offer.has_value(), texel_req.fires(), record, texels);
        if (texel_req.fires()) reads_texels_[texel_req.offer->ray] = !req.fires();
    }

private:
    Config config_;
    std::int32_t spread_;
    Tex tex_;
    std::vector<TexReq> hits_;         // [ray]
    std::vector<TexelPlace> places_;   // [ray]
    std::vector<TexRsp> answers_;      // [ray]
    std::vector<bool> reads_texels_;   // [ray]
    std::uint64_t now_ = 0;
};

class TexRtl : public TexLinks {
public:
    TexRtl(const Config& config, const Frame& frame, int seed = 1) : links_(config, "rc_tex", seed) {
        links_.fix("frame", frame);
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_in("req", req);
        links_.read_out("texel_req", texel_req);
        links_.read_in("texel_rsp", texel_rsp);
        links_.read_told("rsp", rsp);
        cause = links_.plain("cause");
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_in("req", req);
        links_.drive_out("texel_req", texel_req);
        links_.drive_in("texel_rsp", texel_rsp);
        links_.drive_plain("texels_wait", texels_wait);
    }
    RtlLinks links_;
};

/// Drives tex: shade with random hits, and a memory that answers requests in any order. It draws the answer
/// to each request when the request comes.
class TexWorld {
public:
    /// `idle`, `stall`: the shares of cycles, in percent, in which shade and memory offer nothing, and in
    /// which the cache accepts no request.
    TexWorld(const Config& config, const Frame& frame, unsigned seed, int idle, int stall)
        : config_(config),
          spread_(frame.shade.spread),
          idle_(idle),
          stall_(stall),
          draw_(seed),
          cutoffs_(std::size_t(config.contexts)) {
        for (int ray = 0; ray < config.contexts; ++ray) free_.push_back(std::uint32_t(ray));
    }

    /// Sets tex's inputs for a cycle.
    void drive(TexLinks& in) {
        if (!hit_ && !free_.empty() && !draw_.percent(idle_)) {
            hit_ = random_hit(draw_, config_);
            hit_->ray = take(free_);
            hit_->record = std::uint32_t(draw_.natural(config_.addr_bits));
        }
        in.req.offer = hit_;
        in.texel_req.ready = !draw_.percent(stall_);
        in.texel_rsp.offer.reset();
        if (!pending_.empty() && !draw_.percent(idle_)) in.texel_rsp.offer = take(pending_);
        in.texels_wait = draw_.coin();
    }
    /// Processes the outputs of the cycle.
    void take_over(const TexLinks& out) {
        if (out.rsp) free_.push_back(out.rsp->ray), ++answered;
        if (out.texel_req.fires()) {
            const std::uint32_t ray = out.texel_req.offer->ray;
            TexelRsp answer{ray, {}};
            if (!out.req.fires()) {
                answer.line = random_texels(draw_, cutoffs_[ray], config_.texels);
            } else {
                answer.line = random_texels(draw_);
                TexRecord record = random_record(draw_, config_);
                cutoffs_[ray] = record.cutoff;
                if (draw_.percent(70)) aim_level(draw_, *hit_, record, spread_);
                Words words = pack(record, config_);
                for (std::size_t i = 0; i < words.size(); ++i) {
                    const int kept = std::min(bits_of<TexRecord>(config_) - 32 * int(i), 32);
                    const std::uint32_t mask = kept == 32 ? ~0u : (1u << kept) - 1;
                    answer.line[i] = (answer.line[i] & ~mask) | (words[i] & mask);   // other bits stay random
                }
            }
            pending_.push_back(answer);
        }
        if (out.req.fires()) hit_.reset();
    }

    int answered = 0;

private:
    template <class T> T take(std::vector<T>& from) {
        const auto at = from.begin() + draw_.below(int(from.size()));
        const T value = *at;
        from.erase(at);
        return value;
    }
    Config config_;
    std::int32_t spread_;
    int idle_, stall_;
    Draw draw_;
    std::vector<std::uint32_t> cutoffs_;   // [ray], of the record that it has read last
    std::vector<std::uint32_t> free_;
    std::optional<TexReq> hit_;
    std::vector<TexelRsp> pending_;
};

/// Judges every output of tex in every cycle, from the unit's specified timing and the rules of
/// tex_cases.hpp.
class TexJudge {
public:
    TexJudge(const Config& config, const Frame& frame)
        : config_(config), spread_(frame.shade.spread), rays_(std::size_t(config.contexts)) {}

    void check(const TexLinks& seen) {
        if (!addressed_.empty() && addressed_.front().first == now_) {
            waiting_.push_back(addressed_.front().second);
            addressed_.pop_front();
        }
        // Requests: texels go first. An offer that was not accepted stays.
        const bool texels = !held_record_ && !waiting_.empty();
        REQUIRE(seen.req.ready == (seen.texel_req.ready && !texels));
        REQUIRE(seen.texel_req.offer.has_value() == (texels || seen.req.offer));
        if (texels) {
            const std::uint32_t ray = waiting_.front();
            CAPTURE(ray, rays_[ray].place.level, rays_[ray].place.line, seen.texel_req.offer->addr);
            REQUIRE(seen.texel_req.offer->ray == ray);
            REQUIRE(seen.texel_req.offer->addr == rays_[ray].place.line);
        } else if (seen.req.offer) {
            REQUIRE(seen.texel_req.offer->ray == seen.req.offer->ray);
            REQUIRE(seen.texel_req.offer->addr == seen.req.offer->record);
        }
        held_record_ = !texels && seen.req.offer && !seen.texel_req.ready;
        overtaken += texels && seen.req.offer;
        REQUIRE(seen.texel_rsp.ready);

        // Answers come exactly after the filter's latency.
        const bool due = !filtered_.empty() && filtered_.front().first == now_;
        REQUIRE(seen.rsp.has_value() == due);
        if (due) {
            const TexRsp& wanted = filtered_.front().second;
            REQUIRE(seen.rsp->ray == wanted.ray);
            REQUIRE(seen.rsp->colour == wanted.colour);
            REQUIRE(seen.rsp->hole == wanted.hole);
            filtered_.pop_front();
        }
        REQUIRE(seen.cause == (seen.texel_rsp.offer ? 0u : seen.texels_wait ? 1u : 2u));

        // The edge.
        if (seen.req.fires()) rays_[seen.req.offer->ray] = {*seen.req.offer, {}, Next::record};
        if (texels && seen.texel_req.ready) rays_[waiting_.front()].next = Next::texels, waiting_.pop_front();
        if (seen.texel_rsp.fires()) arrive(*seen.texel_rsp.offer);
        ++now_;
    }
    bool is_done() const { return filtered_.empty() && addressed_.empty() && waiting_.empty(); }

    int overtaken = 0;              ///< cycles in which texels had priority over a waiting hit's record
    std::array<int, 13> levels{};   ///< hits by level
    int clamped = 0, mixed = 0;     ///< hits beyond the last level; with both weights
    int holes = 0;                  ///< hits of a hole
    int edges = 0;                  ///< hits where alpha is exactly the cut-off, which is not 0
    int below_edges = 0;            ///< holes where alpha is less than one 255th below the cut-off
    std::array<std::vector<bool>, 3> codes{std::vector<bool>(256), std::vector<bool>(256),
                                           std::vector<bool>(256)};   ///< seen with weight 1

private:
    enum class Next { none, record, texels };
    struct RayState {
        TexReq hit;
        WantedPlace place;
        Next next = Next::none;
    };
    void arrive(const TexelRsp& came) {
        RayState& ray = rays_[came.ray];
        REQUIRE(ray.next != Next::none);
        if (ray.next == Next::record) {
            const TexRecord record = unpack<TexRecord>(came.line.data(), config_);
            ray.place = wanted_place(ray.hit, record, spread_, config_);
            addressed_.emplace_back(now_ + std::uint64_t(config_.tex_address_latency()) + 1, came.ray);
            ++levels[std::size_t(ray.place.level)];
            clamped += level_in_64ths(ray.hit, record, spread_) >= 64 * int(record.last_level) + 32;
            mixed += ray.place.weight_x != 0 && ray.place.weight_y != 0;
        } else {
            TexRsp answer = wanted_answer(came.line, ray.place, config_.texels);
            answer.ray = came.ray;
            filtered_.emplace_back(now_ + std::uint64_t(config_.tex_filter_latency()), answer);
            const std::int64_t above = above_cutoff(came.line, ray.place, config_.texels);
            holes += above < 0, edges += above == 0 && ray.place.cutoff > 0;
            below_edges += above < 0 && above > -65536;
            const std::uint32_t bits = texel_bits(came.line, ray.place.x, ray.place.y, config_.texels);
            if (ray.place.weight_x == 0 && ray.place.weight_y == 0)
                for (std::size_t k = 0; k < 3; ++k) codes[k][texel_code(bits, k, config_.texels)] = true;
        }
        ray.next = Next::none;
    }

    Config config_;
    std::int32_t spread_;
    std::vector<RayState> rays_;
    std::deque<std::pair<std::uint64_t, std::uint32_t>> addressed_;   // when, ray
    std::deque<std::uint32_t> waiting_;                               // rays that may request texels
    std::deque<std::pair<std::uint64_t, TexRsp>> filtered_;           // when, what
    bool held_record_ = false;
    std::uint64_t now_ = 0;
};

/// Returns a frame with a typical spread, or a spread at an end of its range.
inline Frame tex_frame(unsigned number) {
    constexpr std::int32_t most = (1 << (level_bits - 1)) - 1;
    constexpr std::int32_t spreads[] = {-704, most, -most - 1, 0};
    Frame frame;
    frame.shade.spread = spreads[number % std::size(spreads)];
    return frame;
}

}   // namespace rayclock::test
