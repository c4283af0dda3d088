// Letters as strokes, so that pictures have text on a machine without fonts.
#include <algorithm>

#include "sim/plot/drawing.hpp"

namespace rayclock::plot {

namespace {

// From ' ' to '~'. A letter is a list of strokes with a blank between them, a stroke a list of points of two digits: x from 0,
// y from 0 (top of capitals) over 2 (top of small letters) and 7 (baseline) to 9. One point is a dot.
constexpr const char* letters[] = {
    "", "0005 0707", "0002 2022", "1016 3036 0242 0444", "413010010213334446371706 2028", "0740 0010110100 3646473736", "47130110203103 0517 2745",
    "0002", "20020628", "00222608", "2125 0343 0543", "0444 2226", "1709", "0434", "0707", "0740",
    "103041463717060110", "022027 0747", "01103041420747", "01103041423313 334446371706", "37300545", "400003334446371706",
    "413010010617374644331304", "004017", "1302011030414233 133344463717060413", "061737464130100103143443",
    "0303 0707", "0303 1709", "420446", "0343 0545", "024406", "01103041422325 2727", "432325354541301001061737",
    "072047 1434", "003041423303 334446370700", "4130100106173746", "00304146370700", "40000747 0333", "400007 0333", "41301001061737464424",
    "0007 4047 0343", "0020 1017 0727", "4046371706", "0007 4004 1347", "000747", "0700244047", "07004740", "104051564717060110",
    "07003041433404", "104051564717060110 3557", "07003041433404 2447", "413010010213334446371706", "0040 2027", "000617374640", "002740",
    "0017233740", "0047 4007", "002340 2327", "00400747", "20000828", "0047", "00202808", "022042", "0848", "0011",
    "0312324347 44140506173746", "0007 0312324346371706", "4332120306173746", "4047 4332120306173746", "05454332120306173746", "30201117 0232",
    "4248391908 4332120306173746", "0007 0312324347", "0207 0000", "121809 1010", "0007 3205 1437", "000617", "0207 03122327 23324347",
    "0207 0312324347", "123243463717060312", "0209 0312324346371706", "4249 4332120306173746", "0207 031232", "43321203143546371706",
    "10162737 0232", "0206173746 4247", "022742", "0217243742", "0247 4207", "0227 4219", "02420747",
    "2011131405162728", "0008", "0011131425161708", "0413243544",
};

constexpr double cap = 7, gap = 1.7, blank = 2.5;

/// Strokes of a letter in its own units, and its right end.
struct Letter {
    std::vector<std::vector<Place>> strokes;
    double width = 0;
};
Letter letter_of(char c) {
    Letter letter;
    if (c < ' ' || c > '~') c = '?';
    if (c == ' ') return {{}, blank - gap};
    const std::string code = letters[c - ' '];
    std::string digits;
    letter.strokes.emplace_back();
    for (const char d : code + " ") {
        if (d == ' ' && digits.empty() && !letter.strokes.back().empty()) letter.strokes.emplace_back();
        if (d != ' ') digits += d;
        if (digits.size() == 2) {
            letter.strokes.back().push_back({double(digits[0] - '0'), double(digits[1] - '0')});
            letter.width = std::max(letter.width, double(digits[0] - '0'));
            digits.clear();
        }
    }
    letter.strokes.pop_back();
    return letter;
}

double unit(double size) { return size * 0.72 / cap; }

} // namespace

double pen_width(double size) { return size * 0.095; }

double text_width(const std::string& text, double size) {
    double width = text.empty() ? 0 : -gap;
    for (const char c : text) width += letter_of(c).width + gap;
    return width * unit(size);
}

std::vector<std::vector<Place>> strokes_of(const Text& text) {
    const double scale = unit(text.size), width = text_width(text.text, text.size);
    double at = text.anchor == Anchor::start ? 0 : text.anchor == Anchor::middle ? -width / 2 : -width;
    std::vector<std::vector<Place>> strokes;
    for (const char c : text.text) {
        const Letter letter = letter_of(c);
        for (const auto& stroke : letter.strokes) {
            strokes.emplace_back();
            for (const Place& p : stroke) {
                const double along = at + p.x * scale, up = (cap - p.y) * scale;
                strokes.back().push_back(text.upright ? Place{text.base.x - up, text.base.y - along} : Place{text.base.x + along, text.base.y - up});
            }
        }
        at += (letter.width + gap) * scale;
    }
    return strokes;
}

} // namespace rayclock::plot
