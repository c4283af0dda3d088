// Heads of NumPy's array files.
#include "sim/files/npy.hpp"

#include <charconv>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

namespace {

constexpr std::string_view magic = "\x93NUMPY";

[[noreturn]] void refuse_array(const std::string& name, const std::string& what) {
    throw UserError(fmt::format("{}: not an array that can be read: {}", name, what));
}

/// The text of a head, read from left to right: a Python dictionary of literals, as numpy.lib.format writes
/// it.
class HeadText {
public:
    HeadText(std::string_view text, const std::string& name) : left_(text), name_(name) {}

    void skip() {
        const std::size_t next = left_.find_first_not_of(" \t\n");
        left_.remove_prefix(next == left_.npos ? left_.size() : next);
    }
    bool take(std::string_view token) {
        skip();
        if (!left_.starts_with(token)) return false;
        left_.remove_prefix(token.size());
        return true;
    }
    void require(std::string_view token) {
        if (!take(token)) refuse(fmt::format("its head lacks '{}'", token));
    }
    std::string quoted() {
        skip();
        const char quote = left_.empty() ? '\0' : left_[0];
        const std::size_t end = quote == '\'' || quote == '"' ? left_.find(quote, 1) : left_.npos;
        if (end == left_.npos) refuse("its head lacks a quoted name");
        const std::string text(left_.substr(1, end - 1));
        left_.remove_prefix(end + 1);
        return text;
    }
    /// Skips a list in brackets.
    void skip_list() {
        int depth = 0;
        do {
            skip();
            if (left_.empty()) refuse("its head ends within a list");
            depth += left_[0] == '[' ? 1 : left_[0] == ']' ? -1 : 0;
            left_.remove_prefix(1);
        } while (depth > 0);
    }
    std::uint64_t number() {
        skip();
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
        if (error != std::errc{}) refuse("its shape is not a list of whole numbers");
        left_.remove_prefix(std::size_t(end - left_.data()));
        take("L");   // Python 2 writes it
        return value;
    }
    bool next_is(char c) {
        skip();
        return !left_.empty() && left_[0] == c;
    }
    bool is_empty() {
        skip();
        return left_.empty();
    }
    [[noreturn]] void refuse(const std::string& what) const { refuse_array(name_, what); }

private:
    std::string_view left_;
    const std::string& name_;
};

/// Returns the bytes of an element, or 0 if the type is not a number.
std::uint64_t bytes_of_type(const std::string& descr) {
    std::uint64_t bytes = 0;
    if (descr.size() < 3) return 0;
    const auto [end, error] = std::from_chars(descr.data() + 2, descr.data() + descr.size(), bytes);
    return error == std::errc{} && end == descr.data() + descr.size() ? bytes : 0;
}

}   // namespace

NpyHead read_npy_head(std::string_view bytes, const std::string& name) {
    const auto refuse = [&](const std::string& what) { refuse_array(name, what); };
    const auto byte = [&](std::size_t at) { return std::size_t(static_cast<unsigned char>(bytes[at])); };
    if (!bytes.starts_with(magic)) refuse("it does not begin as an .npy file does");
    if (bytes.size() > magic.size() && (byte(magic.size()) < 1 || byte(magic.size()) > 3))
        refuse(fmt::format("its format has version {}, and 1 to 3 are known", byte(magic.size())));
    const std::size_t lengths = bytes.size() > magic.size() && byte(magic.size()) >= 2 ? 4 : 2;
    NpyHead head;
    head.begin = magic.size() + 2 + lengths;
    if (bytes.size() < head.begin) refuse("it ends within its head");
    std::size_t length = 0;
    for (std::size_t i = 0; i < lengths; ++i) length |= byte(magic.size() + 2 + i) << 8 * i;
    if (length > bytes.size() - head.begin) refuse("it ends within its head");
    HeadText text(bytes.substr(head.begin, length), name);
    head.begin += length;

    bool fortran = false, has_shape = false, has_type = false, has_order = false;
    const auto once = [&](bool& has) {
        if (has) text.refuse("its head has an entry twice");
        has = true;
    };
    text.require("{");
    while (!text.take("}")) {
        const std::string key = text.quoted();
        text.require(":");
        if (key == "descr") {
            once(has_type);
            if (text.next_is('['))
                text.skip_list();
            else
                head.descr = text.quoted();
        } else if (key == "fortran_order") {
            once(has_order);
            fortran = text.take("True");
            if (!fortran) text.require("False");
        } else if (key == "shape") {
            once(has_shape);
            text.require("(");
            while (!text.take(")")) {
                head.shape.push_back(text.number());
                if (!text.take(",") && !text.next_is(')')) text.refuse("its shape has no end");
            }
        } else {
            text.refuse("its head has the unknown entry " + shown(key));
        }
        if (!text.take(",") && !text.next_is('}')) text.refuse("its head has no end");
    }
    if (!text.is_empty()) refuse("its head does not end after the dictionary");
    if (!has_shape || !has_type || !has_order) refuse("its head lacks 'descr', 'fortran_order' or 'shape'");
    if (head.descr.find('O') != head.descr.npos) refuse("it holds Python objects, which are never loaded");
    if (fortran && head.shape.size() > 1)
        refuse("it is in Fortran order; save numpy.ascontiguousarray(a) instead");
    if (head.descr.empty()) return head;
    const std::uint64_t size = bytes_of_type(head.descr), have = bytes.size() - head.begin;
    if (size == 0) refuse("its type " + shown(head.descr) + " is unknown");
    std::uint64_t need = size;
    bool too_many = false;
    for (const std::uint64_t n : head.shape) too_many |= __builtin_mul_overflow(need, n, &need);
    if (too_many || need != have)
        refuse(fmt::format("its shape needs {} bytes of data, and {} follow",
                           too_many ? std::string("more than 2^64") : std::to_string(need), have));
    return head;
}

std::string npy_head(const std::string& descr, const std::vector<std::uint64_t>& shape) {
    std::string sizes;
    for (const std::uint64_t n : shape) sizes += std::to_string(n) + ", ";
    std::string text = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({}), }}", descr, sizes);
    constexpr std::size_t alignment = 64;
    const std::size_t before = magic.size() + 4;
    text.append((alignment - (before + text.size() + 1) % alignment) % alignment, ' ');
    text += '\n';
    std::string bytes(magic);
    bytes += {'\1', '\0', char(text.size() & 255), char(text.size() >> 8)};
    return bytes + text;
}

}   // namespace rayclock
