// Compares the triangle test, the tree walk and child boxes with the exact oracle.
#include "sim/explore/stress/judge.hpp"

#include <algorithm>
#include <cstdlib>

#include "model/compile/compile.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "sim/explore/stress/controls.hpp"
#include "sim/judge/oracle/extra_visits.hpp"
#include "sim/judge/oracle/overlap.hpp"

namespace rayclock::stress {

namespace {

/// Returns 1 if the line along d passes the triangle against its normal, else -1 (the sense of
/// oracle::Passage).
int sense_of(const Vec3i& d, const oracle::Corners& t) {
    using Number = std::int64_t;
    return oracle::volume<oracle::Int128>(oracle::triple<Number>(d), oracle::normal<Number>(t)) < 0 ? 1 : -1;
}

/// Returns true if the direction uses its full width, as a camera's does. Shorter directions reach the
/// largest t before the scene ends. The machine visits everything beyond it, hit or not. That is sound but
/// says nothing about rounding.
bool full_length(const Vec3i& d, const Config& config) {
    const int half = 1 << (config.dir_bits - 2);
    return std::abs(d[0]) >= half || std::abs(d[1]) >= half || std::abs(d[2]) >= half;
}

/// Removes pairs of opposite sense that share a corner from a list.
template <class Hits> void drop_grazing(Hits& hits, const std::vector<oracle::Corners>& triangles) {
    for (std::size_t i = 0; i < hits.size(); ++i)
        for (std::size_t j = i + 1; j < hits.size(); ++j)
            if (hits[i].sense != hits[j].sense &&
                oracle::share_corner(triangles[hits[i].primitive], triangles[hits[j].primitive])) {
                hits.erase(hits.begin() + std::ptrdiff_t(j));
                hits.erase(hits.begin() + std::ptrdiff_t(i--));
                break;
            }
}

std::vector<PrimData> numbered(const std::vector<oracle::Corners>& corners) {
    std::vector<PrimData> triangles;
    for (std::size_t i = 0; i < corners.size(); ++i)
        triangles.push_back({corners[i].a, corners[i].b, corners[i].c, std::uint32_t(i)});
    return triangles;
}

}   // namespace

Counts& Counts::operator+=(const Counts& other) {
    for (const auto field : count_fields) this->*field += other.*field;
    return *this;
}

Judge::Judge(const Case& subject, const Config& config, const NamedTest& test, bool closed)
    : mesh_(subject.mesh),
      config_(config),
      test_(test),
      closed_(closed),
      surface_(mesh_.triangles, test.margin),
      triangles_(numbered(mesh_.triangles)) {
    std::vector<PrimData> kept = triangles_;
    std::erase_if(kept, [&](const PrimData& t) { return !rayclock::counts(t, config); });
    if (test.walks == Walks::no || kept.empty()) return;
    config_.stack_depth = 64;
    image_ = compile_triangles(kept, config_, "the case");
    if (test.walks == Walks::small_boxes) shrink_boxes(image_, config_);
    decoder_ = std::make_unique<Decoder>(image_, config_);
    walk_ = std::make_unique<Walk>(frame_, config_, *decoder_);
}

void Judge::judge(const Shot& shot, Counts& counts) {
    surface_.candidates(shot.o, shot.d, candidates_);
    truth_.clear();
    found_.clear();
    closest_ = {};
    bool agree = true;
    int balance = shot.inside.value_or(0);
    const Best nothing;
    for (const std::uint32_t i : candidates_) {
        const oracle::ExactHit hit = oracle::exact_hit(shot.o, shot.d, mesh_.triangles[i], i);
        test_.test(shot.o, shot.d, triangles_[i], nothing, config_, answer_);
        const bool crossed = hit.primitive == i;
        if (crossed) {
            truth_.push_back({i, hit.sense});
            if (hit.before(closest_)) closest_ = hit;
        }
        if (answer_.closer) {
            const int sense = test_.sense ? test_.sense(shot.o, shot.d, mesh_.triangles[i], config_)
                              : crossed   ? hit.sense
                                          : sense_of(shot.d, mesh_.triangles[i]);
            found_.push_back({i, sense});
            balance += sense;
        }
        agree = agree && crossed == (answer_.closer != 0);
    }
    const bool walked = walk_ && counts.rays % walk_every == 0,
               checks_boxes = walked && counts.rays % (walk_every * box_check_every) == 0 &&
                              full_length(shot.d, config_);
    ++counts.rays;
    counts.crossings += truth_.size();
    counts.walked += walked;
    const std::uint64_t before = counts.leaks + counts.double_hits;
    if (!agree && closed_ && !test_.sense) compare_hits(counts);
    if (closed_ && shot.inside && balance != 0 && counts.leaks + counts.double_hits == before &&
        clear_of_bounds(shot.o))
        ++(found_.size() > truth_.size() && test_.sense ? counts.double_hits : counts.leaks);
    if (walked && !walk_agrees(shot, checks_boxes, counts)) agree = false;
    counts.oracle_mismatches += !agree;
}

/// Returns true if the origin is far enough from the bounds. Tests that do not move corners always pass.
bool Judge::clear_of_bounds(const Vec3i& o) const {
    bool clear = true;
    for (std::size_t k = 0; k < 3; ++k)
        clear = clear && (test_.margin == 0 || (std::abs(o[k] - mesh_.lo[k]) > 2 * test_.margin &&
                                                std::abs(o[k] - mesh_.hi[k]) > 2 * test_.margin));
    return clear;
}

void Judge::compare_hits(Counts& counts) {
    std::vector<Hit> missing;
    const auto take = [&](const auto& fits) {
        const auto at = std::find_if(found_.begin(), found_.end(), fits);
        if (at == found_.end()) return false;
        found_.erase(at);
        return true;
    };
    // Match the same triangle first, so that no hit of a neighbour is taken.
    for (const Hit& t : truth_)
        if (!take([&](const Hit& f) { return f.primitive == t.primitive; })) missing.push_back(t);
    std::erase_if(missing, [&](const Hit& t) {
        return take([&](const Hit& f) {
            return f.sense == t.sense &&
                   oracle::share_corner(mesh_.triangles[f.primitive], mesh_.triangles[t.primitive]);
        });
    });
    drop_grazing(missing, mesh_.triangles);
    drop_grazing(found_, mesh_.triangles);
    counts.leaks += !missing.empty();
    counts.double_hits += !found_.empty();
}

struct Judge::Watch {
    Judge& judge;
    const Shot& shot;
    bool checks_boxes;
    Counts& counts;
    bool within_stack = true;   // no ray may need a deeper stack than compilation promised

