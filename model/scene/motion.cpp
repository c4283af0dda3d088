// Evaluates tracks, nodes and poses at a time.
#include "model/scene/motion.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/base/error.hpp"
#include "model/scene/placed.hpp"
#include "model/scene/view.hpp"

namespace rayclock {
namespace {

template <class Value> Value mixed(const Value& a, const Value& b, double s) { return a * (1 - s) + b * s; }
glm::dquat mixed(const glm::dquat& a, const glm::dquat& b, double s) { return glm::slerp(a, b, s); }

template <class Value> Value tidy(const Value& value) { return value; }
glm::dquat tidy(const glm::dquat& turn) { return glm::normalize(turn); }

/// Returns a cubic Hermite spline between two keys `span` seconds apart, as in glTF 2.0 (appendix C).
template <class Value> Value spline(const Value* from, const Value* to, double s, double span) {
    const double s2 = s * s, s3 = s2 * s;
    const Value &value = from[1], &leaves = from[2], &arrives = to[0], &end = to[1];
    return tidy(value * (2 * s3 - 3 * s2 + 1) + leaves * (span * (s3 - 2 * s2 + s)) +
                end * (3 * s2 - 2 * s3) + arrives * (span * (s3 - s2)));
}

glm::dmat4 local_place(const MotionNode& node, double time) {
    if (!node.is_parts) return node.matrices.at(time, node.matrix);
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), node.translates.at(time, node.translate));
    const glm::dmat4 turned = moved * glm::mat4_cast(node.rotations.at(time, node.rotation));
    return glm::scale(turned, node.scales.at(time, node.scale));
}

glm::dvec3 point_at(const glm::dmat4& place, const glm::dvec3& point) {
    return glm::dvec3(place * glm::dvec4(point, 1));
}

double last_time(const MotionNode& node) {
    double last = 0;
    for (const auto* times :
         {&node.matrices.times, &node.translates.times, &node.scales.times, &node.rotations.times})
        if (!times->empty()) last = std::max(last, times->back());
    return last;
}

bool is_bounded(const glm::dmat4& m) {
    for (int i = 0; i < 3; ++i)
        if (!(glm::length(glm::dvec3(m[i])) < 1e100) || !std::isfinite(m[3][i])) return false;
    return true;
}

}   // namespace

template <class Value> Value Track<Value>::at(double time, const Value& otherwise) const {
    if (times.empty()) return otherwise;
    const std::size_t width = interpolation == Interpolation::cubic ? 3 : 1, own = width / 2;
    const auto after = std::upper_bound(times.begin(), times.end(), time);   // first key beyond
    if (after == times.begin()) return tidy(values[own]);
    const std::size_t k = std::size_t(after - times.begin()) - 1;
    if (after == times.end() || interpolation == Interpolation::step) return tidy(values[width * k + own]);
    const double span = times[k + 1] - times[k], s = (time - times[k]) / span;
    if (interpolation == Interpolation::linear) return mixed(values[k], values[k + 1], s);
    return spline(&values[3 * k], &values[3 * k + 3], s, span);
}
template struct Track<double>;
template struct Track<glm::dvec3>;
template struct Track<glm::dquat>;
template struct Track<glm::dmat4>;

double Motion::length() const {
    double last = 0;
    for (const MotionNode& node : nodes) last = std::max(last, last_time(node));
    const auto see = [&](const auto& track) {
        if (!track.empty()) last = std::max(last, track.times.back());
    };
    see(camera.eye), see(camera.at), see(camera.up), see(camera.fov);
    for (const Deforming& mesh : deforming)
        for (const MorphTarget& target : mesh.targets) see(target.weights);
    for (const LightMotion& light : lights) see(light.position), see(light.colour);
    return last;
}

std::vector<glm::dmat4> node_places(const Motion& motion, double time) {
    std::vector<glm::dmat4> places;
    places.reserve(motion.nodes.size());
    for (const MotionNode& node : motion.nodes) {
        const glm::dmat4 local = local_place(node, time);
        places.push_back(node.parent ? places[*node.parent] * local : local);
    }
    return places;
}

void pose(PlacedScene& scene, double time) {
    const Motion& motion = scene.motion;
    if (motion.empty()) return;
    const std::vector<glm::dmat4> places = node_places(motion, time);
    for (const AttachedInstance& attached : motion.attached) {
        Instance& instance = scene.instances[attached.instance];
        instance.place = places[attached.node] * attached.place;
        if (!is_bounded(instance.place))
            throw UserError(motion.nodes[attached.node].name + " at " + text_of(time) +
                            " s moves or scales its mesh out of range");
    }
    for (const Deforming& deforming : motion.deforming)
        deform(deforming, time, places, scene.meshes[deforming.mesh]);
    const CameraMotion& moves = motion.camera;
    if (!moves.empty()) {
        Camera camera = moves.node ? moves.seen : scene.own.camera.value_or(Camera{});
        camera.eye = moves.eye.at(time, camera.eye);
        camera.at = moves.at.at(time, camera.at);
        camera.up = moves.up.at(time, camera.up);
        camera.fov_degrees = moves.fov.at(time, camera.fov_degrees);
        if (moves.node) {
            const glm::dmat4& place = places[*moves.node];
            camera.up = glm::dmat3(place) * camera.up;
            camera.eye = point_at(place, camera.eye);
            camera.at = point_at(place, camera.at);
        }
        view_of(camera, "the camera at " + text_of(time) + " s");   // refuses a camera without a view
        scene.own.camera = camera;
    }
    for (const LightMotion& moving : motion.lights) {
        Light& light = scene.own.lights[moving.light];
        light.position = moving.node ? point_at(places[*moving.node], moving.point)
                                     : moving.position.at(time, light.position);
        light.colour = moving.colour.at(time, light.colour);
    }
}

// The three directions, scaled to unit length, span a volume of 1 for a rotation and 0 for a flat map.
// Extreme lengths are refused too, because their products would leave the range of a double.
bool is_singular(const glm::dmat4& m) {
    glm::dmat3 directions(m);
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(directions[i]);
        if (!(length > 1e-100 && length < 1e100) || !std::isfinite(m[3][i])) return true;
        directions[i] /= length;
    }
    return !(std::abs(glm::determinant(directions)) > 1e-9);
}

}   // namespace rayclock
