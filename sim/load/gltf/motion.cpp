// Reading animations and instancing of glTF.
#include "sim/load/gltf/motion.hpp"

#include <cmath>

#include <fmt/format.h>

#include "sim/load/gltf/deform.hpp"
#include "sim/load/json/motion.hpp"

namespace rayclock {
namespace {

/// Reads one animation of the document.
class AnimationReader {
public:
    AnimationReader(const JsonValue& document, const JsonValue& animation, GltfBuffers& buffers)
        : document_(document), in_(animation), buffers_(buffers) {}

    std::map<std::uint64_t, GltfTracks> read() {
        const JsonValue channels = in_.at("channels").array();
        for (std::size_t i = 0; i < channels.size(); ++i) channel(channels[i]);
        return std::move(tracks_);
    }

private:
    void channel(const JsonValue& in) {
        const JsonValue target = in.at("target");
        const std::string path = target.at("path").string();
        const auto node = target.find("node");
        if (!node) return;   // target of an extension
        const JsonValue samplers = in_.at("samplers").array();
        const JsonValue sampler = samplers[in.at("sampler").whole(samplers.size())];
        const std::uint64_t nodes = document_.find("nodes") ? document_.at("nodes").array().size() : 0;
        GltfTracks& own = tracks_[node->whole(nodes)];
        if (path == "weights") return weights(target, sampler, node->whole(nodes), own);
        if (path == "translation")
            fill(target, sampler, own.translates, 3,
                 [](const double* v) { return glm::dvec3(v[0], v[1], v[2]); });
        else if (path == "scale")
            fill(target, sampler, own.scales, 3,
                 [](const double* v) { return glm::dvec3(v[0], v[1], v[2]); });
        else if (path == "rotation")
            fill(target, sampler, own.rotations, 4,
                 [](const double* v) { return glm::dquat(v[3], v[0], v[1], v[2]); });
        else
            target.at("path").expected("translation, rotation, scale or weights");
        check_turns(sampler, own.rotations);
    }

    /// Reads one track for each morph target. The values of all targets at a key are adjacent in the file.
    void weights(const JsonValue& target, const JsonValue& sampler, std::uint64_t node, GltfTracks& own) {
        if (!own.weights.empty()) target.refuse("is also moved by an earlier channel");
        const auto mesh = document_.at("nodes")[node].find("mesh");
        const std::size_t targets = mesh ? gltf_target_count(document_.at(
                                               "meshes")[mesh->whole(document_.at("meshes").array().size())])
                                         : 0;
        if (targets == 0)
            target.refuse(fmt::format("moves the weights of nodes[{}], which has no morph targets", node));
        const std::vector<double> times = times_of(sampler);
        const Interpolation interpolation = interpolation_of(sampler);
        const std::uint64_t accessor = number_of(sampler, "output");
        const std::vector<double> numbers = buffers_.read(accessor, 1);
        const std::size_t each = interpolation == Interpolation::cubic ? 3 : 1;
        if (numbers.size() != times.size() * each * targets)
            sampler.refuse(fmt::format("has {} values for {} times and {} morph targets", numbers.size(),
                                       times.size(), targets));
        check_finite(numbers, 1, accessor, "which is not a weight of a morph target");
        own.weights.assign(targets, {times, {}, interpolation});
        for (std::size_t i = 0; i < numbers.size(); ++i)
            own.weights[i % targets].values.push_back(numbers[i]);
    }

    void check_finite(const std::vector<double>& numbers, std::size_t width, std::uint64_t accessor,
                      const char* what) const {
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!std::isfinite(numbers[i]) || std::abs(numbers[i]) > 1e30)
                document_.at("accessors")[accessor].refuse(
                    fmt::format("has {} at element {}, {}", numbers[i], i / width, what));
    }

    template <class Value, class Read> void fill(const JsonValue& target, const JsonValue& sampler,
                                                 Track<Value>& track, std::uint64_t width, const Read& read) {
        if (!track.empty()) target.refuse("is also moved by an earlier channel");
        track.interpolation = interpolation_of(sampler);
        track.times = times_of(sampler);
        const std::uint64_t accessor = number_of(sampler, "output");
        const std::vector<double> numbers = buffers_.read(accessor, width);
        const std::size_t each = track.interpolation == Interpolation::cubic ? 3 : 1;
        if (numbers.size() != track.times.size() * each * width)
            sampler.refuse(
                fmt::format("has {} values for {} times", numbers.size() / width, track.times.size()));
        check_finite(numbers, width, accessor, "which moves a node too far");
        for (std::size_t i = 0; i < numbers.size(); i += width) track.values.push_back(read(&numbers[i]));
    }

    static Interpolation interpolation_of(const JsonValue& sampler) {
        const auto typed = sampler.find("interpolation");
        if (!typed || typed->string() == "LINEAR") return Interpolation::linear;
        if (typed->string() == "STEP") return Interpolation::step;
        if (typed->string() != "CUBICSPLINE") typed->expected("LINEAR, STEP or CUBICSPLINE");
        return Interpolation::cubic;
    }

