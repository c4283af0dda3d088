#include "sim/stress/judge.hpp"

#include <algorithm>

#include "model/raygen/raygen.hpp"
#include "sim/stress/controls.hpp"

namespace rayclock::stress {

namespace {

bool share_corner(const oracle::Corners& s, const oracle::Corners& t) {
    for (const Vec3i& p : {s.a, s.b, s.c})
        if (p == t.a || p == t.b || p == t.c) return true;
    return false;
}

/// 1 if the line along d passes the triangle against its normal, as oracle::Passage has it.
int sense_of(const Vec3i& d, const oracle::Corners& t) {
    using Number = std::int64_t;
    const auto a = oracle::triple<Number>(t.a);
    const auto normal = oracle::area(oracle::way(a, oracle::triple<Number>(t.b)), oracle::way(a, oracle::triple<Number>(t.c)));
    return oracle::volume<oracle::Int128>(oracle::triple<Number>(d), normal) < 0 ? 1 : -1;
}

/// Takes pairs of opposite sense that share a corner out of a list.
template <class Hits> void drop_grazing(Hits& hits, const std::vector<oracle::Corners>& triangles) {
    for (std::size_t i = 0; i < hits.size(); ++i)
        for (std::size_t j = i + 1; j < hits.size(); ++j)
            if (hits[i].sense != hits[j].sense && share_corner(triangles[hits[i].primitive], triangles[hits[j].primitive])) {
                hits.erase(hits.begin() + std::ptrdiff_t(j));
                hits.erase(hits.begin() + std::ptrdiff_t(i--));
                break;
            }
}

std::vector<PrimData> numbered(const std::vector<oracle::Corners>& corners) {
    std::vector<PrimData> triangles;
    for (std::size_t i = 0; i < corners.size(); ++i) triangles.push_back({corners[i].a, corners[i].b, corners[i].c, std::uint32_t(i)});
    return triangles;
}

} // namespace

Counts& Counts::operator+=(const Counts& other) {
    rays += other.rays;
    leaks += other.leaks;
    double_hits += other.double_hits;
    oracle_mismatches += other.oracle_mismatches;
    crossings += other.crossings;
    walked += other.walked;
    return *this;
}

Judge::Judge(const Case& subject, const Config& config, Test test, bool closed, Walks walks)
    : mesh_(subject.mesh), config_(config), test_(test), closed_(closed), surface_(mesh_.triangles), triangles_(numbered(mesh_.triangles)) {
    std::vector<PrimData> kept = triangles_;
    std::erase_if(kept, [&](const PrimData& t) { return !rayclock::counts(t, config); });
    if (walks == Walks::no || kept.empty()) return;
    config_.stack_depth = 64;
    image_ = compile_triangles(kept, config_, "the case");
    if (walks == Walks::small_boxes) shrink_boxes(image_, config_);
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
        test_(shot.o, shot.d, triangles_[i], nothing, config_, answer_);
        const bool crossed = hit.primitive == i;
        if (crossed) {
            truth_.push_back({i, hit.sense});
            if (hit.before(closest_)) closest_ = hit;
        }
        if (answer_.closer) {
            const int sense = crossed ? hit.sense : sense_of(shot.d, mesh_.triangles[i]);
            found_.push_back({i, sense});
            balance += sense;
        }
        agree = agree && crossed == (answer_.closer != 0);
    }
    const bool walked = walk_ && counts.rays % walk_every == 0;
    ++counts.rays;
    counts.crossings += truth_.size();
    counts.walked += walked;
    const std::uint64_t before = counts.leaks + counts.double_hits;
    if (!agree) compare_hits(shot, counts);
    if (closed_ && shot.inside && balance != 0 && counts.leaks + counts.double_hits == before) ++counts.leaks;
    if (walked && !walk_agrees(shot)) agree = false;
    counts.oracle_mismatches += !agree;
}

void Judge::compare_hits(const Shot&, Counts& counts) {
    if (!closed_) return;
    std::vector<Hit> missing;
    const auto take = [&](const auto& fits) {
        const auto at = std::find_if(found_.begin(), found_.end(), fits);
        if (at == found_.end()) return false;
        found_.erase(at);
        return true;
    };
    // The same triangle first, so that a neighbour's hit is not taken away from the neighbour.
    for (const Hit& t : truth_)
        if (!take([&](const Hit& f) { return f.primitive == t.primitive; })) missing.push_back(t);
    std::erase_if(missing, [&](const Hit& t) {
        return take([&](const Hit& f) { return f.sense == t.sense && share_corner(mesh_.triangles[f.primitive], mesh_.triangles[t.primitive]); });
    });
    drop_grazing(missing, mesh_.triangles);
    drop_grazing(found_, mesh_.triangles);
    counts.leaks += !missing.empty();
    counts.double_hits += !found_.empty();
}

bool Judge::walk_agrees(const Shot& shot) {
    walk_->start_at(make_ray(shot.o, shot.d, config_));
    for (bool done = false; !done; walk_->decide(done))
        if (walk_->test_node())
            do walk_->test_triangle(); while (walk_->advance());
    const Closest closest = walk_->closest();
    return (closest.found ? closest.prim : no_primitive) == closest_.primitive;
}

} // namespace rayclock::stress
