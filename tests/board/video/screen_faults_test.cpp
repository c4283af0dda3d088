// The screen's judgement: a sound signal passes, and each fault gives its sentence.
#include <bit>
#include <functional>
#include <string>

#include "sim/board/screen.hpp"
#include "tests/support/cases/draw.hpp"
#include <catch2/catch.hpp>

namespace screen_faults_test {

using namespace rayclock;

const ScreenMode mode{12, 3, 5, 4, 7, 2, 2, 3};

/// What a source sends in a pixel clock.
struct Sent {
    bool de = false, h = true, v = true;
    ScreenPicture::Pixel pixel{};
};
using Source = std::vector<Sent>;

/// Some frames, each from the end of its picture. The vertical sync changes with the horizontal one.
Source sound(int frames) {
    Source signal;
    bool v = false;   // in the vertical sync
    test::Draw draw{3};
    for (int frame = 0; frame < frames; ++frame)
        for (std::uint32_t i = 0; i < mode.total_height(); ++i)
            for (std::uint32_t x = 0; x < mode.total_width(); ++x) {
                const std::uint32_t y = (i + mode.height) % mode.total_height();
                const std::uint32_t h_at = mode.width + mode.h_front, v_at = mode.height + mode.v_front - 1;
                const bool h = x >= h_at && x < h_at + mode.h_sync;
                if (x == h_at) v = y >= v_at && y < v_at + mode.v_sync;
                Sent sent{x < mode.width && y < mode.height, !h, !v, {}};
                if (sent.de)
                    for (std::uint8_t& byte : sent.pixel) byte = std::uint8_t(draw.bits(8));
                signal.push_back(sent);
            }
    return signal;
}

/// The encoder as the flow chart of DVI 1.0 (figure 3-5) writes it.
std::uint16_t encode(std::uint8_t d, int& count) {
    const int ones = std::popcount(d);
    const bool by_xnor = ones > 4 || (ones == 4 && !(d & 1));
    unsigned q = d & 1;
    for (int i = 1; i < 8; ++i) q |= unsigned((q >> (i - 1) ^ d >> i ^ int(by_xnor)) & 1) << i;
    const int n1 = std::popcount(q), n0 = 8 - n1;
    const unsigned q8 = by_xnor ? 0 : 1;
    const auto symbol = [&](unsigned q9) { return std::uint16_t(q9 << 9 | q8 << 8 | (q9 ? ~q & 0xff : q)); };
    if (count == 0 || n1 == n0) {
        count += q8 ? n1 - n0 : n0 - n1;
        return symbol(1 - q8);
    }
    if ((count > 0) == (n1 > n0)) {
        count += 2 * int(q8) + n0 - n1;
        return symbol(1);
    }
    count += n1 - n0 - 2 * int(1 - q8);
    return symbol(0);
}

std::vector<TmdsSymbols> encoded(const Source& signal) {
    constexpr std::array<std::uint16_t, 4> controls{0x354, 0x0ab, 0x154, 0x2ab};
    std::vector<TmdsSymbols> all;
    std::array<int, 3> counts{};
    for (const Sent& sent : signal) {
        if (!sent.de) {
            counts = {};
            all.push_back({controls[std::size_t(2 * sent.v + sent.h)], controls[0], controls[0]});
            continue;
        }
        TmdsSymbols symbols;
        for (std::size_t i = 0; i < 3; ++i) symbols[i] = encode(sent.pixel[2 - i], counts[i]);
        all.push_back(symbols);
    }
    return all;
}

std::vector<std::string> judged(const std::vector<TmdsSymbols>& symbols) {
    Screen screen(mode);
    for (const TmdsSymbols& s : symbols) screen.symbols(s);
    return screen.errors();
}

std::size_t at(std::uint32_t frame, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t line = (y + mode.total_height() - mode.height) % mode.total_height();
    return std::size_t(frame * mode.total_height() + line) * mode.total_width() + x;
}

/// The bits of a cable, in pairs: each channel begins `skip` bits late.
std::vector<std::uint32_t> cable(const std::vector<TmdsSymbols>& symbols, std::array<std::size_t, 4> skip) {
    std::array<std::vector<bool>, 4> bits;
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t i = 0; i < skip[c]; ++i) bits[c].push_back(c != 3 && i & 1);
        for (const TmdsSymbols& s : symbols)
            for (int i = 0; i < 10; ++i) bits[c].push_back((c == 3 ? 0x1f : s[c]) >> i & 1);
        bits[c].resize(symbols.size() * 10);
    }
    std::vector<std::uint32_t> pairs;
    for (std::size_t i = 0; i < bits[0].size(); i += 2) {
        std::uint32_t pair = 0;
        for (std::size_t c = 0; c < 4; ++c)
            pair |= (std::uint32_t(bits[c][i]) | std::uint32_t(bits[c][i + 1]) << 1) << (2 * c);
        pairs.push_back(pair);
    }
    return pairs;
}