    void visit(const auto& walk) {
        within_stack = within_stack && walk.stack_height() <= judge.image_.report.stack_need;
        if (checks_boxes) check_boxes(shot, walk.node(), walk.hits(), counts);
    }
    static void test(std::uint32_t) {}
    static void decided(std::uint32_t, bool) {}
};

bool Judge::walk_agrees(const Shot& shot, bool checks_boxes, Counts& counts) {
    Watch watch{*this, shot, checks_boxes, counts};
    walk_->start_at(make_ray(shot.o, shot.d, config_));
    walk_->run(watch);
    const Closest closest = walk_->closest();
    return watch.within_stack && (closest.found ? closest.prim : no_primitive) == closest_.primitive;
}

/// Compares the decision for each child (bit i of `told`: child i) with exact arithmetic on the same box.
void Judge::check_boxes(const Shot& shot, const WideNode& node, std::uint32_t told, Counts& counts) {
    for (std::size_t i = 0; i < node.children; ++i) {
        const auto [lo, hi] = quantised_box(node, i);
        const bool met = oracle::overlap(oracle::wide(shot.o), oracle::wide(shot.d), lo, hi).has_value();
        const bool taken = told >> i & 1;
        counts.boxes += taken;
        counts.boxes_extra += taken && !met;
        counts.boxes_lost += met && !taken;
    }
}

}   // namespace rayclock::stress
