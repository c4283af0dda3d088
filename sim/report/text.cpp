#include "sim/report/text.hpp"

#include <chrono>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "sim/files/output.hpp"
#include "sim/files/streams.hpp"

namespace rayclock {

Progress terminal_progress() {
    if (!isatty(STDERR_FILENO)) return {};
    using Clock = std::chrono::steady_clock;
    struct State {
        std::string what;
        Clock::time_point start, drawn;
    };
    const auto state = std::make_shared<State>();
    return [state](std::string_view what, std::uint64_t done, std::uint64_t total) {
        const auto now = Clock::now();
        if (const std::string_view work = what.substr(0, what.find(',')); state->what != work)
            *state = {std::string(work), now, {}};
        const bool end = done >= total;
        if (!end && now - state->drawn < std::chrono::milliseconds(100)) return;
        state->drawn = now;
        const double seconds = std::chrono::duration<double>(now - state->start).count();
        if (end) {
            std::fprintf(stderr, "\r\033[K");
        } else {
            const double share = total ? double(done) / double(total) : 0;
            std::fprintf(stderr, "\r\033[K%.*s: %3.0f %%, %.0f s left", int(what.size()), what.data(),
                         share * 100, done ? seconds * (1 - share) / share : 0.0);
        }
        std::fflush(stderr);
    };
}

void write_file(const std::string& path, const std::string& text) {
    if (path == "-") {
        write_output(text);   // main() sees whether it arrives
        return;
    }
    write_bytes(path, text);
}

}   // namespace rayclock
