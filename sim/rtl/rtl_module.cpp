#include "sim/rtl/rtl_module.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include <dlfcn.h>

#include "sim/rtl/builder.hpp"

namespace rayclock {

RtlModule::RtlModule(const Config& config, const std::string& module, int seed)
    : reset_cycles_(4 + std::max({config.node_sets, config.prim_sets, config.l2_sets})) {
    const RtlBuild build = build_rtl(config, module);
    library_ = dlopen(build.library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library_) throw std::runtime_error(std::string("cannot load the built RTL: ") + dlerror());
    module_ = static_cast<const RcModule*>(dlsym(library_, "rc_module"));
    if (!module_) throw std::runtime_error(build.library.string() + ": not a library of this program; remove it");
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
    if (module_->eval(handle_, 1)) throw std::runtime_error("an assertion of the RTL failed, see the line above");
}

void copy_words(const RcPort& port, const Words& words) { std::memcpy(port.data, words.data(), port.bytes < 4 * words.size() ? port.bytes : 4 * words.size()); }

} // namespace rayclock