    std::vector<double> times_of(const JsonValue& sampler) {
        const std::uint64_t accessor = number_of(sampler, "input");
        std::vector<double> times = buffers_.read(accessor, 1);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const bool is_good =
                times[i] >= 0 && times[i] <= latest_time && (i == 0 || times[i] > times[i - 1]);
            if (!is_good)
                document_.at("accessors")[accessor].refuse(
                    fmt::format("has the time {} at element {}; times of keys rise from 0 on, up to {:.0f} s",
                                times[i], i, latest_time));
        }
        return times;
    }

    std::uint64_t number_of(const JsonValue& sampler, const char* key) const {
        return sampler.at(key).whole(document_.at("accessors").array().size());
    }

    /// Throws UserError if a rotation is far from a unit quaternion.
    static void check_turns(const JsonValue& sampler, const Track<glm::dquat>& turns) {
        const std::size_t width = turns.interpolation == Interpolation::cubic ? 3 : 1;
        for (std::size_t k = 0; k < turns.times.size(); ++k) {
            const glm::dquat& q = turns.values[width * k + width / 2];
            if (!(glm::dot(q, q) > 0.25 && glm::dot(q, q) < 4))
                sampler.refuse(
                    fmt::format("has a rotation that is far from a unit quaternion at {} s", turns.times[k]));
        }
    }

    const JsonValue& document_;
    JsonValue in_;
    GltfBuffers& buffers_;
    std::map<std::uint64_t, GltfTracks> tracks_;
};

}   // namespace

std::map<std::uint64_t, GltfTracks> gltf_tracks(const JsonValue& document, GltfBuffers& buffers,
                                                Loading& loading, const std::string& file) {
    const auto list = document.find("animations");
    if (!list || list->array().size() == 0) return {};
    if (list->size() > 1)
        loading.note(file, counted(list->size() - 1, "animation") + " after the first left out");
    AnimationReader reader(document, (*list)[0], buffers);
    return reader.read();
}

std::vector<glm::dmat4> gltf_places(const JsonValue& attributes, GltfBuffers& buffers,
                                    std::uint64_t accessors) {
    std::optional<std::size_t> count;
    const auto read = [&](const char* name, std::size_t width) -> std::vector<double> {
        const auto own = attributes.find(name);
        if (!own) return {};
        std::vector<double> numbers = buffers.read(own->whole(accessors), width);
        if (count && *count != numbers.size() / width)
            own->refuse(fmt::format("has {} places, and the attribute before has {}", numbers.size() / width,
                                    *count));
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!(std::abs(numbers[i]) <= 1e30))
                own->refuse(
                    fmt::format("has {} at place {}, which moves a mesh too far", numbers[i], i / width));
        count = numbers.size() / width;
        return numbers;
    };
    const std::vector<double> moves = read("TRANSLATION", 3), turns = read("ROTATION", 4),
                              scales = read("SCALE", 3);
    if (!count) attributes.refuse("has none of TRANSLATION, ROTATION and SCALE");
    std::vector<glm::dmat4> places(*count, glm::dmat4(1));
    for (std::size_t i = 0; i < *count; ++i) {
        glm::dmat4& place = places[i];
        if (!moves.empty()) place[3] = {moves[3 * i], moves[3 * i + 1], moves[3 * i + 2], 1};
        if (!turns.empty()) {
            const glm::dquat turn(turns[4 * i + 3], turns[4 * i], turns[4 * i + 1], turns[4 * i + 2]);
            if (!(glm::dot(turn, turn) > 0.25))
                attributes.at("ROTATION")
                    .refuse(fmt::format("has a rotation at place {} that is far from a unit quaternion", i));
            place = place * glm::mat4_cast(glm::normalize(turn));
        }
        for (int k = 0; k < 3 && !scales.empty(); ++k) place[k] *= scales[3 * i + std::size_t(k)];
    }
    return places;
}

MotionNode gltf_node(const JsonValue& in, const glm::dmat4& matrix, const GltfTracks* tracks) {
    MotionNode node{.name = in.where(), .matrix = matrix};
    if (!tracks) return node;
    if (in.find("matrix")) in.refuse("has a matrix, but an animation needs translation, rotation and scale");
    node.is_parts = true;
    if (const auto move = in.find("translation")) node.translate = move->triple();
    if (const auto scale = in.find("scale")) node.scale = scale->triple();
    if (const auto turn = in.find("rotation"))
        node.rotation = glm::normalize(
            glm::dquat((*turn)[3].number(), (*turn)[0].number(), (*turn)[1].number(), (*turn)[2].number()));
    node.translates = tracks->translates;
    node.scales = tracks->scales;
    node.rotations = tracks->rotations;
    for (glm::dquat& turn : node.rotations.values)
        if (node.rotations.interpolation != Interpolation::cubic) turn = glm::normalize(turn);
    return node;
}

}   // namespace rayclock
