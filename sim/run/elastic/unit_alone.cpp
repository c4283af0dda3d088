// Drives the unit's ports, and compares its answers.
#include "sim/run/elastic/unit_alone.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/machine/payload_replay.hpp"
#include "sim/run/elastic/corners.hpp"
#include "sim/run/elastic/dont_care.hpp"
#include "sim/run/elastic/findings.hpp"
#include "sim/run/rtl/rtl_module.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t longest_wait = 20'000;   // cycles without an answer
/// Cycles after the last answer in which no further one may come.
constexpr std::uint64_t after_the_end = 10'000;

/// A unit with one link for requests and one for answers, and its port for answers.
struct Shape {
    Link req, rsp;
    const char* answers;
};

/// Returns the links of a unit that answers each request with one transfer; nothing for all other units.
std::optional<Shape> shape_of(Unit unit) {
    if (unit == Unit::tri) return Shape{Link::tri_req, Link::tri_rsp, "rsp"};
    if (unit == Unit::xform) return Shape{Link::xform_req, Link::change, "change"};
    for (const NodeUnit& u : node_units)
        if (unit == u.unit) return Shape{u.req, u.rsp, "rsp"};
    return {};
}

Shape required_shape(const std::string& name, const Config& config) {
    const std::optional<Unit> unit = unit_called(name);
    if (!unit) throw UserError(fmt::format("--unit-only: no unit is called {}", shown(name)));
    if (!is_there(*unit, config))
        throw UserError(
            fmt::format("--unit-only {}: the chip '{}' has no such unit", name, printable(config.name)));
    if (const std::optional<Shape> shape = shape_of(*unit)) return *shape;
    throw UserError(
        fmt::format("--unit-only {}: this unit does not answer each request with one transfer, so it "
                    "cannot run alone; use --elastic",
                    name));
}

std::uint32_t ray_in(Link c, const std::uint32_t* words, const Config& config) {
    return with_payload(c, [&]<class P>() { return id_of(unpack<P>(words, config)); });
}
void set_ray(Link c, Words& words, std::uint32_t ray, const Config& config) {
    with_payload(c, [&]<class P>() {
        if constexpr (requires(P p) { p.ray; }) {
            P payload = unpack<P>(words.data(), config);
            payload.ray = ray;
            pack(payload, config, words);
        }
    });
}

struct Pair {
    Words request, answer;
};

/// Returns the requests of a frame on a link, each with its answer.
std::vector<Pair> record(const Job& job, const RecordedFrame& frame, const Shape& shape, std::uint64_t most) {
    Machine machine(job.config, job.khz);
    machine.start(frame.frame, frame.trace);
    PayloadReplay payloads(job.image, job.config);
    payloads.start(frame.frame);
    std::vector<Pair> pairs;
    std::vector<Words> asked(std::size_t(job.config.pipelines * job.config.contexts));
    while (!machine.done() && pairs.size() < most && !interrupted())
        machine.step([&](const Move& move) {
            payloads(move, [&](int pipeline, Link c, const auto& payload) {
                if (c != shape.req && c != shape.rsp) return;
                Words& request = asked[std::size_t(pipeline * job.config.contexts) + move.id];
                if (c == shape.req)
                    request = pack(payload, job.config);
                else
                    pairs.push_back({request, pack(payload, job.config)});
            });
        });
    return pairs;
}

/// Adds as many requests at corners as there are recorded ones.
void add_corners(std::vector<Pair>& pairs, Unit unit, const Config& config, int seed) {
    std::mt19937_64 random{std::uint64_t(seed)};
    const std::size_t recorded = pairs.size();
    for (std::size_t i = 0; i < recorded; ++i) {
        pairs.push_back(pairs[i]);
        to_corner(unit, pairs.back().request, pairs.back().answer, config, random);
    }
}

class Alone {
public:
    Alone(const Job& job, const std::string& unit, const Shape& shape, int seed)
        : config_(job.config),
          unit_(unit),
          shape_(shape),
          module_(job.config, "rc_" + unit, seed),
          req_(module_.port("req")),
          rsp_(module_.port(shape.answers)),
          waits_(std::size_t(1) << job.config.ray_bits()),
          random_(std::uint64_t(seed)) {
        *req_.valid = 0;
        if (rsp_.ready) *rsp_.ready = 0;
        module_.reset();
    }

    UnitAlone run(std::vector<Pair> pairs) {
        const Stopwatch watch;
        try {
            drive(pairs);
            drain();
        } catch (const RtlAssertion& assertion) {
            findings_.add([&] {
                return difference(result_.cycles, "rtl", "none", "no assertion fails", assertion.what());
            });
        }
        result_.interrupted = interrupted();
        result_.value_mismatches = findings_.value_mismatches;
        result_.first = findings_.first;
        result_.seconds = watch.seconds();
        return result_;
    }

private:
    /// Offers all requests, and takes the answers.
    void drive(std::vector<Pair>& pairs) {
        std::uint64_t quiet = 0;
        for (std::size_t next = 0; (next < pairs.size() || in_flight_ > 0) && !interrupted();
             ++result_.cycles) {
            if (!offer_ && next < pairs.size() && random_() % 4 > 0) offer(pairs[next]);
            *req_.valid = offer_ != nullptr;
            if (rsp_.ready) *rsp_.ready = random_() % 4 > 0;
            module_.settle();
            if (offer_ && *req_.ready) {
                waits_[ray_] = offer_;
                offer_ = nullptr;
                ++in_flight_, ++next, ++result_.requests;
            }
            check_offer();
            const bool answers = *rsp_.valid && (!rsp_.ready || *rsp_.ready);
            if (answers) check();
            quiet = answers ? 0 : quiet + 1;
            if (quiet > longest_wait) return report_missing();
            module_.clock();
        }
    }
    /// Accepts and checks transfers after the last answer.
    void drain() {
        for (std::uint64_t i = 0; i < after_the_end && !findings_.first && !interrupted(); ++i) {
            *req_.valid = 0;
            if (rsp_.ready) *rsp_.ready = 1;
            module_.settle();
            if (*rsp_.valid) check();
            module_.clock();
        }
    }

