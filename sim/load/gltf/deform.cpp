// Reading morph targets, joints and weights of glTF meshes.
#include "sim/load/gltf/deform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

namespace rayclock {
namespace {

// Files round the weights of a vertex, at worst to bytes. Sums within this distance of 1 get no warning.
constexpr double max_off = 0.02;

/// Returns the weights of the morph targets from the node, or from its mesh.
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

/// Reads the indices at the first query, which happens only when the file holds a bad number.
GltfDeformer::Used GltfDeformer::used_by(const JsonValue& primitive) {
    const auto indices = primitive.find("indices");
    if (!indices) return [](std::size_t) { return true; };
    auto all = std::make_shared<std::vector<double>>();
    return [this, all, from = accessor_of(*indices)](std::size_t vertex) {
        if (all->empty()) {
            *all = buffers_.read(from, 1);
            std::sort(all->begin(), all->end());
        }
        return std::binary_search(all->begin(), all->end(), double(vertex));
    };
}

/// Reads triples of numbers that a float can hold. Throws UserError for any other number if a triangle uses
/// the vertex. A bad normal counts as missing.
std::vector<glm::dvec3> GltfDeformer::triples(const JsonValue& attribute, std::size_t count, bool are_normals,
                                              const Used& used) {
    const std::uint64_t index = accessor_of(attribute);
    std::vector<double> numbers = buffers_.read(index, 3);
    if (numbers.size() != 3 * count)
        attribute.refuse(fmt::format("has {} elements for {} vertices", numbers.size() / 3, count));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (std::abs(numbers[i]) <= std::numeric_limits<float>::max()) continue;
        if (!are_normals && used(i / 3))
            accessor(index).refuse(
                fmt::format("has {} at element {}, which is not a finite number", numbers[i], i / 3));
        warnings_.count("value", "of normals or unused vertices, not finite, taken as 0", 0,
                        accessor(index).path());
        numbers[i] = 0;
    }
    std::vector<glm::dvec3> out;
    out.reserve(count);
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
    const Used used = used_by(in);
    append(to.rest, triples(attributes.at("POSITION"), count, false, used));
    const std::vector<glm::dvec3> none(count, glm::dvec3(0));
    const auto normals = attributes.find("NORMAL");
    if (smooth) append(to.normals, normals ? triples(*normals, count, true, used) : none);
    for (std::size_t i = 0; i < to.targets.size(); ++i) {
        const JsonValue target = in.at("targets")[i].object();
        const auto moves = target.find("POSITION"), turns = target.find("NORMAL");
        append(to.targets[i].moves, moves ? triples(*moves, count, false, used) : none);
        if (smooth) append(to.targets[i].turns, turns ? triples(*turns, count, true, used) : none);
    }
    if (is_skinned) add_pulls(attributes, count, used, to);
}

std::vector<double> GltfDeformer::fours(const JsonValue& attribute, std::size_t vertices) {
    std::vector<double> all = buffers_.read(accessor_of(attribute), 4);
    if (all.size() != 4 * vertices)
        attribute.refuse(fmt::format("has {} elements for {} vertices", all.size() / 4, vertices));
    return all;
}

/// Reads JOINTS_0, WEIGHTS_0 and the sets that follow, each with four joints per vertex. Weights need not sum
/// to 1, because normalise() divides by the sum. A vertex without weights follows its first joint.
void GltfDeformer::add_pulls(const JsonValue& attributes, std::size_t vertices, const Used& used,
                             Deforming& to) {
    std::vector<std::vector<double>> joints, weights;
    for (std::size_t set = 0;; ++set) {
        const auto joint = attributes.find(fmt::format("JOINTS_{}", set)),
                   weight = attributes.find(fmt::format("WEIGHTS_{}", set));
        if (!joint && !weight && set > 0) break;
        if (!joint || !weight)
            attributes.refuse(
                fmt::format("has no {}_{}, and {} has a skin", joint ? "WEIGHTS" : "JOINTS", set, to.name));
        const JsonValue type = accessor(accessor_of(*joint)).at("componentType");
        if (type.raw() != 5121 && type.raw() != 5123) type.expected("5121 or 5123 for joints");
        joints.push_back(fours(*joint, vertices));
        weights.push_back(fours(*weight, vertices));
    }
    if (!loading_.may_make(4 * joints.size() * vertices * sizeof(Pull)))
        attributes.refuse(loading_.too_much());
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::size_t first = to.pulls.size();
        double sum = 0;
        for (std::size_t k = 0; k < 4 * joints.size(); ++k) {
            const double joint = joints[k / 4][4 * v + k % 4], weight = weights[k / 4][4 * v + k % 4];
            if (weight == 0) continue;
            const bool is_good = weight > 0 && std::isfinite(weight),
                       is_joint = joint < double(to.joints.size());
            if (!is_good && used(v))
                attributes.at(fmt::format("WEIGHTS_{}", k / 4))
                    .refuse(fmt::format("has the weight {} at vertex {}; weights are 0 or more", weight, v));
            if (is_good && !is_joint && used(v))
                attributes.at(fmt::format("JOINTS_{}", k / 4))
                    .refuse(fmt::format("names joint {} at vertex {}, which is out of range: the skin has {}",
                                        joint, v, to.joints.size()));
            if (!is_good || !is_joint) continue;
            sum += weight;
            to.pulls.push_back({std::uint32_t(joint), weight});
        }
        normalise(v, first, sum, joints[0][4 * v], to);
    }
}

void GltfDeformer::normalise(std::size_t vertex, std::size_t first, double sum, double joint, Deforming& to) {
    const std::string place = fmt::format("vertex {}", vertex);
    if (first == to.pulls.size()) {
        warnings_.count("vertex", "of a skin without a weight, carried by the first joint", 0, place);
        to.pulls.push_back({joint < double(to.joints.size()) ? std::uint32_t(joint) : 0, 1});
        sum = 1;
    } else if (!(std::abs(sum - 1) <= max_off)) {
        warnings_.count("vertex", "of a skin with weights that do not sum to 1, taken by their proportion", 0,
                        place);
    }
    for (std::size_t i = first; i < to.pulls.size(); ++i) to.pulls[i].weight /= sum;
    to.first_pull.push_back(std::uint32_t(to.pulls.size()));
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
        const std::optional<NodePlace> where = where_of_(node);
        if (!where) list[i].refuse(fmt::format("names nodes[{}], which is not in the scene", node));
        Joint joint{where->node, where->place, glm::dmat4(1)};
        for (int k = 0; k < 16 && !bind.empty(); ++k)   // column by column, as in glm
            joint.inverse_bind[k / 4][k % 4] = bind[16 * i + std::size_t(k)];
        to.joints.push_back(joint);
    }
}

}   // namespace rayclock
