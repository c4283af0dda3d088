// The list of registers, and the division of a frame into words.
#include "sim/run/gen/registers.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/core/layout.hpp"
#include "model/core/payloads.hpp"

namespace rayclock {

namespace {

/// Divides a payload's fields into words.
class WordVisitor {
public:
    explicit WordVisitor(int bits) : at_(bits) {}
    std::vector<FrameWord> words;
    template <class T> void operator()(const char* name, const T&, int width) {
        at_ -= width;
        cut(name, -1, width, at_);
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&, int width, int count) {
        at_ -= width * count;
        for (int i = 0; i < count; ++i) cut(name, i, width, at_ + width * i);
    }

private:
    void cut(const char* name, int element, int width, int at) {
        for (int low = 0; low < width; low += 32)
            words.push_back({name, element, low, std::min(32, width - low), at + low});
    }
    int at_;
};

}   // namespace

const std::vector<HostRegister>& host_registers() {
    static const std::vector<HostRegister> all{
        {0, "Magic", "magic", Access::read, "`RCLK` in ASCII, 0x52434c4b"},
        {1, "Version", "version", Access::read, "version of these registers: 2"},
        {2, "Status", "status", Access::read,
         "bit 0: busy, a frame or the preparation of one is under way; bit 1: done, a frame has ended and no "
         "other was started"},
        {3, "Start", "start", Access::write, "bit 0 starts a frame; 0 does nothing"},
        {4, "Count", "count", Access::both,
         "bit 0: cycles are counted, 1 after a reset; bit 1 (read only): the chip has counters"},
        {5, "Left", "left", Access::read,
         "pixels of the frame that have not come out yet, or rays without a record in memory"},
        {6, "Cycles", "cycles", Access::read,
         "cycles counted since the frame's start, bits 31..0; reading it keeps the upper word"},
        {7, nullptr, "cycles_high", Access::read,
         "bits 39..32 of `cycles`, at the time of the last read of `cycles`"}};
    return all;
}

std::uint32_t register_address(const std::string& constant) {
    for (const HostRegister& r : host_registers())
        if (r.constant && constant == r.constant) return r.address;
    throw std::logic_error("no register of the chip is called " + constant);
}

std::vector<HostParameter> host_parameters(const Config& c) {
    const auto u = [](int value) { return std::uint32_t(value); };
    std::vector<HostParameter> all{{"coord_bits", u(c.coord_bits)},
                                   {"dir_bits", u(c.dir_bits)},
                                   {"t_frac_bits", u(c.t_frac_bits)},
                                   {"bary_bits", u(c.bary_bits)},
                                   {"origin_bits", u(c.origin_frac())},
                                   {"box_bits", u(c.box_bits)},
                                   {"node_width", u(c.node_width)},
                                   {"stack_depth", u(c.stack_depth)},
                                   {"contexts", u(c.contexts)},
                                   {"pipelines", u(c.pipelines)},
                                   {"addr_bits", u(c.addr_bits)},
                                   {"prim_bits", u(c.prim_bits)},
                                   {"pixel_bits", u(c.pixel_bits)},
                                   {"mem_id_bits", u(c.mem_id_bits())},
                                   {"hit_bits", u(bits_of<HitOut>(c))},
                                   {"frame_words", u(int(frame_words(c).size()))},
                                   {"primitive_test", u(int(c.primitive_test))},
                                   {"shading", u(c.shading)},
                                   {"spheres", u(c.spheres)},
                                   {"planes", u(c.planes)},
                                   {"smooth", u(c.smooth)},
                                   {"refraction", u(c.refraction)},
                                   {"supersampling", u(c.supersampling)},
                                   {"lights", u(c.has_shade() ? c.lights : 0)},
                                   {"bounces", u(c.has_shade() ? c.bounces : 0)},
                                   {"structure", u(int(c.engine()))},
                                   {"mesh_structure", u(int(c.lower_engine()))}};
    if (c.panes > 0) all.push_back({"panes", u(c.panes)});
    if (c.is_stream()) all.push_back({"source", u(int(c.source))});
    if (c.writes_hits()) all.push_back({"hits_of_line", u(hits_of_line(c))});
    return all;
}

std::vector<FrameWord> frame_words(const Config& config) {
    WordVisitor visitor(bits_of<Frame>(config));
    Frame{}.fields(visitor, config);
    return std::move(visitor.words);
}

std::vector<std::uint32_t> frame_values(const Frame& frame, const Config& config) {
    Words packed = pack(frame, config);
    packed.push_back(0);   // padding for reads beyond the last word
    std::vector<std::uint32_t> values;
    for (const FrameWord& word : frame_words(config)) {
        const auto at = std::size_t(word.at / 32);
        const std::uint64_t two = packed[at] | std::uint64_t(packed[at + 1]) << 32;
        values.push_back(std::uint32_t(two >> word.at % 32 & ((std::uint64_t(1) << word.bits) - 1)));
    }
    return values;
}

}   // namespace rayclock
