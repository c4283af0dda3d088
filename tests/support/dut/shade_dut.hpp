#pragma once
// shade's model and RTL, with the same links, and the surroundings of both.
#include <utility>

#include "model/unit/shade/shade.hpp"
#include "tests/support/dut/dut.hpp"
#include "tests/support/cases/pass_cases.hpp"

namespace rayclock::test {

/// The links of shade's model and RTL. `slot` and `ray` are only observed; the cache drives `surf_waits`.
struct ShadeLinks {
    std::optional<Slot> slot;
    std::optional<Ray> ray;
    Wire<Closest> closest;
    Wire<SurfReq> surf_req;
    Wire<SurfRsp> surf_rsp;
    bool surf_waits = false;
    Wire<TexReq> tex_req;   // of a chip with textures
    std::optional<TexRsp> tex_rsp;
    Wire<Spawn> spawn;
    Wire<Pixel> pixel;
    std::uint32_t cause = 0;
};

/// Shade decides when, pass() what.
class ShadeModel : public ShadeLinks {
public:
    ShadeModel(const Config& config, const Frame& frame, int = 1)
        : config_(config), frame_(frame), shade_(config), contexts_(std::size_t(config.contexts)) {}
    void eval() {
        closest.ready = true;
        surf_req.offer.reset(), tex_req.offer.reset(), spawn.offer.reset(), pixel.offer.reset();
        if (shade_.surf_valid())
            surf_req.offer = SurfReq{shade_.surf_ray(), frame_.shade.first_surface_line +
                                                            contexts_[shade_.surf_ray()].in.hit.prim};
        if (shade_.texture_valid()) tex_req.offer = contexts_[shade_.texture_ray()].out.tex;
        if (shade_.spawn_valid()) spawn.offer = contexts_[shade_.spawn_ray()].out.spawn;
        if (shade_.pixel_valid()) pixel.offer = contexts_[shade_.pixel_ray()].out.pixel;
        surf_rsp.ready = shade_.ready();
        cause = shade_.code(surf_rsp.offer.has_value(), surf_waits);
    }
    void commit() {
        bool wants = false;
        if (closest.offer) {
            PassIn& in = contexts_[closest.offer->ray].in;
            in.hit = *closest.offer;
            wants = meets_cutout(in) || (in.hit.found && in.state.next_event == ShadeEvent::arrive);
        }
        if (surf_rsp.fires()) contexts_[surf_rsp.offer->ray].in.surface = surf_rsp.offer->surface;
        if (tex_rsp) {
            PassIn& in = contexts_[tex_rsp->ray].in;
            in.texel = tex_rsp->colour, in.hole = tex_rsp->hole;
        }
        const auto clock = [&]<bool textures>() {
            shade_.clock<false, textures>(
                now_++,
                {.closest = ray_of(closest.offer),
                 .fetch = wants ? Shade::Fetch::surface : Shade::Fetch::none,
                 .surface = ray_of(surf_rsp),
                 .textured = ray_of(tex_rsp),
                 .surf_taken = surf_req.fires(),
                 .spawn_taken = spawn.fires(),
                 .pixel_taken = pixel.fires(),
                 .texture_taken = tex_req.fires()},
                [this](std::uint32_t ray) { return contexts_[ray].pass(frame_, config_); });
        };
        if (config_.has_textures())
            clock.operator()<true>();
        else
            clock.operator()<false>();
        if (slot) {
            contexts_[slot->ray] = {};
            contexts_[slot->ray].in.ray = slot->ray;
            contexts_[slot->ray].in.state = fresh_state(slot->x, slot->y);
        }
        if (ray && !ends_at_any(ray->kind))
            contexts_[ray->ray].in.o = ray->o, contexts_[ray->ray].in.d = ray->d;
    }

private:
    struct Context {
        PassIn in;
        PassOut out;
        std::vector<Waiting> stack;
        Shade::Leave pass(const Frame& frame, const Config& config) {
            const bool pops = !meets_cutout(in) && event_of(in) == ShadeEvent::pop && !stack.empty();
            if (pops) in.top = stack.back(), stack.pop_back();
            out = rayclock::pass(in, frame, config);
            in.state = out.state;
            if (out.push) stack.push_back(out.pushed);
            return Shade::Leave(std::uint32_t(out.leave));
        }
    };
    Config config_;
    Frame frame_;
    Shade shade_;
    std::vector<Context> contexts_;
    std::uint64_t now_ = 0;
};

class ShadeRtl : public ShadeLinks {
public:
    ShadeRtl(const Config& config, const Frame& frame, int seed = 1)
        : has_textures_(config.has_textures()), links_(config, "rc_shade", seed) {
        links_.fix("frame", frame);
        drive();
        links_.reset();
    }
    void eval() {
        drive();
        links_.settle();
        links_.read_in("closest", closest);
        links_.read_in("surf_rsp", surf_rsp);
        links_.read_out("surf_req", surf_req);
        if (has_textures_) links_.read_out("tex_req", tex_req);
        links_.read_out("spawn", spawn);
        links_.read_out("pixel", pixel);
        cause = links_.plain("cause");
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_listen("slot", slot);
        links_.drive_listen("ray", ray);
        links_.drive_in("closest", closest);
        links_.drive_in("surf_rsp", surf_rsp);
        links_.drive_plain("surf_waits", surf_waits);
        links_.drive_out("surf_req", surf_req);
        if (has_textures_) {
            links_.drive_out("tex_req", tex_req);
            links_.drive_listen("tex_rsp", tex_rsp);
        }
        links_.drive_out("spawn", spawn);
        links_.drive_out("pixel", pixel);
    }
    bool has_textures_;
    RtlLinks links_;
};

/// The environment of shade: contexts receive pixels, rays are sent and answered, and surfaces come from
/// memory in the order of the requests. Texture colours come in any order. Everything is random. `idle`
/// percent of the cycles offer nothing, and `stall` percent accept nothing.
class ShadeWorld {
public:
    ShadeWorld(const Config& config, const Frame& frame, int idle, int stall, unsigned seed)
        : config_(config),
          frame_(frame),
          idle_(idle),
          stall_(stall),
          draw_(seed),
          free_(std::size_t(config.contexts)),
          surfaces_(free_.size()),
          cutouts_(free_.size()),
          kinds_(free_.size()) {
        for (std::size_t i = 0; i < free_.size(); ++i) free_[i] = std::uint32_t(i);
    }
    int pixels = 0, shadows = 0, bounces = 0, samples = 0, closed = 0, textures = 0, cutouts = 0;