TEST_CASE("the screen shows a sound signal without a complaint", "[board][judge]") {
    const Source signal = sound(4);
    Screen screen(mode);
    for (const TmdsSymbols& s : encoded(signal)) screen.symbols(s);
    REQUIRE(screen.errors() == std::vector<std::string>{});
    REQUIRE(screen.frames() == 3);   // between four vertical syncs
    for (std::uint32_t y = 0; y < mode.height; ++y)
        for (std::uint32_t x = 0; x < mode.width; ++x)
            REQUIRE(screen.picture().at(x, y) == signal[at(2, x, y)].pixel);
}

TEST_CASE("the screen reports each fault of timing", "[board][judge]") {
    struct Fault {
        const char* expected;
        std::function<void(Source&)> make;
    };
    const auto line = [](Source& s, std::uint32_t y) { return s.begin() + std::ptrdiff_t(at(2, 0, y)); };
    const auto levels = [&](Source& s, std::uint32_t y, std::uint32_t from, std::uint32_t to, bool h) {
        for (std::uint32_t x = from; x < to; ++x) (line(s, y) + x)->h = h;
    };
    const Fault faults[] = {
        {"the line has 25 pixel clocks, not 24", [&](Source& s) { s.insert(line(s, 2) + 14, Sent{}); }},
        {"the line has 23 pixel clocks, not 24", [&](Source& s) { s.erase(line(s, 2) + 14); }},
        {"the horizontal sync has 4 pixel clocks, not 5", [&](Source& s) { levels(s, 2, 19, 20, true); }},
        {"the horizontal sync has 6 pixel clocks, not 5", [&](Source& s) { levels(s, 2, 20, 21, false); }},
        {"the back porch has 3 pixel clocks, not 4", [&](Source& s) { (line(s, 2) - 1)->de = true; }},
        {"the picture has 11 pixel clocks, not 12", [&](Source& s) { (line(s, 2) + 11)->de = false; }},
        {"the front porch has 4 pixel clocks, not 3", [&](Source& s) { (line(s, 2) + 11)->de = false; }},
        {"the pixels of the line have a gap", [&](Source& s) { (line(s, 2) + 5)->de = false; }},
        {"the line has no pixels",
         [&](Source& s) {
             for (std::uint32_t x = 0; x < 12; ++x) (line(s, 2) + x)->de = false;
         }},
        {"the line has unexpected pixels",
         [&](Source& s) {
             for (std::uint32_t x = 0; x < 12; ++x) (line(s, 8) + x)->de = true;
         }},
        {"has 13 lines, not 14", [&](Source& s) { s.erase(line(s, 7), line(s, 8)); }},
        {"the vertical sync has 3 lines, not 2",
         [&](Source& s) {
             for (std::uint32_t x = 0; x < 24; ++x) (line(s, 10) + 15 + x)->v = false;
         }},
        {"the vertical sync changes 1 pixel clocks after", [&](Source& s) { (line(s, 8) + 15)->v = true; }},
    };
    for (const Fault& fault : faults) {
        Source signal = sound(5);
        fault.make(signal);
        const std::vector<std::string> errors = judged(encoded(signal));
        CAPTURE(fault.expected, errors);
        REQUIRE(std::ranges::any_of(errors, [&](const std::string& e) {
            return e.find(fault.expected) != e.npos && e.find("before") == e.npos;
        }));
    }
    // Positive syncs.
    Source inverted = sound(3);
    for (Sent& sent : inverted) sent.h = !sent.h;
    std::string complaints;
    for (const std::string& error : judged(encoded(inverted))) complaints += error;
    REQUIRE(complaints.find("the horizontal sync has 19 pixel clocks, not 5") != std::string::npos);
}

