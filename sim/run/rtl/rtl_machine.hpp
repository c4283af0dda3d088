#pragma once
#include <optional>
#include <string>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/core/links.hpp"
#include "model/mem/memory.hpp"
#include "model/trace/decoder.hpp"
#include "model/compile/upload.hpp"
#include "sim/run/rtl/rtl_module.hpp"

namespace rayclock {

/// rtl/rc_chip.sv under Verilator with the same memory and sinks as the model's Machine has. It is driven as
/// a host drives it: by its registers. The memory's time stands still while the bus is in use.
class RtlMachine {
public:
    RtlMachine(const MemoryImage& image, const Config& config, int khz, Traffic traffic = {}, int seed = 1,
               Waves waves = Waves::no);

    /// A new frame; what lies in the caches stays.
    void start(const Frame& frame);

    /// Between frames, as Machine has them; and what the host has written stands in the memory from now on.
    void reset();
    void write(const std::vector<std::uint32_t>& lines) { memory_.write(lines); }
    void finish_writes();
    void change(const Upload& upload);

    /// First half of a cycle: drives memory's answer and the sinks' ready; then the masks and data() tell
    /// what the cycle moves. Second half: the clock edge; hits go to `take`.
    void settle();
    template <class Take> void clock(Take&& take) {
        for (int p = 0; p < config_.pipelines; ++p) {
            if (!(fire_[std::size_t(p)] & bit(Link::hit))) continue;
            HitOut hit = get_data<HitOut>(*links_[std::size_t(p)][index(Link::hit)], config_);
            if (check_hit(p, hit)) take(hit);
        }
        clock();
    }
    template <class Take> void step(Take&& take) {
        settle();
        clock(take);
    }

    /// The first thing the RTL said that no machine can mean: a line beyond the memory image, a request whose
    /// id is under way, a pixel that is not there or has come already, a primitive that the scene lacks. It
    /// is not passed on: memory gives zeros or no answer, the pixel is dropped or holds nothing, and the
    /// machine runs on.
    struct Nonsense {
        int pipeline = 0;
        Link link{};
        std::string what;
        std::uint64_t cycle = 0;
    };
    const std::optional<Nonsense>& nonsense() const { return nonsense_; }

    bool done() const { return hits_ >= pixels_; }
    /// What the chip's own signals say of the frame, after settle().
    bool says_running() const;
    bool says_done() const;   ///< in the first cycle also, if it said so since the frame was asked for
    std::uint64_t cycle() const { return now_; }
    std::uint64_t hits() const { return hits_; }
    LinkMask valid_mask(int pipeline) const { return valid_[std::size_t(pipeline)]; }
    LinkMask fire_mask(int pipeline) const { return fire_[std::size_t(pipeline)]; }
    LinkMask shared_valid() const { return shared_valid_; }
    LinkMask shared_fire() const { return shared_fire_; }
    bool moved() const { return moved_; }
    /// Packed payload that a link offers in this cycle; shared ones have pipeline 0.
    const RcPort& link(int pipeline, Link c) const { return *links_[std::size_t(pipeline)][index(c)]; }
    /// Inside a pipeline, the end of a ray: the engine says that it is done, and the pixel on its way to
    /// sched.
    const RcPort& done_port(int pipeline) const { return *ends_[std::size_t(pipeline)].done; }
    const RcPort& pixel_port(int pipeline) const { return *ends_[std::size_t(pipeline)].pixel; }
    /// From the chip's own counters, except for the memory, since the last start(). A frame that is under way
    /// is counted no further; the two cycles that this takes are in its counters, and pass for the memory as
    /// well.
    const Accounts& accounts();
    /// What the register `cycles` says of the same time.
    std::uint64_t counted_cycles();
    /// For waveforms, if it has them.
    RtlModule& module() { return rtl_; }
    const Memory& memory() const { return memory_; }
    std::uint64_t box_tests() const { return box_tests_; }
    const RayCounts& rays() const { return rays_; }

private:
    void drive();
    void clock();
    std::optional<Memory::Answer> request();
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
    std::vector<std::size_t> there_;   // the links of a pipeline that this chip has
    const MemoryImage* image_;
    MemoryImage changed_;              // if the host has written into it
    std::optional<Decoder> decoder_;   // only to count what the box tests were made on
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
    Traffic traffic_;
    std::vector<Sink> sinks_;
    RayCounts rays_;   // refracted ones are counted with the reflected: the link does not tell them apart
    std::uint64_t now_ = 0, hits_ = 0, pixels_ = 0, box_tests_ = 0;
    std::vector<LinkMask> valid_, fire_;
    LinkMask shared_valid_ = 0, shared_fire_ = 0;
    bool moved_ = false, kept_done_ = false;   // kept_done_: done was set while the frame was prepared
    std::vector<std::uint8_t> under_way_;      // [id] of requests to memory
    std::vector<std::uint8_t> given_;          // [y * width + x] of the frame's pixels
    std::uint32_t width_ = 1;
    std::optional<Nonsense> nonsense_;
    std::optional<Accounts> accounts_;                 // once they are read
    std::uint64_t counted_cycles_ = 0, started_ = 0;   // started_: the frame's first cycle
    std::array<std::uint64_t, cause_count> memory_at_start_{};
};

}   // namespace rayclock
