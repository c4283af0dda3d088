// Escaping, tables, base64 and deflate for HTML pages.
#include "sim/view/page/html.hpp"

#include <stdexcept>

#include <zlib.h>

namespace rayclock::html {

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\'': out += "&#39;"; break;
            default: out += c;
        }
    return out;
}

std::string data_element(std::string_view id, const nlohmann::ordered_json& json) {
    std::string out = "<script type=\"application/json\" id=\"" + std::string(id) + "\">";
    for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    return out + "</script>\n";
}

std::string table(std::string_view caption, const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows, std::size_t left) {
    std::string out = "<table>";
    if (!caption.empty()) out += "<caption>" + escaped(caption) + "</caption>";
    const auto line = [&](const std::vector<std::string>& cells, const char* element) {
        out += "<tr>";
        for (std::size_t i = 0; i < cells.size(); ++i)
            out += std::string("<") + element + (i < left ? " class=\"word\">" : ">") + escaped(cells[i]) +
                   "</" + element + ">";
        out += "</tr>\n";
    };
    out += "<thead>";
    line(head, "th");
    out += "</thead><tbody>\n";
    for (const std::vector<std::string>& row : rows) line(row, "td");
    return out + "</tbody></table>\n";
}

std::string section(const char* id, const char* title, const std::string& inside) {
    return std::string("<section id=\"") + id + "\"><h2>" + title + "</h2>\n" + inside + "</section>\n";
}
std::string chart(const char* id, const char* label) {
    return std::string("<div class=\"chart\" id=\"chart-") + id + "\" role=\"img\" aria-label=\"" + label +
           "\"></div>\n";
}
std::string figures(const std::vector<std::pair<const char*, std::string>>& figures) {
    std::string out = "<div class=\"figures\">";
    for (const auto& [what, value] : figures)
        out += "<div><b>" + escaped(value) + "</b><span>" + what + "</span></div>";
    return out + "</div>\n";
}

std::string far_sentence(const nlohmann::ordered_json& report) {
    const auto limits = report.find("limits");
    if (limits == report.end() || limits->is_null() || limits->at("sentence").is_null()) return {};
    return limits->at("sentence").get<std::string>();
}

std::string base64(std::string_view bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve(bytes.size() * 4 / 3 + 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        const std::size_t some = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < some ? std::uint8_t(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += k <= some ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string deflated(std::string_view bytes) {
    uLongf size = compressBound(uLong(bytes.size()));
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  uLong(bytes.size()), 6) != Z_OK)
        throw std::runtime_error("zlib cannot compress");
    out.resize(size);
    return out;
}

namespace {

int digit_of(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}   // namespace

std::string inflated(std::string_view text, std::size_t size) {
    std::string packed;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        const int digit = digit_of(c);
        if (digit < 0) break;   // the '=' at the end
        group = group << 6 | std::uint32_t(digit);
        if ((bits += 6) < 8) continue;
        bits -= 8;
        packed += char(group >> bits & 255);
    }
    // Deflate expands by at most 1032, so a larger `size` is an error. The check precedes the allocation.
    constexpr std::size_t max_for_a_byte = 1032;
    if (size / max_for_a_byte > packed.size()) throw std::runtime_error("packed bytes are too few");
    std::string out(size, '\0');
    uLongf length = uLong(size);
    if (uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                   reinterpret_cast<const Bytef*>(packed.data()), uLong(packed.size())) != Z_OK ||
        length != size)
        throw std::runtime_error("packed bytes are broken");
    return out;
}

}   // namespace rayclock::html
