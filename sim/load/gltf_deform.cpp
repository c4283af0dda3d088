#include "sim/load/gltf_deform.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace rayclock {
namespace {

// Weights of a vertex are rounded in files: to bytes at worst.
constexpr double most_off = 0.02;

/// The weights that a node or its mesh gives to the targets.
std::optional<JsonValue> weights_of(const JsonValue& node, const JsonValue& mesh) {
    if (const auto own = node.find("weights")) return own;
    return mesh.find("weights");
}

bool is_triangles(const JsonValue& primitive) { return primitive.whole_or("mode", 7, 4) >= 4; }

}   // namespace

std::size_t gltf_target_count(const JsonValue& mesh) {
    const JsonValue list = mesh.at("primitives").array();
    std::optional<std::size_t> count;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto targets = list[i].find("targets");
        const std::size_t own = targets ? targets->array().size() : 0;
        if (count && *count != own)
            list[i].refuse(fmt::format("has {} morph targets, and the primitive before has {}", own, *count));
        count = own;
    }
    return count.value_or(0);
}

bool GltfDeformer::deforms(const JsonValue& node, const JsonValue& mesh, const GltfTracks* tracks) {
    if (node.find("skin")) return true;
    if (gltf_target_count(mesh) == 0) return false;
    if (tracks && !tracks->weights.empty()) return true;
    const auto weights = weights_of(node, mesh);
    for (std::size_t i = 0; weights && i < weights->array().size(); ++i)
        if ((*weights)[i].number() != 0) return true;
    return false;
}

Deforming GltfDeformer::make(const JsonValue& node, const JsonValue& mesh, const GltfTracks* tracks,
                             bool smooth) {
    Deforming made;
    made.name = node.where();
    made.targets.resize(gltf_target_count(mesh));
    if (const auto weights = weights_of(node, mesh)) {
        if (weights->array().size() != made.targets.size())
            weights->refuse(
                fmt::format("has {} weights for {} morph targets", weights->size(), made.targets.size()));
        for (std::size_t i = 0; i < made.targets.size(); ++i) made.targets[i].weight = (*weights)[i].number();
    }
    if (tracks && !tracks->weights.empty())
        for (std::size_t i = 0; i < made.targets.size(); ++i) made.targets[i].weights = tracks->weights[i];
    const auto skin = node.find("skin");
    if (skin) {
        const JsonValue skins = document_.at("skins").array();
        add_joints(skins[skin->whole(skins.size())], made);
        made.first_pull.push_back(0);
    }
    const JsonValue list = mesh.at("primitives").array();
    for (std::size_t i = 0; i < list.size(); ++i)
        if (is_triangles(list[i])) add_primitive(list[i], skin.has_value(), smooth, made);
    return made;
}

/// Finite numbers that a float can hold.
std::vector<glm::dvec3> GltfDeformer::triples(const JsonValue& attribute, std::size_t count) {
    const std::uint64_t index = accessor_of(attribute);
    const std::vector<double> numbers = buffers_.read(index, 3);
    if (numbers.size() != 3 * count)
        attribute.refuse(fmt::format("has {} elements for {} vertices", numbers.size() / 3, count));
    std::vector<glm::dvec3> out;
    out.reserve(count);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!(std::abs(numbers[i]) <= std::numeric_limits<float>::max()))
            accessor(index).refuse(
                fmt::format("has {} at element {}, which is not a finite number", numbers[i], i / 3));
    for (std::size_t i = 0; i < count; ++i)
        out.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    return out;
}

