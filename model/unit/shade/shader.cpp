// Runs the passes of one context.
#include "model/unit/shade/shader.hpp"

#include <algorithm>
#include <cassert>

#include "model/scene/hit.hpp"

namespace rayclock {

void Shader::start(const Slot& slot) {
    in_ = {};
    in_.ray = slot.ray;
    in_.state = fresh_state(slot.x, slot.y);
    stack_.clear();
    signature_.start();
    ++counts_.primary;
}

void Shader::sent(const Ray& ray) {
    if (watch_) watch_->sent(ray);
    if (ends_at_any(ray.kind)) return;
    in_.o = ray.o;
    in_.d = ray.d;
}

void Shader::count(ShadeEvent event) {
    counts_.refraction += out_.refracted;
    if (out_.leave != PassOut::Leave::spawn) return;
    counts_.primary += out_.spawn.kind == RayKind::camera;
    counts_.shadow += event == ShadeEvent::light;
    counts_.reflection += event == ShadeEvent::reflect;
}

RayPurpose Shader::purpose() const {
    if (out_.spawn.kind == RayKind::camera) return RayPurpose::camera;
    return last_ == ShadeEvent::light     ? RayPurpose::shadow
           : last_ == ShadeEvent::reflect ? RayPurpose::reflection
                                          : RayPurpose::refraction;
}

void Shader::read_texture() {
    Texture read{out_.tex,
                 unpack<TexRecord>(image_->line(out_.tex.record), *config_),
                 {},
                 {},
                 out_.state.pending == Pending::texture};
    read.place = texel_place(read.request, read.record, frame_->shade.spread, *config_);
    Line texels;
    std::copy_n(image_->line(read.place.line), texels.size(), texels.begin());
    read.answer = filter_texels(texels, read.place, config_->texels);
    read.answer.ray = read.request.ray;
    in_.texel = read.answer.colour, in_.hole = read.answer.hole;
    if (watch_) watch_->filtered(read.request, read.record, read.place, read.answer);
    texture_ = read;
}

int Shader::run() {
    int passes = 0;
    texture_.reset();
    do {
        const ShadeEvent event = event_of(in_);
        const bool was_cutout = meets_cutout(in_), was_hole = passes_hole(in_),
                   has_texel = in_.state.pending == Pending::texture;
        if (event == ShadeEvent::pop && in_.state.waiting > 0) in_.top = stack_.back();
        out_ = pass(in_, *frame_, *config_);
        if (event == ShadeEvent::pop && out_.leave == PassOut::Leave::spawn && !stack_.empty())
            stack_.pop_back();
        if (out_.push) {
            assert(stack_.size() < std::size_t(config_->bounces) && "a ray waits at most at each depth");
            stack_.push_back(out_.pushed);
        }
        if (event == ShadeEvent::light && out_.leave == PassOut::Leave::again &&
            out_.state.pending == Pending::sure)
            signature_.asked(false);   // nothing can block the light, so no ray is sent
        if ((has_texel && !was_hole) || (was_cutout && out_.leave == PassOut::Leave::again))
            signature_.asked(true);   // the cut-out hides the light
        if (watch_) watch_->passed(in_, out_);
        in_.state = out_.state;
        count(event);
        last_ = event;
        ++passes;
        if (out_.leave == PassOut::Leave::texture) read_texture();
    } while (out_.leave == PassOut::Leave::again || out_.leave == PassOut::Leave::texture);
    return passes;
}

}   // namespace rayclock
