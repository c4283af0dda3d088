// Finds statements and signals in the text of Verilog modules.
#include "sim/view/divergence/rtl_text.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace rayclock {

namespace {

/// Comments and directives become blanks, so that every place stays where it is.
std::string without_comments(std::string text) {
    for (std::size_t at = 0; at < text.size();) {
        const bool begins_line = at == 0 || text[at - 1] == '\n';
        std::size_t end = at;
        if (text.compare(at, 2, "/*") == 0)
            end = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
        else if (text.compare(at, 2, "//") == 0 || (begins_line && text[at] == '`'))
            end = std::min(text.find('\n', at), text.size());
        for (std::size_t k = at; k < end; ++k)
            if (text[k] != '\n') text[k] = ' ';
        at = std::max(end, at + 1);
    }
    return text;
}

/// Names of signals: not of packages, fields, system functions, literals or instances' ports.
std::vector<std::string> names_in(const std::string& text) {
    static const std::regex name(R"([A-Za-z_$][A-Za-z0-9_$]*|'[a-z0-9]+|[0-9][0-9a-z_]*)");
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it) {
        const std::size_t at = std::size_t(it->position());
        const std::string word = it->str();
        const bool is_field = at > 0 && (text[at - 1] == '.' || text[at - 1] == ':');
        const bool is_scope = text.compare(at + word.size(), 2, "::") == 0;
        // Constants begin with capital letters.
        const bool is_signal = word[0] == '_' || (word[0] >= 'a' && word[0] <= 'z');
        if (is_field || is_scope || !is_signal) continue;
        if (std::find(found.begin(), found.end(), word) == found.end()) found.push_back(word);
    }
    return found;
}

/// Returns the names of the driven signals, without the text in brackets.
std::vector<std::string> targets_in(const std::string& text) {
    std::string outside;
    int depth = 0;
    for (const char c : text) {
        depth += c == '[';
        if (depth == 0) outside += c;
        depth -= c == ']';
    }
    return names_in(outside);
}

std::size_t closing(const std::string& text, std::size_t open) {
    int depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        depth += text[at] == '(';
        depth -= text[at] == ')';
        if (depth == 0) return at;
    }
    return std::string::npos;
}

class Reader {
public:
    Reader(ModuleText& module, const std::string& text) : module_(module), text_(text) {}

    void read() {
        // A header's ports end with the first semicolon.
        for (std::size_t begin = text_.find(';'), end; begin != std::string::npos; begin = end) {
            ++begin;
            end = text_.find(';', begin);
            if (end != std::string::npos) statement(begin, text_.substr(begin, end - begin));
        }
    }

private:
    std::size_t line_of(std::size_t at) const {
        return 1 + std::size_t(std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at), '\n'));
    }

    void statement(std::size_t begin, const std::string& text) {
        static const std::regex cell(R"(\b(rc_\w+)\s*(?:#\s*\(|u_\w+\s*\())");
        std::smatch match;
        if (std::regex_search(text, match, cell) && text.find("u_") != std::string::npos)
            instance(begin, text, std::size_t(match.position()), match[1]);
        else
            assignment(begin, text);
    }

    void instance(std::size_t begin, const std::string& text, std::size_t at, const std::string& cell) {
        std::size_t open = text.find('(', at);
        if (text[text.find_first_not_of(" \n", at + cell.size())] == '#') {
            const std::size_t end = closing(text, open);
            if (end == std::string::npos) return;
            at = end + 1;
            open = text.find('(', at);
        }
        const std::size_t end = open == std::string::npos ? open : closing(text, open);
        if (end == std::string::npos) return;
        const std::vector<std::string> words = names_in(text.substr(at, open - at));
        if (words.empty()) return;
        const std::string name = words.back();
        static const std::regex port(R"(\.([a-z_]\w*)\s*(\()?)");
        for (std::size_t p = open + 1; p < end;) {
            std::smatch match;
            const std::string rest = text.substr(p, end - p);
            if (!std::regex_search(rest, match, port)) break;
            const std::size_t place = p + std::size_t(match.position());
            std::string value = match[1];
            p = place + std::size_t(match.length());
            if (match[2].matched) {
                const std::size_t close = closing(text, p - 1);
                value = text.substr(p, close - p);
                p = close + 1;
            }
            connect(line_of(begin + place), name, cell, match[1], value);
        }
    }

    void connect(std::size_t line, const std::string& name, const std::string& cell, const std::string& port,
                 const std::string& value) {
        if (port.ends_with("_o") || port.ends_with("_no"))
            module_.drivers.push_back(
                {SignalDriver::Construct::instance, line, targets_in(value), {}, name, cell, port});
        else
            module_.inputs.push_back({name, port, line, names_in(value)});
    }

    void assignment(std::size_t begin, const std::string& text) {
        static const std::regex operation(
            R"(((?:\{[^{}]*\}|[a-z_]\w*)(?:\s*\[(?:[^\[\]]|\[[^\[\]]*\])*\]|\.\w+)*)\s*(<=|=)(?!=))");
        static const std::regex before(R"((?:^|\bassign|\bbegin(?:\s*:\s*\w+)?|\belse|\)|:|\bend)\s*$)");
        std::smatch best;
        std::size_t best_at = 0;
        for (std::sregex_iterator it(text.begin(), text.end(), operation), end; it != end; ++it) {
            const std::size_t at = std::size_t(it->position());
            if (!std::regex_search(text.substr(0, at), before)) continue;
            best = *it;
            best_at = at;
        }
        if (best.empty()) return;
        const auto construct =
            best[2] == "<=" ? SignalDriver::Construct::registered : SignalDriver::Construct::combinational;
        module_.drivers.push_back({construct, line_of(begin + best_at), targets_in(best[1]),
                                   names_in(text.substr(best_at + std::size_t(best.length()))), "", "", ""});
    }

    ModuleText& module_;
    const std::string& text_;
};

}   // namespace

ModuleText read_module(const std::string& file, const std::string& text) {
    ModuleText module{file, "", {}, {}, {}};
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) module.lines.push_back(line);
    const std::string plain = without_comments(text);
    static const std::regex head(R"(\bmodule\s+(\w+))");
    std::smatch match;
    if (!std::regex_search(plain, match, head)) return module;
    module.name = match[1];
    const std::string body = plain.substr(std::size_t(match.position()));
    const std::string blank(std::size_t(std::count(plain.begin(), plain.begin() + match.position(), '\n')),
                            '\n');
    const std::string all = blank + body;
    Reader(module, all).read();
    return module;
}

}   // namespace rayclock
