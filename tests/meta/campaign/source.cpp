// Splits a source into the chunks in which faults are planted.
#include "tests/meta/campaign/source.hpp"

#include <array>
#include <cctype>
#include <string_view>

namespace rayclock::campaign {

namespace {

constexpr auto npos = std::string::npos;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '$'; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)); }

void blank(std::string& text, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to && i < text.size(); ++i)
        if (text[i] != '\n') text[i] = ' ';
}

/// Steps through one chunk between two ends of statements.
class Chunk {
public:
    Chunk(const std::string& text, std::size_t begin, std::size_t end, Language language, std::size_t& block,
          std::vector<Region>& found)
        : text_(text), at_(begin), end_(end), language_(language), block_(block), found_(found) {}

    void read() {
        while (prefix()) {}
        skip_space();
        if (at_ >= end_) return;
        if (language_ == Language::verilog) ports();
        assignment();
    }

private:
    void skip_space() {
        while (at_ < end_ && is_space(text_[at_])) ++at_;
    }
    std::string_view word() const {
        std::size_t to = at_;
        while (to < end_ && is_word(text_[to])) ++to;
        return std::string_view(text_).substr(at_, to - at_);
    }
    bool take_brackets(bool as_condition) {
        skip_space();
        if (at_ >= end_ || text_[at_] != '(') return false;
        const std::size_t behind = behind_bracket(text_, at_);
        if (behind == npos || behind > end_) return false;
        if (as_condition) found_.push_back({at_ + 1, behind - 1, "", block_, true});
        at_ = behind;
        return true;
    }
    /// Takes one word of structure off the front.
    bool prefix() {
        skip_space();
        if (at_ >= end_) return false;
        if (language_ == Language::verilog && label()) return true;
        const std::string_view w = word();
        const auto is = [&](std::initializer_list<const char*> words) {
            for (const char* x : words)
                if (w == x) return true;
            return false;
        };
        if (is({"begin", "end", "else", "endcase", "generate", "endgenerate", "endfunction", "unique",
                "do"})) {
            at_ += w.size();
            skip_space();
            if (w != "else" && at_ < end_ && text_[at_] == ':') {   // begin : name
                ++at_;
                skip_space();
                at_ += word().size();
            }
            return true;
        }
        if (is({"always_ff", "always_comb", "always"})) {
            block_ = at_;
            at_ += w.size();
            skip_space();
            if (at_ < end_ && text_[at_] == '@') ++at_, take_brackets(false);
            return true;
        }
        if (is({"if", "while"})) {
            at_ += w.size();
            skip_space();
            if (word() == "constexpr") return false;
            return take_brackets(true);
        }
        if (is({"for", "case", "switch"})) {
            at_ += w.size();
            return take_brackets(false);
        }
        if (is({"function", "initial"})) block_ = npos;   // no place for a register
        if (is({"assign"})) {
            block_ = at_;
            at_ += w.size();
            return true;
        }
        if (w == "return" && language_ == Language::cpp) {
            at_ += w.size();
            skip_space();
            if (at_ < end_ && text_[at_] != '{') found_.push_back({at_, end_, "", block_});
            at_ = end_;
        }
        return false;
    }
    /// "2'd1:" or "default:".
    bool label() {
        std::size_t to = at_;
        while (to < end_ && (is_word(text_[to]) || text_[to] == '\'' || text_[to] == ',' ||
                             text_[to] == ' ' || text_[to] == '.'))
            ++to;
        if (to == at_ || to >= end_ || text_[to] != ':' || (to + 1 < end_ && text_[to + 1] == ':'))
            return false;
        if (std::string_view(text_).substr(at_, to - at_).find("begin") != npos || word() == "end")
            return false;
        at_ = to + 1;
        return true;
    }
    /// ".valid_i(expression)" of an instance.
    void ports() {
        for (std::size_t i = at_; i + 1 < end_; ++i) {
            if (text_[i] != '.' || !is_word(text_[i + 1]) || (i > 0 && is_word(text_[i - 1]))) continue;
            std::size_t to = i + 1;
            while (to < end_ && is_word(text_[to])) ++to;
            if (text_[to] != '(' || text_.compare(to - 2, 2, "_i") != 0) continue;
            const std::size_t behind = behind_bracket(text_, to);
            if (behind == npos || behind - 1 <= to + 1) continue;
            found_.push_back({to + 1, behind - 1, "", at_});
            i = behind - 1;
        }
    }
    void assignment() {
        static constexpr std::array<std::string_view, 19> not_first{
            "localparam", "parameter", "typedef",  "input",  "output", "genvar",    "import",
            "package",    "logic",     "module",   "static", "using",  "namespace", "struct",
            "class",      "enum",      "template", "assert", "wire"};
        for (const std::string_view w : not_first)
            if (word() == w) return;
        int depth = 0;
        for (std::size_t i = at_; i < end_; ++i) {
            const char c = text_[i];
            if (c == '(' || c == '[' || c == '{') ++depth;
            if (c == ')' || c == ']' || c == '}') --depth;
            if (depth < 0) return;
            if (depth > 0 || c != '=' || i + 1 >= end_ || text_[i + 1] == '=') continue;
            const char before = text_[i - 1];
            if (before == '!' || before == '>' || (before == '<' && language_ == Language::cpp)) return;
            if (before == '=' || (before == '<' && text_[i - 2] != ' ')) return;
            const std::size_t left = before == ' ' ? i : i - 1;
            std::size_t from = i + 1;
            while (from < end_ && is_space(text_[from])) ++from;
            if (from >= end_ || text_[from] == '{' || (language_ == Language::cpp && text_[from] == '[')) {
                if (language_ == Language::cpp || from >= end_) return;
            }
            std::string target = text_.substr(at_, left - at_);
            while (!target.empty() && is_space(target.back())) target.pop_back();
            if (target.empty()) return;
            const std::size_t to = language_ == Language::cpp ? comma(from) : end_;
            if (to == npos) return;
            found_.push_back({from, to, target, block_});
            if (to == end_) return;
            at_ = to + 1;   // "a = b, c = d"
            skip_space();
            i = at_;
        }
    }
    /// The first comma from `at` on that ends an expression, or the end; npos if it may be one between
    /// arguments of a template.
    std::size_t comma(std::size_t at) const {
        int depth = 0;
        bool has_template = false;
        for (std::size_t i = at; i < end_; ++i) {
            const char c = text_[i];
            if (c == '(' || c == '[') ++depth;
            if (c == ')' || c == ']') --depth;
            has_template |= depth == 0 && c == '<' && is_word(text_[i - 1]);
            if (depth == 0 && c == ',') return has_template ? npos : i;
        }
        return end_;
    }

