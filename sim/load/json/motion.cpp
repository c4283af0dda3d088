// Reading keyframes and copying the motion of parts.
#include "sim/load/json/motion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "sim/load/json/parts.hpp"

namespace rayclock {
namespace {

/// Throws UserError unless all keys set the same properties, and only the listed ones.
void check_alike(const JsonValue& keyframes, std::initializer_list<std::string_view> keys) {
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        keyframes[i].only_keys(keys);
        for (const std::string_view key : keys)
            if (keyframes[i].find(key).has_value() != keyframes[0].find(key).has_value())
                keyframes[i].refuse(fmt::format("and the first key must both have '{}', or neither", key));
    }
}

template <class Value, class Read> Track<Value> track_of(const JsonValue& keyframes,
                                                         const std::vector<double>& times,
                                                         std::string_view key, const Read& read) {
    Track<Value> track;
    if (!keyframes[0].find(key)) return track;
    track.times = times;
    for (std::size_t i = 0; i < keyframes.size(); ++i) track.values.push_back(read(keyframes[i].at(key)));
    return track;
}

glm::dvec3 triple(const JsonValue& in) { return in.triple(); }

/// Reads rotations. Between two keys about the same axis the angle grows linearly, whatever its size. So
/// extra keys at most a quarter turn apart make slerp turn in the intended direction. A few bytes can request
/// thousands of extra keys, so they are counted before they are made.
Track<glm::dquat> turns_of(const JsonValue& keyframes, const std::vector<double>& times, Loading& loading) {
    Track<glm::dquat> track;
    if (!keyframes[0].find("rotate")) return track;
    std::vector<Turn> turns;
    std::vector<int> parts;   // number of steps from the previous key
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        const JsonValue in = keyframes[i].at("rotate");
        turns.push_back(turn_of(in));
        double far = 0;
        if (i > 0 && turns[i].axis == turns[i - 1].axis) far = turns[i].degrees - turns[i - 1].degrees;
        if (!(std::abs(far) <= max_degrees))
            in.at("degrees").refuse(
                fmt::format("turns by {} from the key before; the most is {:.0f}", far, max_degrees));
        parts.push_back(std::max(1, int(std::ceil(std::abs(far) / 90))));
        all += std::uint64_t(parts.back());
    }
    if (!loading.may_make(all * (sizeof(double) + sizeof(glm::dquat)))) keyframes.refuse(loading.too_much());
    track.times.reserve(all), track.values.reserve(all);
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        for (int k = 1; k < parts[i]; ++k) {
            const double s = double(k) / parts[i], far = turns[i].degrees - turns[i - 1].degrees;
            track.times.push_back(times[i - 1] + s * (times[i] - times[i - 1]));
            track.values.push_back(quaternion({turns[i].axis, turns[i - 1].degrees + s * far}));
        }
        track.times.push_back(times[i]);
        track.values.push_back(quaternion(turns[i]));
    }
    return track;
}

}   // namespace

std::vector<double> key_times_of(const JsonValue& keyframes) {
    if (keyframes.array().size() < 2)
        keyframes.refuse(fmt::format("has {} key{}; a motion needs two or more, or its length is 0",
                                     keyframes.size(), keyframes.size() == 1 ? "" : "s"));
    std::vector<double> times;
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        const JsonValue time = keyframes[i].object().at("time");
        const double t = time.number();
        if (!(t >= 0 && t <= latest_time))
            time.expected(fmt::format("a time within 0 and {:.0f} s", latest_time));
        if (!times.empty() && !(t > times.back()))
            time.refuse(
                fmt::format("is {}, but keys stand in the order of their times, and the one before is at {}",
                            t, times.back()));
        times.push_back(t);
    }
    return times;
}

std::optional<std::uint32_t> anchor(const NodePlace& where, Motion& motion) {
    if (where.place == glm::dmat4(1)) return where.node;
    motion.nodes.push_back({.name = "", .parent = where.node, .matrix = where.place});
    return static_cast<std::uint32_t>(motion.nodes.size() - 1);
}

