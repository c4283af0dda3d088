// Every second mutation replaces a number in the text by another. So an input that was found stays valid
// except for one value. The others are libFuzzer's own: after a hundred of these a JSON text can hardly ever
// be parsed.
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Random = std::minstd_rand;

std::vector<std::string_view> numbers(std::string_view text) {
    std::vector<std::string_view> found;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t start = at;
        while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]))) ++at;
        if (at > start)
            found.push_back(text.substr(start, at - start));
        else
            ++at;
    }
    return found;
}

std::string another(std::string_view number, const std::vector<std::string_view>& all, Random& random) {
    constexpr std::array<const char*, 10> special{"0",   "-1",    "1e38",       "1e-30",     "0.5",
                                                  "255", "65536", "4294967295", "999999999", "1e999"};
    const std::uint64_t value = number.size() < 18 ? std::stoull(std::string(number)) : 0;
    switch (random() % 6) {
        case 0: return std::to_string(value + 1);
        case 1: return value == 0 ? "-1" : std::to_string(value - 1);
        case 2: return std::to_string(2 * value);
        case 3: return std::string(number) + std::to_string(random() % 1000);
        case 4: return std::string(all[random() % all.size()]);
        default: return special[random() % special.size()];
    }
}

}   // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    Random random(seed);
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::vector<std::string_view> all = numbers(text);
    if (random() % 2 == 0 || all.empty()) return LLVMFuzzerMutate(data, size, most);
    const std::string_view old = all[random() % all.size()];
    std::string changed(text);
    changed.replace(static_cast<std::size_t>(old.data() - text.data()), old.size(),
                    another(old, all, random));
    if (changed.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, changed.data(), changed.size());
    return changed.size();
}