    /// Drives the inputs of this cycle.
    void offer(ShadeLinks& in) {
        in.slot.reset(), in.ray.reset();
        if (before_) flying_.push_back(*before_);
        before_ = std::exchange(sent_, {});
        if (!free_.empty() && !draw_.percent(idle_)) {
            const std::uint32_t ray = take(free_);
            in.slot = Slot{ray, std::uint32_t(draw_.natural(config_.pixel_bits)),
                           std::uint32_t(draw_.natural(config_.pixel_bits))};
            made_.push_back(camera_ray(ray));
        } else if (!made_.empty() && !draw_.percent(idle_)) {
            in.ray = take(made_);
            sent_ = in.ray->ray;
            kinds_[in.ray->ray] = in.ray->kind;
        }
        in.closest.offer.reset();
        if (!in.ray && !flying_.empty() && !draw_.percent(idle_)) {
            const std::uint32_t ray = take(flying_);
            surfaces_[ray] = random_surface(draw_, config_);
            in.closest.offer = random_closest(draw_, config_, surfaces_[ray]);
            in.closest.offer->ray = ray;
            cutouts_[ray] =
                config_.has_textures() && ends_at_any(kinds_[ray]) && in.closest.offer->found && draw_.coin();
            in.closest.offer->cutout = cutouts_[ray];
            cutouts += int(cutouts_[ray]);
        }
        if (!surface_ && !requested_.empty() && !draw_.percent(idle_)) {
            surface_ = SurfRsp{requested_.front(), surfaces_[requested_.front()]};
            requested_.pop_front();
        }
        in.surf_rsp.offer = surface_;
        in.surf_waits = draw_.coin();
        in.tex_rsp.reset(), in.tex_req.ready = false;
        if (config_.has_textures()) {
            in.tex_req.ready = !draw_.percent(stall_);
            if (!textured_.empty() && !draw_.percent(idle_)) in.tex_rsp = texture_of(take(textured_));
        }
        in.surf_req.ready = !draw_.percent(stall_), in.spawn.ready = !draw_.percent(stall_),
        in.pixel.ready = !draw_.percent(stall_);
    }
    /// Processes the outputs of the cycle.
    void take_over(const ShadeLinks& out) {
        if (out.surf_rsp.fires()) surface_.reset();
        if (out.surf_req.fires()) requested_.push_back(out.surf_req.offer->ray);
        if (out.tex_req.fires()) textured_.push_back(out.tex_req.offer->ray), ++textures;
        if (out.pixel.fires()) free_.push_back(out.pixel.offer->first.ray), ++pixels;
        closed += out.cause == 3;
        if (!out.spawn.fires()) return;
        const Spawn& s = *out.spawn.offer;
        Ray ray = camera_ray(s.ray);
        ray.kind = s.kind, ray.o = s.o;
        if (s.kind != RayKind::camera) ray.d = s.d;
        made_.push_back(ray);
        (s.kind == RayKind::camera ? samples : s.kind == RayKind::bounce ? bounces : shadows)++;
    }

private:
    template <class T> T take(std::vector<T>& from) {
        const auto at = from.begin() + draw_.below(int(from.size()));
        const T value = *at;
        from.erase(at);
        return value;
    }
    /// Spheres and planes have no holes.
    TexRsp texture_of(std::uint32_t ray) {
        const bool may_have_hole = cutouts_[ray] || surfaces_[ray].kind == PrimKind::triangle;
        return {ray, may_have_hole && draw_.coin(), shares_up_to(draw_, share_bits)};
    }
    Ray camera_ray(std::uint32_t number) {
        Ray ray;
        ray.ray = number;
        ray.o = draw_place(draw_, config_);
        ray.d = draw_.vector(config_.dir_bits);
        return ray;
    }
    Config config_;
    Frame frame_;
    int idle_, stall_;
    Draw draw_;
    std::vector<std::uint32_t> free_;
    std::vector<Surface> surfaces_;        // the surface that the context's ray hit
    std::vector<std::uint32_t> cutouts_;   // 1 if it is a cut-out
    std::vector<RayKind> kinds_;
    // Rays sent in this cycle and in the previous one. No ray is answered in the cycle in which it is sent.
    std::optional<std::uint32_t> sent_, before_;
    std::vector<std::uint32_t> flying_;
    std::vector<Ray> made_;
    std::deque<std::uint32_t> requested_;
    std::vector<std::uint32_t> textured_;   // rays whose texture's colour will come
    std::optional<SurfRsp> surface_;
};

}   // namespace rayclock::test
