// Morphing and skinning of COLLADA meshes, by the formulas of the COLLADA 1.4.1 specification.
#include "sim/load/dae/controller.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/files/text.hpp"

namespace rayclock {
namespace {

constexpr int max_controllers = 8;   // nesting depth

const XmlElement* input(const XmlElement& in, std::string_view semantic) {
    for (const XmlElement& child : in.children)
        if (child.name == "input" && child.attribute("semantic") == semantic) return &child;
    return nullptr;
}

/// Reads a matrix, which COLLADA writes row by row.
glm::dmat4 matrix_at(const std::vector<float>& numbers, std::size_t first) {
    glm::dmat4 made(1);
    for (int i = 0; i < 16; ++i) made[i % 4][i / 4] = numbers[first + static_cast<std::size_t>(i)];
    return made;
}

/// Reads the whole numbers of an element's text one after the other.
class Numbers {
public:
    Numbers(const XmlElement& in, const DaeDocument& document)
        : in_(in), document_(document), rest_(in.text) {}
    std::int64_t take() {
        const std::string_view word = take_word(rest_);
        if (word.empty()) document_.refuse(in_, in_.name + " has too few numbers");
        return whole_number(word, {document_.file(), in_.line});
    }

private:
    const XmlElement& in_;
    const DaeDocument& document_;
    std::string_view rest_;
};

}   // namespace

DaePose DaeControllers::pose(const XmlElement& instance) {
    DaePose made;
    apply(document_.target(instance, "url"), instance, made, 0);
    return made;
}

void DaeControllers::apply(const XmlElement& controller, const XmlElement& instance, DaePose& pose,
                           int depth) {
    if (controller.name == "geometry") return void(pose.geometry = &controller);
    if (depth == max_controllers)
        document_.refuse(controller, fmt::format("more than {} nested controllers", depth));
    const XmlElement *const skin = controller.find("skin"), *const morph = controller.find("morph"),
                            *const in = skin ? skin : morph;
    if (!in) return;
    apply(document_.target(*in, "source"), instance, pose, depth + 1);   // its source comes first
    if (!positions(pose.geometry)) return;
    if (skin)
        this->skin(*skin, instance, pose);
    else
        this->morph(*morph, pose);
}

const DaePoints* DaeControllers::positions(const XmlElement* geometry) {
    const XmlElement* const vertices = geometry ? geometry->at("mesh/vertices") : nullptr;
    const XmlElement* const position = vertices ? input(*vertices, "POSITION") : nullptr;
    return position ? &document_.points(*position) : nullptr;
}

std::vector<std::string> DaeControllers::words(const XmlElement& input) {
    std::vector<std::string> all;
    std::string_view rest = document_.array_of(document_.target(input, "source")).text;
    document_.charge(sizeof(std::string) * rest.size());
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
        all.emplace_back(word);
    return all;
}

void DaeControllers::morph(const XmlElement& in, DaePose& pose) {
    const XmlElement* const targets = in.find("targets");
    const XmlElement *const names = targets ? input(*targets, "MORPH_TARGET") : nullptr,
                            *const given = targets ? input(*targets, "MORPH_WEIGHT") : nullptr;
    if (!names || !given) document_.refuse(in, "a morph without targets or weights");
    const std::vector<float>& weights =
        document_.array(document_.array_of(document_.target(*given, "source")));
    const std::vector<std::string> ids = words(*names);
    const DaePoints& base = *positions(pose.geometry);
    document_.charge(sizeof(glm::dvec3) * base.count * (1 + ids.size()));
    std::vector<glm::dvec3> moved(base.count, glm::dvec3(0));
    double sum = 0;
    for (std::size_t t = 0; t < std::min(ids.size(), weights.size()); ++t) {
        if (weights[t] == 0) continue;
        if (!std::isfinite(weights[t])) document_.refuse(*targets, fmt::format("a weight of {}", weights[t]));
        const DaePoints* const target = positions(document_.with_id(ids[t]));
        if (!target || target->count != base.count) {
            ++faults_.other_targets;
            continue;
        }
        sum += weights[t];
        for (std::uint64_t i = 0; i < base.count; ++i) moved[i] += double(weights[t]) * (*target)[i];
    }
    if (sum == 0) return;
    ++faults_.morph_normals;
    const double rest = in.attribute("method") == "RELATIVE" ? 1 : 1 - sum;
    for (std::uint64_t i = 0; i < base.count; ++i) moved[i] += rest * base[i];
    pose.positions = std::move(moved);
}

void DaeControllers::skin(const XmlElement& in, const XmlElement& instance, DaePose& pose) {
    const XmlElement *const bound = in.find("bind_shape_matrix"), *const weights = in.find("vertex_weights");
    const glm::dmat4 shape = bound ? matrix_at(document_.finite(*bound, 16), 0) : glm::dmat4(1);
    if (!weights) document_.refuse(in, "a skin without vertex_weights");
    const std::vector<glm::dmat4> all = joints(in, instance, shape);
    document_.charge(sizeof(glm::dmat4) * positions(pose.geometry)->count + weights->text.size());
    carry(*weights, all, document_.up() * shape, pose);
}

/// Returns the matrix of each joint: node's place * inverse bind matrix * bind shape.
std::vector<glm::dmat4> DaeControllers::joints(const XmlElement& skin, const XmlElement& instance,
                                               const glm::dmat4& shape) {
    const XmlElement* const list = skin.find("joints");
    const XmlElement *const names = list ? input(*list, "JOINT") : nullptr, *const inverse =
                                                                                list
                                                                                    ? input(*list,
                                                                                            "INV_BIND_MATRIX")
                                                                                    : nullptr;
    if (!names || !inverse) document_.refuse(skin, "a skin without joints or their matrices");
    const std::vector<std::string> all = words(*names);
    const XmlElement& matrices = document_.array_of(document_.target(*inverse, "source"));
    const std::vector<float>& numbers = document_.array(matrices);
    if (numbers.size() / 16 < all.size())
        document_.refuse(matrices,
                         fmt::format("{} numbers for the matrices of {} joints", numbers.size(), all.size()));
    document_.charge(sizeof(glm::dmat4) * all.size());
    std::vector<glm::dmat4> made;
    for (const std::string& name : all) {
        const XmlElement* const found = node(name, instance);
        const auto place = places_.find(found);
        faults_.lost_joints += place == places_.end();
        made.push_back(place == places_.end() ? document_.up() * shape   // its bind pose
                                              : place->second * matrix_at(numbers, 16 * made.size()) * shape);
    }
    return made;
}

const XmlElement* DaeControllers::node(const std::string& name, const XmlElement& instance) {
    for (const XmlElement& child : instance.children) {
        if (child.name != "skeleton") continue;
        document_.charge(sizeof(XmlElement));   // each joint searches every skeleton
        const XmlElement* const root = document_.find(joined_words(child.text));
        if (!root) continue;
        const Names& names = names_below(*root);
        if (const auto found = names.find(name); found != names.end()) return found->second;
    }
    if (const XmlElement* const found = document_.with_id(name)) return found;
    const Names& names = names_below(document_.top());
    const auto found = names.find(name);
    return found == names.end() ? nullptr : found->second;
}

const DaeControllers::Names& DaeControllers::names_below(const XmlElement& root) {
    const auto [found, is_new] = names_.try_emplace(&root);
    if (!is_new) return found->second;
    std::vector<const XmlElement*> open{&root};
    while (!open.empty()) {
        const XmlElement& element = *open.back();
        open.pop_back();
        document_.charge(sizeof(XmlElement));
        if (const std::string sid = element.attribute("sid"); element.name == "node" && !sid.empty())
            found->second.try_emplace(sid, &element);
        for (auto child = element.children.rbegin(); child != element.children.rend(); ++child)
            open.push_back(&*child);
    }
    return found->second;
}

void DaeControllers::carry(const XmlElement& weights, const std::vector<glm::dmat4>& joints,
                           const glm::dmat4& shape, DaePose& pose) {
    const XmlElement *const of_joint = input(weights, "JOINT"), *const of_weight = input(weights, "WEIGHT"),
                            *const counts = weights.find("vcount"), *const list = weights.find("v");
    if (!of_joint || !of_weight || !counts)
        document_.refuse(weights, "vertex_weights without joints or weights");
    const XmlElement& array = document_.array_of(document_.target(*of_weight, "source"));
    const std::vector<float>& values = document_.array(array);
    const std::uint64_t joint_at = document_.offset(*of_joint), weight_at = document_.offset(*of_weight);
    std::uint64_t stride = 1;
    for (const XmlElement* each : weights.all("input"))
        stride = std::max(stride, document_.offset(*each) + 1);
    const std::uint64_t vertices = positions(pose.geometry)->count;
    Numbers how_many(*counts, document_), pairs(list ? *list : weights, document_);
    pose.moves.assign(vertices, shape);
    for (std::uint64_t v = 0; v < vertices; ++v) {
        glm::dmat4 move(0);
        double sum = 0;
        for (std::int64_t k = how_many.take(); k > 0; --k) {
            std::int64_t joint = 0, weight = 0;
            for (std::uint64_t i = 0; i < stride; ++i) {
                const std::int64_t index = pairs.take();
                if (i == joint_at) joint = index;
                if (i == weight_at) weight = index;
            }
            if (joint < -1 || joint >= static_cast<std::int64_t>(joints.size()))
                document_.refuse(weights,
                                 fmt::format("joint {} is out of range: there are {} (0 is the first)", joint,
                                             joints.size()));
            if (weight < 0 || weight >= static_cast<std::int64_t>(values.size()))
                document_.refuse(
                    weights, fmt::format("weight {} is out of range: there are {} (0 is the first)", weight,
                                         values.size()));
            const float share = values[static_cast<std::size_t>(weight)];
            if (!std::isfinite(share)) document_.refuse(array, fmt::format("a weight of {}", share));
            move += double(share) * (joint < 0 ? shape : joints[static_cast<std::size_t>(joint)]);
            sum += share;
        }
        faults_.odd_weights += !(std::abs(sum - 1) <= 0.01);
        if (sum > 0) pose.moves[v] = move * (1 / sum);
    }
}

}   // namespace rayclock
