#pragma once
// The whole chip under Verilator, driven by its registers.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "model/compile/upload.hpp"
#include "model/layout/memory_image.hpp"
#include "model/layout/words.hpp"
#include "model/machine/links.hpp"
#include "model/mem/memory.hpp"
#include "model/scene/whitted.hpp"
#include "model/trace/decoder.hpp"
#include "sim/run/rtl/rtl_module.hpp"

namespace rayclock {

/// rtl/rc_chip.sv under Verilator, with the same memory and sinks as the model's Machine. It is driven
/// through its registers, as by a host. The memory's time does not advance during bus accesses.
class RtlMachine {
public:
    RtlMachine(const MemoryImage& image, const Config& config, int khz, Disturbance disturbance = {},
               int seed = 1, Waves waves = Waves::no);

    /// Calls `see` in every cycle of a bus access, and of the start of a frame, when its transfers are known.
    /// The chip may make transfers then, although the memory's time does not advance.
    void watch(std::function<void()> see) { see_ = std::move(see); }

    /// Starts a new frame; the caches keep their contents.
    void start(const Frame& frame);

    /// Act between frames as Machine's functions do. After change(), the memory holds the host's writes.
    void reset();
    void write(const std::vector<std::uint32_t>& lines) { memory_.write(lines); }
    void finish_writes();
    void change(const Upload& upload);

    /// Performs the first half of a cycle: drives the memory's answer and the sinks' ready. Then the masks
    /// and link() show the transfers of the cycle.
    void settle();
    /// Performs the second half: the clock edge. Passes hits to `take`: those that leave in this cycle, or if
    /// the chip writes them, all of them from memory when the last one is written. Throws RtlAssertion.
    template <class Take> void clock(Take&& take) {
        for (int p = 0; !config_.writes_hits() && p < config_.pipelines; ++p) {
            if (!(fire_[std::size_t(p)] & bit(Link::hit))) continue;
            HitOut hit = get_data<HitOut>(*links_[std::size_t(p)][index(Link::hit)], config_);
            if (check_hit(p, hit)) take(hit);
        }
        const bool was_done = done();
        clock();
        if (config_.writes_hits() && done() && !was_done) read_hits(take);
    }
    template <class Take> void step(Take&& take) {
        settle();
        clock(take);
    }

    /// The first impossible value of the RTL. It is a line beyond the memory image or the hits, a request
    /// whose id is in flight, or an unknown primitive. It may also be a pixel that is outside the picture or
    /// arrives twice. The value is not passed on: the memory returns zeros or does not answer, and the pixel
    /// is dropped or gets no hit. The machine runs on.
    struct InvalidValue {
        int pipeline = 0;
        Link link{};
        std::string what;
        std::uint64_t cycle = 0;
    };
    const std::optional<InvalidValue>& invalid_value() const { return invalid_value_; }