TEST_CASE("the screen reports symbols that DVI does not prescribe", "[board][judge]") {
    const std::vector<TmdsSymbols> good = encoded(sound(3));
    const std::size_t place = at(2, 6, 3);
    const auto first_error = [&](std::size_t channel, std::uint16_t symbol) {
        std::vector<TmdsSymbols> symbols = good;
        symbols[place][channel] = symbol;
        const std::vector<std::string> errors = judged(symbols);
        return errors.empty() ? std::string() : errors[0];
    };
    // Any change of a symbol is a rule broken, another byte, or another symbol later.
    const std::uint16_t sent = good[place][1];
    int byte_errors = 0, balance_errors = 0;
    for (int i = 0; i < 10; ++i) {
        const std::string error = first_error(1, std::uint16_t(sent ^ 1 << i));
        byte_errors += error.find("has the wrong bit 8") != error.npos;
        balance_errors += error.find("increases the disparity") != error.npos;
    }
    REQUIRE(byte_errors > 0);
    REQUIRE(balance_errors > 0);
    REQUIRE(first_error(1, std::uint16_t(sent ^ 0x2ff)).find("green symbol") != std::string::npos);
    REQUIRE(first_error(2, 0x354).find("the channels disagree about the blank") != std::string::npos);
    std::vector<TmdsSymbols> controls = good;
    controls[at(2, 20, 3)][2] = 0x0ab;
    REQUIRE(judged(controls).at(0).find("the control bits of green and red are 0 and 1") !=
            std::string::npos);
}

TEST_CASE("the receiver finds symbols at any alignment of each channel", "[board][judge]") {
    const std::vector<TmdsSymbols> symbols = encoded(sound(4));
    for (std::size_t skip = 0; skip < 10; ++skip)
        for (std::size_t skew = 0; skew < 3; ++skew) {
            CAPTURE(skip, skew);
            Screen screen(mode);
            TmdsReceiver receiver(screen);
            for (const std::uint32_t pair : cable(symbols, {skip, skip + skew, skip + 2 * skew, 3}))
                receiver.pairs(pair);
            REQUIRE(receiver.is_aligned());
            REQUIRE(receiver.errors() == std::vector<std::string>{});
            REQUIRE(screen.errors() == std::vector<std::string>{});
            REQUIRE(screen.frames() >= 2);
        }
}

TEST_CASE("the receiver reports a lost bit and a wrong clock", "[board][judge]") {
    const std::vector<TmdsSymbols> symbols = encoded(sound(8));
    std::vector<std::uint32_t> pairs = cable(symbols, {0, 0, 0, 0});
    const auto errors = [&] {
        Screen screen(mode);
        TmdsReceiver receiver(screen);
        for (const std::uint32_t pair : pairs) receiver.pairs(pair);
        return receiver.errors();
    };
    REQUIRE(errors().empty());
    pairs[2000] ^= 0x80;
    REQUIRE(errors().at(0).find("the clock has a period of") != std::string::npos);
    pairs[2000] ^= 0x80;
    pairs.erase(pairs.begin() + 5000);
    bool lost = false;
    for (const std::string& error : errors()) lost |= error.find("has lost its alignment") != error.npos;
    REQUIRE(lost);
}

}   // namespace screen_faults_test