    /// Offers a request under the number of a ray that is not in flight, if there is one.
    void offer(Pair& pair) {
        const std::uint32_t contexts = std::uint32_t(config_.contexts);
        std::uint32_t ray = std::uint32_t(random_() % contexts);
        for (std::uint32_t tries = 0; waits_[ray]; ray = (ray + 1) % contexts)
            if (++tries == contexts) return;
        ray_ = ray;
        set_ray(shape_.req, pair.request, ray, config_);
        set_ray(shape_.rsp, pair.answer, ray, config_);
        copy_words(req_, pair.request);
        offer_ = &pair;
    }

    /// Checks that an answer stays unchanged until it is accepted.
    void check_offer() {
        const auto* const bytes = reinterpret_cast<const unsigned char*>(rsp_.data);
        if (held_ && !*rsp_.valid)
            findings_.add([&] {
                return at(held_ray_, "valid stays 1 until the answer is accepted",
                          "valid is 0, and the answer was not accepted");
            });
        else if (held_ && !std::equal(held_payload_.begin(), held_payload_.end(), bytes))
            findings_.add([&] {
                return at(held_ray_, "the payload stays unchanged until it is accepted",
                          "another payload: " + text(rsp_.data));
            });
        held_ = *rsp_.valid && rsp_.ready && !*rsp_.ready;
        if (!held_) return;
        held_ray_ = ray_in(shape_.rsp, rsp_.data, config_);
        held_payload_.assign(bytes, bytes + rsp_.bytes);
    }

    void check() {
        ++result_.answers;
        const std::uint32_t ray = ray_in(shape_.rsp, rsp_.data, config_);
        Pair* const pair = waits_[ray];
        if (!pair) {
            findings_.add(
                [&] { return at(ray, "no answer: the ray has no request in flight", text(rsp_.data)); });
            return;
        }
        waits_[ray] = nullptr;
        --in_flight_;
        with_payload(shape_.rsp, [&]<class P>() {
            const P wanted = unpack<P>(pair->answer.data(), config_);
            P got = unpack<P>(rsp_.data, config_), full = got;
            drop_dont_care(shape_.rsp, wanted, got);
            if (pack(got, config_) == pair->answer) return;
            findings_.add([&] {
                Divergence d = at(ray, {}, {});
                describe(wanted, full, config_, d);
                return d;
            });
        });
    }

    void report_missing() {
        for (std::uint32_t ray = 0; ray < waits_.size(); ++ray)
            if (waits_[ray]) {
                findings_.add([&] {
                    return at(ray, "an answer: " + text(waits_[ray]->answer.data()),
                              fmt::format("none in {} cycles", longest_wait));
                });
                return;
            }
        findings_.add([&] { return at(ray_, "the request is accepted", "ready is never 1"); });
    }

    std::string text(const std::uint32_t* words) const {
        return with_payload(shape_.rsp,
                            [&]<class P>() { return fields_text(unpack<P>(words, config_), config_); });
    }
    Divergence at(std::uint32_t ray, std::string expected, std::string got) const {
        Divergence d = difference(result_.cycles, unit_, 0, shape_.rsp);
        d.ray = ray;
        d.expected = std::move(expected), d.got = std::move(got);
        return d;
    }

    const Config& config_;
    std::string unit_;
    Shape shape_;
    RtlModule module_;
    const RcPort &req_, &rsp_;
    std::vector<Pair*> waits_;   // [ray]
    Pair* offer_ = nullptr;
    std::uint32_t ray_ = 0;   // of the offer
    std::size_t in_flight_ = 0;
    bool held_ = false;   // an answer was offered and not accepted in the last cycle
    std::uint32_t held_ray_ = 0;
    std::vector<unsigned char> held_payload_;
    std::mt19937_64 random_;
    Findings findings_;
    UnitAlone result_;
};

}   // namespace

bool runs_alone(const std::string& unit) {
    const std::optional<Unit> found = unit_called(unit);
    return found && shape_of(*found);
}

UnitAlone run_unit_alone(const Job& job, const RecordedFrame& frame, const std::string& unit, int seed,
                         std::uint64_t most) {
    const Shape shape = required_shape(unit, job.config);
    std::vector<Pair> pairs = record(job, frame, shape, most);
    if (pairs.empty() && !interrupted())
        throw UserError(fmt::format("--unit-only {}: the frame has no request for this unit", unit));
    const Unit made = unit_called(unit).value();
    if (has_corners(made, job.config)) add_corners(pairs, made, job.config, seed);
    return Alone(job, unit, shape, seed).run(std::move(pairs));
}

}   // namespace rayclock