    bool done() const { return finished_pixels_ >= pixels_; }
    /// Return the chip's own signals about the frame, after settle().
    bool running() const;
    bool done_signal() const;   ///< in the first cycle also true if it was set since the frame was requested
    std::uint64_t cycle() const { return now_; }
    std::uint64_t finished_pixels() const { return finished_pixels_; }
    LinkMask valid_mask(int pipeline) const { return valid_[std::size_t(pipeline)]; }
    LinkMask fire_mask(int pipeline) const { return fire_[std::size_t(pipeline)]; }
    LinkMask shared_valid() const { return shared_valid_; }
    LinkMask shared_fire() const { return shared_fire_; }
    /// True if a link makes a transfer in this cycle. Shared links ignore `pipeline`.
    bool fires(int pipeline, Link c) const {
        return (index(c) < pipeline_links ? fire_mask(pipeline) : shared_fire_) & bit(c);
    }
    bool moved() const { return moved_; }
    /// Returns the packed payload that a link offers in this cycle. Shared links have pipeline 0.
    const RcPort& link(int pipeline, Link c) const { return *links_[std::size_t(pipeline)][index(c)]; }
    /// Return the ports of a ray's end inside a pipeline: the engine's `done`, and the pixel on its way to
    /// sched.
    const RcPort& done_port(int pipeline) const { return *ends_[std::size_t(pipeline)].done; }
    const RcPort& pixel_port(int pipeline) const { return *ends_[std::size_t(pipeline)].pixel; }
    /// Returns the counts since the last start(), from the chip's own counters and from the memory. Stops
    /// counting in an unfinished frame. This takes two cycles, which appear in its counters and also pass for
    /// the memory.
    const Accounts& accounts();
    /// Returns the register `cycles` for the same period.
    std::uint64_t counted_cycles();
    /// Returns the module, for waveforms if it has them.
    RtlModule& module() { return rtl_; }
    const Memory& memory() const { return memory_; }
    std::uint64_t box_tests() const { return box_tests_; }
    const RayCounts& rays() const { return rays_; }

private:
    void drive();
    void sample_links();
    void clock_bus();
    void clock();
    std::optional<Memory::Answer> request();
    void store(const MemReq& request);
    /// Reads the frame's hits from memory, as a host does.
    template <class Take> void read_hits(Take&& take) {
        const std::size_t room = words_per_line / std::size_t(hits_of_line(config_));
        for (std::uint64_t i = 0; i < pixels_; ++i) {
            auto record = unpack<HitRecord>(&hit_lines_[std::size_t(i) * room], config_);
            if (!record.valid)
                complain(0, Link::mem_req, fmt::format("hit {} in memory without its valid bit", i));
            else if (check_hit(0, record.hit))
                take(record.hit);
        }
    }
    bool check_hit(int pipeline, HitOut& hit);
    void count_boxes(int pipeline);
    void complain(int pipeline, Link link, const std::string& what);
    void read_counters();
    std::uint64_t read_counter(std::uint32_t address);
    void write_register(std::uint32_t address, std::uint32_t value);
    std::uint32_t read_register(std::uint32_t address);
    bool access(bool writes, std::uint32_t address, std::uint32_t value);
    void quiet_ports();

    Config config_;
    std::vector<std::size_t> there_;   // the pipeline links that this chip has
    const MemoryImage* image_;
    MemoryImage changed_;              // a copy, once the host writes
    std::optional<Decoder> decoder_;   // only counts the children of box tests
    RtlModule rtl_;
    std::vector<std::array<const RcPort*, link_count>> links_;
    struct RayEnds {
        const RcPort *done, *pixel;
    };
    std::vector<RayEnds> ends_;   // of each pipeline
    struct Bus {
        const RcPort *cyc, *stb, *we, *adr, *dat, *ack, *err, *read;
    } bus_;
    const RcPort *running_, *done_, *mem_req_, *mem_rsp_, *hit_ready_;
    Memory memory_;
    Disturbance disturbance_;
    std::vector<Sink> sinks_;
    RayCounts rays_;   // refractions count as reflections, because the link does not distinguish them
    std::uint64_t now_ = 0, finished_pixels_ = 0, pixels_ = 0, box_tests_ = 0;
    std::vector<LinkMask> valid_, fire_;
    LinkMask shared_valid_ = 0, shared_fire_ = 0;
    std::function<void()> see_;
    bool moved_ = false, kept_done_ = false;   // kept_done_: `done` was set while the frame was prepared
    std::vector<std::uint8_t> under_way_;      // [id] of requests to memory
    std::vector<std::uint8_t> given_;          // [y * width + x] of the frame's pixels
    std::uint32_t width_ = 1;
    Words hit_lines_;   // memory from this line on, if the chip writes hits
    std::uint32_t first_hit_line_ = 0;
    std::optional<InvalidValue> invalid_value_;
    std::optional<Accounts> accounts_;                 // empty until the counters are read
    std::uint64_t counted_cycles_ = 0, started_ = 0;   // started_: the frame's first cycle
    std::array<std::uint64_t, cause_count> memory_at_start_{};
};

}   // namespace rayclock
