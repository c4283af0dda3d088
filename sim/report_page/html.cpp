#include "sim/report_page/html.hpp"

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

}   // namespace rayclock::html
