#pragma once
// Judges the transfers of the RTL's rays: values and order, not cycles.
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/machine/payload_replay.hpp"
#include "sim/run/elastic/findings.hpp"
#include "sim/run/elastic/script.hpp"

namespace rayclock {

/// Follows each context of the RTL through the script of its pixel. A transfer must be the next one of its
/// ray, and carry the value that the units' pure functions give. Contexts may get pixels in any order, and
/// rays may overtake each other. After the first wrong transfer of a pixel's rays the judge ignores the
/// context until it gets another pixel.
class RayJudge {
public:
    /// `free[unit]`: the don't-care outputs of this unit are not compared.
    RayJudge(const Config& config, const RtlMachine& rtl, const std::array<bool, unit_count>& free,
             Findings& findings);

    /// Begins a frame. The image must outlive it.
    void start(const Frame& frame, const MemoryImage& image, Script script);
    /// Judges the transfers of a cycle, after RtlMachine::settle().
    void cycle(std::uint64_t now);

    /// Returns the cycle of the last correct transfer, or of start() if there was none.
    std::uint64_t moved_at() const { return moved_at_; }
    /// Returns the number of unfinished pixels. Does not count pixels with a wrong transfer.
    std::size_t unfinished() const { return script_->size() - finished_ - wrong_; }
    /// Describes the transfer that has been due longest. Call it if unfinished() is not 0.
    Divergence missing(std::uint64_t now);
    /// Returns the pixel of a context.
    Slot pixel(int pipeline, std::uint32_t ray) const;

private:
    struct Context {
        enum class State { idle, busy, wrong } state = State::idle;
        std::uint32_t x = 0, y = 0;
        std::span<const std::uint8_t> links;
        std::size_t next = 0;   ///< position in `links` of the next transfer
        std::uint64_t since = 0;
        /// `done`: the end of the last ray has passed the engine's port `done`. `pixel`: it has passed the
        /// port `pixel` of list or shade.
        bool done = false, pixel = false;
    };
    /// A transfer of a pixel, as it should be.
    struct ExpectedTransfer {
        Link link;
        Words words;   ///< the payload
        std::string text;
    };
    Context* context(int pipeline, std::uint32_t ray) {
        if (ray >= std::uint32_t(config_.contexts)) return nullptr;
        return &contexts_[std::size_t(pipeline * config_.contexts) + ray];
    }
    bool take(std::uint64_t now, int pipeline, Link c);
    bool begin(std::uint64_t now, int pipeline, std::uint32_t ray);
    void take_tile(std::uint64_t now, int pipeline);
    template <class P> void compare(std::uint64_t now, int pipeline, Link c, const P& wanted, Context& ray);
    void refuse(std::uint64_t now, int pipeline, Link c);
    void mark_wrong(Context& ray);
    void see_ends(int pipeline);
    const char* driver(Link c, const Context& context) const;
    std::vector<ExpectedTransfer> transfers(int pipeline, std::uint32_t ray, const Context& context) const;
    std::string explain(int pipeline, Link c, std::uint32_t ray, const Context& context) const;
    bool equals_rtl(int pipeline, const ExpectedTransfer& wanted) const;
    Divergence at(std::uint64_t now, int pipeline, Link c, std::uint32_t ray) const;

    const Config& config_;
    const RtlMachine& rtl_;
    std::array<bool, unit_count> free_;
    Findings& findings_;
    const MemoryImage* image_ = nullptr;
    std::optional<Script> script_;
    Frame frame_{};
    std::unique_ptr<PayloadReplay> payloads_;
    std::vector<Context> contexts_;                             // [pipeline * contexts + ray]
    std::vector<bool> begun_;                                   // [place] of the script
    std::set<std::pair<std::uint32_t, std::uint32_t>> tiles_;   // that no pipeline has got yet
    LinkMask ray_links_ = 0;
    std::size_t finished_ = 0, wrong_ = 0;
    std::uint64_t moved_at_ = 0;
    Words words_;
};

}   // namespace rayclock
