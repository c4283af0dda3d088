// Lists every fault that can be planted in a source.
#include "tests/meta/campaign/faults.hpp"

#include <array>
#include <cctype>
#include <string_view>

namespace rayclock::campaign {

namespace {

constexpr auto npos = std::string::npos;

class Operators {
public:
    Operators(std::string text, const Region& region, Language language)
        : text_(std::move(text)), region_(region), language_(language) {}

    std::vector<Fault> all() {
        tokens();
        numbers();
        negations();
        conjuncts();
        choices();
        if (region_.is_condition && text_.find("rst_ni") != npos) add("removed reset", "1'b0", "reset");
        const bool varies = text_.size() > 4;   // '0 and 1'b1 have no bit to lose, and are never late
        if (!region_.target.empty() && varies) widths();
        if (language_ == Language::verilog && !region_.target.empty() && varies && region_.outside != npos)
            found_.push_back({"latched late", "", region_.target, true});
        return std::move(found_);
    }

private:
    void add(const char* what, std::string text, std::string shown) {
        found_.push_back({what, std::move(text), std::move(shown)});
    }
    void replace(const char* what, std::size_t at, std::size_t size, const std::string& fresh) {
        std::string text = text_;
        add(what, text.replace(at, size, fresh),
            "'" + text_.substr(at, size) + "' -> '" + fresh + "' in " + around(at));
    }
    std::string around(std::size_t at) const {
        std::string part = text_.substr(at > 20 ? at - 20 : 0, 45);
        for (char& c : part)
            if (c == '\n') c = ' ';
        return part;
    }

    void tokens() {
        struct Swap {
            const char *what, *from, *to;
        };
        static constexpr std::array<Swap, 12> swaps{{{"comparison", " < ", " <= "},
                                                     {"comparison", " <= ", " < "},
                                                     {"comparison", " > ", " >= "},
                                                     {"comparison", " >= ", " > "},
                                                     {"comparison", " == ", " != "},
                                                     {"comparison", " != ", " == "},
                                                     {"swapped operator", " + ", " - "},
                                                     {"swapped operator", " - ", " + "},
                                                     {"swapped operator", " && ", " || "},
                                                     {"swapped operator", " || ", " && "},
                                                     {"swapped operator", " & ", " | "},
                                                     {"swapped operator", " ^ ", " | "}}};
        for (const Swap& swap : swaps)
            for (std::size_t at = text_.find(swap.from); at != npos; at = text_.find(swap.from, at + 1))
                replace(swap.what, at, std::string_view(swap.from).size(), swap.to);
    }
    void numbers() {
        for (std::size_t i = 0; i < text_.size(); ++i) {
            const auto digit = [&](std::size_t k) {
                return k < text_.size() && std::isdigit(static_cast<unsigned char>(text_[k]));
            };
            const auto part_of_word = [&](std::size_t k) {
                return std::isalnum(static_cast<unsigned char>(text_[k])) || text_[k] == '_' ||
                       text_[k] == '\'' || text_[k] == '.';
            };
            if (!digit(i) || (i > 0 && part_of_word(i - 1))) continue;
            std::size_t to = i;
            while (digit(to)) ++to;
            if (text_.compare(to, 3, "'b1") == 0 || text_.compare(to, 3, "'b0") == 0) {
                replace("off by one", to + 2, 1, text_[to + 2] == '1' ? "0" : "1");
            } else if (text_.compare(to, 2, "'d") == 0 && digit(to + 2)) {
                replace("off by one", to + 2, 1,
                        text_[to + 2] == '0' ? "1" : std::string(1, char(text_[to + 2] - 1)));
            } else if (to >= text_.size() || !(part_of_word(to))) {
                const int value = std::stoi(text_.substr(i, std::min<std::size_t>(to - i, 8)));
                replace("off by one", i, to - i, std::to_string(value + 1));
                if (value > 0) replace("off by one", i, to - i, std::to_string(value - 1));
            }
            i = to;
        }
    }
    void negations() {
        for (std::size_t at = text_.find('!'); at != npos; at = text_.find('!', at + 1))
            if (at + 1 < text_.size() && text_[at + 1] != '=') replace("dropped condition", at, 1, " ");
    }
    /// a && b && c without one of them; the same with ||.
    void conjuncts() {
        for (const std::string_view link : {" && ", " || "}) {
            std::vector<std::size_t> cuts;
            int depth = 0;
            for (std::size_t i = 0; i + 4 <= text_.size(); ++i) {
                if (text_[i] == '(' || text_[i] == '[' || text_[i] == '{') ++depth;
                if (text_[i] == ')' || text_[i] == ']' || text_[i] == '}') --depth;
                if (depth == 0 && (text_[i] == '?' || (link == " && " && text_.compare(i, 4, " || ") == 0)))
                    return;
                if (depth == 0 && text_.compare(i, 4, link) == 0) cuts.push_back(i);
            }
            for (std::size_t k = 0; k <= cuts.size() && !cuts.empty(); ++k) {
                const std::size_t from = k == 0 ? 0 : cuts[k - 1], to = k == cuts.size() ? text_.size()
                                                                        : k == 0         ? cuts[0] + 4
                                                                                         : cuts[k];
                std::string text = text_;
                add("dropped condition", text.erase(from, to - from),
                    "without '" + text_.substr(from, std::min<std::size_t>(to - from, 50)) + "'");
            }
        }
    }
    /// c ? b : a for c ? a : b.
    void choices() {
        int depth = 0, open = 0;
        std::size_t question = npos, colon = npos;
        for (std::size_t i = 0; i < text_.size() && colon == npos; ++i) {
            const char c = text_[i];
            if (c == '(' || c == '[' || c == '{') ++depth;
            if (c == ')' || c == ']' || c == '}') --depth;
            if (depth != 0) continue;
            if (c == '?') {
                if (question == npos)
                    question = i;
                else
                    ++open;
            }
            if (c == ':' && question != npos && text_.compare(i, 2, "::") != 0 && text_[i - 1] != ':' &&
                open-- == 0)
                colon = i;
        }
        if (colon == npos) return;
        add("swapped operand",
            text_.substr(0, question + 1) + " (" + text_.substr(colon + 1) + ") : (" +
                text_.substr(question + 1, colon - question - 1) + ")",
            "both answers of " + around(question));
    }
    void widths() {
        if (language_ == Language::verilog)
            add("shortened width", "$signed((" + text_ + ") & ({$bits(" + region_.target + "){1'b1}} >> 1))",
                "top bit of " + region_.target);
        else if (text_.find_first_of("+-*>") != npos)
            add("shortened width", "((" + text_ + ") >> 1 << 1)", "lowest bit of " + region_.target);
    }

    std::string text_;
    const Region& region_;
    Language language_;
    std::vector<Fault> found_;
};

}   // namespace

std::vector<Fault> faults(const std::string& plain, const Region& region, Language language) {
    return Operators(plain.substr(region.begin, region.end - region.begin), region, language).all();
}

}   // namespace rayclock::campaign
