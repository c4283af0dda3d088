// Splits payloads into their fields.
#include "sim/view/divergence/fields.hpp"

#include <type_traits>

#include <fmt/format.h>

namespace rayclock {

namespace {

class FieldVisitor {
public:
    explicit FieldVisitor(int bits) : at_(bits) {}
    std::vector<PayloadField> fields;
    template <class T> void operator()(const char* name, const T&, int width) { add<T>(name, width); }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&, int width, int count) {
        for (int i = count; i-- > 0;) add<T>(fmt::format("{}_{}", name, i), width);
    }

private:
    template <class T> void add(std::string name, int width) {
        at_ -= width;
        constexpr bool is_signed = std::is_signed_v<T> || sizeof(T) > sizeof(std::uint64_t);
        fields.push_back({std::move(name), at_, width, is_signed});
    }
    int at_;
};

template <class P> std::vector<PayloadField> fields_of(const Config& config) {
    FieldVisitor visitor(bits_of<P>(config));
    P{}.fields(visitor, config);
    return std::move(visitor.fields);
}

template <std::size_t... i>
std::vector<PayloadField> fields_of(Link link, const Config& config, std::index_sequence<i...>) {
    std::vector<PayloadField> fields;
    ((index(link) == i ? void(fields = fields_of<std::tuple_element_t<i, LinkPayloads>>(config)) : void()),
     ...);
    return fields;
}

std::uint64_t bits_from(const Words& words, int at, int count) {
    std::uint64_t value = 0;
    for (int i = count; i-- > 0;)
        value = value << 1 | (words[std::size_t((at + i) / 32)] >> ((at + i) % 32) & 1);
    return value;
}

}   // namespace

std::vector<PayloadField> payload_fields(Link link, const Config& config) {
    return fields_of(link, config, std::make_index_sequence<link_count>{});
}

std::string field_text(const PayloadField& field, const Words& payload) {
    constexpr int longest = 64;
    if (field.width > longest) {
        std::string text = "0x";
        for (int at = (field.width - 1) / longest * longest; at >= 0; at -= longest)
            text +=
                fmt::format("{:x}", bits_from(payload, field.at + at, std::min(longest, field.width - at)));
        return text;
    }
    const std::uint64_t value = bits_from(payload, field.at, field.width);
    if (!field.is_signed) return fmt::format("{}", value);
    const int unused = longest - field.width;
    return fmt::format("{}", std::int64_t(value << unused) >> unused);
}

}   // namespace rayclock
