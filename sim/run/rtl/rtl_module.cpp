// Loading a built library with dlopen().
#include "sim/run/rtl/rtl_module.hpp"

#include <cstring>
#include <stdexcept>

#include <dlfcn.h>

#include "sim/run/rtl/builder.hpp"

namespace rayclock {

namespace {

/// The opened library and its functions, or the loader's error message.
struct Opened {
    void* library = nullptr;
    const RcModule* module = nullptr;
    std::string complaint;

    explicit Opened(const RtlBuild& build) : library(dlopen(build.library.c_str(), RTLD_NOW | RTLD_LOCAL)) {
        if (library) module = static_cast<const RcModule*>(dlsym(library, "rc_module"));
        if (module) return;
        complaint = dlerror();
        if (library) dlclose(library);
    }
};

}   // namespace

RtlModule::RtlModule(const Config& config, const std::string& module, int seed, Waves waves)
    : reset_cycles_(config.clear_cycles()) {
    RtlBuild build = build_rtl(config, module, waves);
    Opened opened(build);
    // The module is undamaged, but comes from another machine or from a faulty program.
    if (!opened.module && build.was_cached) {
        forget_rtl(build);
        build = build_rtl(config, module, waves);
        opened = Opened(build);
    }
    if (!opened.module) throw std::runtime_error("the built RTL cannot be loaded: " + opened.complaint);
    library_ = opened.library;
    module_ = opened.module;
    if (waves == Waves::yes) wave_ = static_cast<const RcWave*>(dlsym(library_, "rc_wave"));
    handle_ = module_->open(seed);
    count_ = module_->ports(handle_, &ports_);
}

RtlModule::~RtlModule() {
    if (handle_) module_->close(handle_);
    if (library_) dlclose(library_);
}

const RcPort& RtlModule::port(const std::string& name) const {
    for (unsigned i = 0; i < count_; ++i)
        if (name == ports_[i].name) return ports_[i];
    throw std::logic_error("the RTL module has no port " + name);
}

void RtlModule::reset() {
    *module_->reset(handle_) = 0;
    for (int i = 0; i < reset_cycles_; ++i) {
        settle();
        clock();
    }
    *module_->reset(handle_) = 1;
    settle();
}

void RtlModule::settle() { module_->eval(handle_, 0); }

void RtlModule::clock() {
    if (module_->eval(handle_, 1)) throw RtlAssertion();
}

void copy_words(const RcPort& port, const Words& words) {
    std::memcpy(port.data, words.data(), port.bytes < 4 * words.size() ? port.bytes : 4 * words.size());
}

}   // namespace rayclock