    const std::string& text_;
    std::size_t at_, end_;
    Language language_;
    std::size_t& block_;
    std::vector<Region>& found_;
};

}   // namespace

std::size_t behind_bracket(const std::string& text, std::size_t at) {
    int depth = 0;
    for (std::size_t i = at; i < text.size(); ++i) {
        if (text[i] == '(' || text[i] == '[' || text[i] == '{') ++depth;
        if (text[i] == ')' || text[i] == ']' || text[i] == '}') --depth;
        if (depth == 0) return i + 1;
    }
    return npos;
}

std::string blanked(const std::string& text, Language language) {
    std::string out = text;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto end_of_line = [&] { return std::min(out.find('\n', i), out.size()); };
        if (out.compare(i, 2, "//") == 0)
            blank(out, i, end_of_line());
        else if (out.compare(i, 2, "/*") == 0)
            blank(out, i, std::min(out.find("*/", i), out.size()) + 2);
        else if (out[i] == '"') {
            const std::size_t to = out.find('"', i + 1);
            blank(out, i, to == npos ? out.size() : to + 1);
        } else if (language == Language::cpp && out[i] == '#') {
            blank(out, i, end_of_line());
        } else if (language == Language::verilog && out[i] == '`') {
            const bool hidden = out.compare(i, 7, "`ifndef") == 0 || out.compare(i, 6, "`ifdef") == 0;
            blank(out, i, hidden ? out.find("`endif", i) + 6 : end_of_line());
        }
    }
    return out;
}

std::vector<Region> regions(const std::string& text, Language language) {
    const std::string plain = blanked(text, language);
    std::vector<Region> found;
    std::size_t begin = 0, block = 0;
    int depth = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const char c = plain[i];
        if (language == Language::verilog) {
            if (c == '(' || c == '[' || c == '{') ++depth;
            if (c == ')' || c == ']' || c == '}') --depth;
            if (c != ';' || depth > 0) continue;
        } else if (c != ';' && c != '{' && c != '}') {
            continue;
        }
        if (language == Language::cpp) block = begin;
        Chunk(plain, begin, i, language, block, found).read();
        begin = i + 1;
    }
    return found;
}

}   // namespace rayclock::campaign
