// Reading numbers, references and <asset>s of a COLLADA document.
#include "sim/load/dae/document.hpp"

#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "sim/files/text.hpp"

namespace rayclock {

DaeDocument::DaeDocument(const XmlElement& top, std::string file, Loading& loading)
    : top_(top), file_(std::move(file)), loading_(loading) {
    const XmlElement* const asset = top.find("asset");
    frames_.push_back(asset ? frame(*asset, {}) : Frame{});
    collect(top, 0);
}

void DaeDocument::collect(const XmlElement& element, std::uint32_t frame) {
    if (const std::string id = element.attribute("id"); !id.empty()) by_id_.try_emplace(id, &element);
    const XmlElement* const asset = &element == &top_ ? nullptr : element.find("asset");
    if (asset && (asset->find("unit") || asset->find("up_axis"))) {
        frames_.push_back(this->frame(*asset, frames_[frame]));
        loading_.note(file_, "parts of it have a unit or an up axis of their own, and are drawn by them");
        frame = static_cast<std::uint32_t>(frames_.size() - 1);
    }
    if (frame != 0) frame_of_.emplace(&element, frame);
    for (const XmlElement& child : element.children) collect(child, frame);
}

DaeDocument::Frame DaeDocument::frame(const XmlElement& asset, Frame inherited) const {
    if (const XmlElement* const up = asset.find("up_axis")) {
        const std::string axis = joined_words(up->text);
        inherited.turn = glm::dmat4(1);
        if (axis == "Z_UP") inherited.turn[1] = {0, 0, -1, 0}, inherited.turn[2] = {0, 1, 0, 0};
        if (axis == "X_UP") inherited.turn[0] = {0, 1, 0, 0}, inherited.turn[1] = {-1, 0, 0, 0};
    }
    if (const XmlElement* const unit = asset.find("unit"); unit && !unit->attribute("meter").empty()) {
        inherited.metres = finite_number(with_point(unit->attribute("meter")), {file_, unit->line});
        if (!(inherited.metres > 0)) refuse(*unit, fmt::format("a unit of {} metres", inherited.metres));
    }
    return inherited;
}

glm::dmat4 DaeDocument::into(const XmlElement& outer, const XmlElement& inner) const {
    const auto frame = [&](const XmlElement& element) {
        const auto found = frame_of_.find(&element);
        return found == frame_of_.end() ? 0 : found->second;
    };
    if (frame(outer) == frame(inner)) return glm::dmat4(1);
    const Frame &from = frames_[frame(inner)], &to = frames_[frame(outer)];
    glm::dmat4 made = glm::transpose(to.turn) * from.turn;
    for (int column = 0; column < 3; ++column) made[column] *= from.metres / to.metres;
    return made;
}

void DaeDocument::refuse(const XmlElement& where, const std::string& sentence) const {
    SourcePosition{file_, where.line}.refuse(sentence);
}

void DaeDocument::charge(std::uint64_t bytes) const {
    if (!loading_.may_make(bytes)) SourcePosition{file_}.refuse(loading_.too_much());
}

const XmlElement* DaeDocument::with_id(const std::string& id) const {
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? nullptr : found->second;
}

const XmlElement* DaeDocument::find(const std::string& url) const {
    return url.starts_with('#') ? with_id(url.substr(1)) : nullptr;
}

const XmlElement& DaeDocument::target(const XmlElement& in, const char* key) const {
    const std::string url = in.attribute(key);
    const XmlElement* const found = find(url);
    if (!found) refuse(in, fmt::format("{} names {}, which is not in the file", in.name, shown(url)));
    return *found;
}

std::string_view DaeDocument::with_point(std::string_view word) const {
    const std::size_t comma = word.find(',');
    if (comma == word.npos) return word;
    if (commas_.empty()) loading_.note(file_, "its numbers have decimal commas, read as points");
    commas_.assign(word);
    commas_[comma] = '.';
    return commas_;
}

std::vector<float> DaeDocument::finite(const XmlElement& in) const {
    std::vector<float> numbers;
    std::string_view rest = in.text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
        numbers.push_back(static_cast<float>(finite_number(with_point(word), {file_, in.line})));
    return numbers;
}

std::vector<float> DaeDocument::finite(const XmlElement& in, std::size_t count) const {
    std::vector<float> numbers = finite(in);
    if (numbers.size() != count)
        refuse(in, fmt::format("{} of {} numbers instead of {}", in.name, numbers.size(), count));
    return numbers;
}

const std::vector<float>& DaeDocument::array(const XmlElement& in) {
    const auto [found, is_new] = arrays_.try_emplace(&in);
    if (!is_new) return found->second;
    std::string_view rest = in.text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
        found->second.push_back(static_cast<float>(any_number(with_point(word), {file_, in.line})));
    return found->second;
}

std::uint64_t DaeDocument::whole(const XmlElement& in, const char* key, std::uint64_t otherwise) const {
    const std::string text = in.attribute(key);
    if (text.empty()) return otherwise;
    const std::int64_t value = whole_number(text, {file_, in.line});
    if (value < 0 || value > std::int64_t{1} << 32) refuse(in, fmt::format("{} is {}", key, value));
    return static_cast<std::uint64_t>(value);
}

std::uint64_t DaeDocument::offset(const XmlElement& input) const {
    constexpr std::uint64_t max_inputs = 64;
    const std::uint64_t offset = whole(input, "offset", 0);
    if (offset >= max_inputs) refuse(input, fmt::format("an offset of {}", offset));
    return offset;
}

const XmlElement& DaeDocument::array_of(const XmlElement& source) const {
    const XmlElement* const accessor = source.at("technique_common/accessor");
    if (!accessor) refuse(source, "a source without an accessor");
    return target(*accessor, "source");
}

const DaePoints& DaeDocument::points(const XmlElement& input, std::uint64_t width) {
    const XmlElement& source = target(input, "source");
    const auto known = points_.find({&source, width});
    if (known != points_.end()) return known->second;
    return points_.emplace(std::pair{&source, width}, read_points(source, width)).first->second;
}

DaePoints DaeDocument::read_points(const XmlElement& source, std::uint64_t width) {
    DaePoints made{.numbers = &array(array_of(source))};
    const XmlElement& accessor = *source.at("technique_common/accessor");
    made.count = whole(accessor, "count", 0);
    made.first = whole(accessor, "offset", 0);
    made.stride = whole(accessor, "stride", 1);
    if (made.stride < width)
        refuse(accessor, fmt::format("a stride of {}, and a point has {} numbers", made.stride, width));
    // A parameter without a name is skipped. If fewer than `width` parameters have a name, the point has the
    // first numbers.
    std::uint64_t named = 0, number = 0;
    for (const XmlElement& param : accessor.children) {
        if (param.name != "param") continue;
        if (named < width && !param.attribute("name").empty()) made.part[named++] = number;
        ++number;
    }
    if (named < width) made.part = {0, 1, 2};
    const std::uint64_t last = made.part[width - 1] + 1, all = made.numbers->size();
    if (last > made.stride)
        refuse(accessor, fmt::format("{} params, and a stride of {}", number, made.stride));
    if (made.count > 0 && (made.first > all || (all - made.first) / made.stride + 1 < made.count ||
                           made.first + (made.count - 1) * made.stride + last > all))
        refuse(accessor, fmt::format("{} points go beyond the {} numbers of their array", made.count, all));
    return made;
}

}   // namespace rayclock