NodePlace where_of(const JsonValue& in, const NodePlace& above, Motion& motion, Loading& loading) {
    const auto keys = in.find("keyframes");
    if (!keys) return {above.place * transform_of(in), above.node};
    for (const char* key : {"translate", "rotate", "scale", "matrix"})
        if (in.find(key)) in.refuse(fmt::format("has both 'keyframes' and '{}'", key));
    MotionNode node = node_of(*keys, loading);
    node.parent = anchor(above, motion);
    motion.nodes.push_back(std::move(node));
    return {glm::dmat4(1), static_cast<std::uint32_t>(motion.nodes.size() - 1)};
}

std::uint32_t add_nodes(const Motion& part, const NodePlace& where, Motion& motion) {
    if (part.attached.empty()) return 0;
    const std::optional<std::uint32_t> parent = anchor(where, motion);
    const auto base = static_cast<std::uint32_t>(motion.nodes.size());
    for (MotionNode node : part.nodes) {
        node.parent = node.parent ? std::optional(*node.parent + base) : parent;
        motion.nodes.push_back(std::move(node));
    }
    return base;
}

void add_deforming(const Motion& part, std::uint32_t first_mesh, Motion& motion) {
    const auto base = static_cast<std::uint32_t>(motion.nodes.size());
    const bool has_joints = std::any_of(part.deforming.begin(), part.deforming.end(),
                                        [](const Deforming& d) { return !d.joints.empty(); });
    for (std::size_t i = 0; has_joints && i < part.nodes.size(); ++i) {
        motion.nodes.push_back(part.nodes[i]);
        if (motion.nodes.back().parent) *motion.nodes.back().parent += base;
    }
    for (Deforming deforming : part.deforming) {
        deforming.mesh += first_mesh;
        for (Joint& joint : deforming.joints)
            if (joint.node) *joint.node += base;
        motion.deforming.push_back(std::move(deforming));
    }
}

std::vector<const AttachedInstance*> attached_of(const PlacedScene& part) {
    std::vector<const AttachedInstance*> of(part.instances.size());
    for (const AttachedInstance& attached : part.motion.attached) of[attached.instance] = &attached;
    return of;
}

MotionNode node_of(const JsonValue& keyframes, Loading& loading) {
    MotionNode node;
    node.name = keyframes.where();
    const std::vector<double> times = key_times_of(keyframes);
    check_alike(keyframes, {"time", "translate", "rotate", "scale", "matrix"});
    const auto has = [&](std::string_view key) { return keyframes[0].find(key).has_value(); };
    node.is_parts = !has("matrix");
    for (const char* key : {"translate", "rotate", "scale"})
        if (has("matrix") && has(key)) keyframes[0].refuse(fmt::format("has both 'matrix' and '{}'", key));
    node.matrices = track_of<glm::dmat4>(keyframes, times, "matrix", matrix_of);
    node.translates = track_of<glm::dvec3>(keyframes, times, "translate", triple);
    node.rotations = turns_of(keyframes, times, loading);
    node.scales = track_of<glm::dvec3>(keyframes, times, "scale", scale_of);
    return node;
}

CameraMotion camera_motion_of(const JsonValue& keyframes, Camera& first) {
    CameraMotion motion;
    const std::vector<double> times = key_times_of(keyframes);
    check_alike(keyframes, {"time", "eye", "at", "up", "fov_degrees"});
    std::vector<Camera> cameras;
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        cameras.push_back(camera_of_keys(keyframes[i]));
        motion.eye.values.push_back(cameras.back().eye);
        motion.at.values.push_back(cameras.back().at);
        motion.up.values.push_back(cameras.back().up);
        motion.fov.values.push_back(cameras.back().fov_degrees);
    }
    motion.eye.times = motion.at.times = motion.up.times = motion.fov.times = times;
    first = cameras.front();
    return motion;
}

LightMotion light_motion_of(const JsonValue& keyframes, std::uint32_t number, Light& first) {
    LightMotion motion;
    motion.light = number;
    const std::vector<double> times = key_times_of(keyframes);
    check_alike(keyframes, {"time", "position", "colour"});
    motion.position.times = times;
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        const Light light = light_of_keys(keyframes[i]);
        motion.position.values.push_back(light.position);
        if (keyframes[0].find("colour")) motion.colour.values.push_back(light.colour);
        if (i == 0) first = {light.position, keyframes[0].find("colour") ? light.colour : first.colour};
    }
    if (!motion.colour.values.empty()) motion.colour.times = times;
    return motion;
}

}   // namespace rayclock