void GltfDeformer::add_primitive(const JsonValue& in, bool is_skinned, bool smooth, Deforming& to) {
    const auto append = [](std::vector<glm::dvec3>& all, const std::vector<glm::dvec3>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    const JsonValue attributes = in.at("attributes");
    const std::size_t count =
        accessor(accessor_of(attributes.at("POSITION"))).at("count").whole(std::uint64_t{1} << 32);
    if (!loading_.may_make((2 * sizeof(glm::dvec3)) * count * (to.targets.size() + 2)))
        in.refuse(loading_.too_much());
    append(to.rest, triples(attributes.at("POSITION"), count));
    const std::vector<glm::dvec3> none(count, glm::dvec3(0));
    const auto normals = attributes.find("NORMAL");
    if (smooth) append(to.normals, normals ? triples(*normals, count) : none);
    for (std::size_t i = 0; i < to.targets.size(); ++i) {
        const JsonValue target = in.at("targets")[i].object();
        const auto moves = target.find("POSITION"), turns = target.find("NORMAL");
        append(to.targets[i].moves, moves ? triples(*moves, count) : none);
        if (smooth) append(to.targets[i].turns, turns ? triples(*turns, count) : none);
    }
    if (is_skinned) add_pulls(attributes, count, to);
}

/// From JOINTS_0 and WEIGHTS_0 on, four of a vertex in each.
void GltfDeformer::add_pulls(const JsonValue& attributes, std::size_t vertices, Deforming& to) {
    std::vector<std::vector<double>> joints, weights;
    for (std::size_t set = 0;; ++set) {
        const auto joint = attributes.find(fmt::format("JOINTS_{}", set)),
                   weight = attributes.find(fmt::format("WEIGHTS_{}", set));
        if (!joint && !weight && set > 0) break;
        if (!joint || !weight)
            attributes.refuse(
                fmt::format("has no {}_{}, and {} has a skin", joint ? "WEIGHTS" : "JOINTS", set, to.name));
        const std::uint64_t from = accessor_of(*joint);
        const JsonValue type = accessor(from).at("componentType");
        if (type.raw() != 5121 && type.raw() != 5123) type.expected("5121 or 5123 for joints");
        joints.push_back(buffers_.read(from, 4));
        weights.push_back(buffers_.read(accessor_of(*weight), 4));
        for (const auto* list : {&joints.back(), &weights.back()})
            if (list->size() != 4 * vertices)
                (list == &joints.back() ? joint : weight)
                    ->refuse(fmt::format("has {} elements for {} vertices", list->size() / 4, vertices));
    }
    if (!loading_.may_make(4 * joints.size() * vertices * sizeof(Pull)))
        attributes.refuse(loading_.too_much());
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::size_t first = to.pulls.size();
        double sum = 0;
        for (std::size_t k = 0; k < 4 * joints.size(); ++k) {
            const double joint = joints[k / 4][4 * v + k % 4], weight = weights[k / 4][4 * v + k % 4];
            if (!(joint < double(to.joints.size())))
                attributes.at(fmt::format("JOINTS_{}", k / 4))
                    .refuse(fmt::format("names joint {} at vertex {}, which is out of range: the skin has {}",
                                        joint, v, to.joints.size()));
            if (!(weight >= 0 && weight <= 2))
                attributes.at(fmt::format("WEIGHTS_{}", k / 4))
                    .refuse(
                        fmt::format("has the weight {} at vertex {}; weights lie within 0 and 1", weight, v));
            sum += weight;
            if (weight > 0) to.pulls.push_back({std::uint32_t(joint), weight});
        }
        if (!(std::abs(sum - 1) <= most_off))
            attributes.at("WEIGHTS_0")
                .refuse(fmt::format("sums to {} at vertex {}; the weights of a vertex sum to 1", sum, v));
        for (std::size_t i = first; i < to.pulls.size(); ++i) to.pulls[i].weight /= sum;
        to.first_pull.push_back(std::uint32_t(to.pulls.size()));
    }
}

void GltfDeformer::add_joints(const JsonValue& skin, Deforming& to) {
    const JsonValue list = skin.at("joints").array();
    if (list.size() == 0) list.refuse("is empty: a skin has a joint or more");
    if (!loading_.may_make(list.size() * sizeof(Joint))) list.refuse(loading_.too_much());
    std::vector<double> bind;
    if (const auto matrices = skin.find("inverseBindMatrices")) {
        bind = buffers_.read(accessor_of(*matrices), 16);
        if (bind.size() < 16 * list.size())
            matrices->refuse(fmt::format("has {} matrices for {} joints", bind.size() / 16, list.size()));
        for (std::size_t i = 0; i < bind.size(); ++i)
            if (!(std::abs(bind[i]) <= 1e30))
                accessor(accessor_of(*matrices))
                    .refuse(fmt::format("has {} in matrix {}, which moves a mesh too far", bind[i], i / 16));
    }
    const std::uint64_t nodes = document_.at("nodes").array().size();
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::uint64_t node = list[i].whole(nodes);
        const std::optional<Where> where = where_of_(node);
        if (!where) list[i].refuse(fmt::format("names nodes[{}], which does not stand in the scene", node));
        Joint joint{where->node, where->place, glm::dmat4(1)};
        for (int k = 0; k < 16 && !bind.empty(); ++k)   // columns first, as here
            joint.inverse_bind[k / 4][k % 4] = bind[16 * i + std::size_t(k)];
        to.joints.push_back(joint);
    }
}

}   // namespace rayclock
