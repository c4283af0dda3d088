// Draws the progress of long work on a terminal and writes text files.
#include "sim/view/report/text.hpp"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "sim/files/output.hpp"
#include "sim/files/streams.hpp"
#include "sim/view/report/terminal_line.hpp"

namespace rayclock {

namespace {

/// The progress of current work. It redraws on every report, and a thread of its own redraws once a second.
/// The thread is needed because one step can take long and some work reports no progress.
class WorkLine {
public:
    WorkLine() : ticker_([this] { tick(); }) {}
    ~WorkLine() {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        wake_.notify_one();
        ticker_.join();
        if (shown_) wipe_line();
    }
    WorkLine(const WorkLine&) = delete;

    void show(std::string_view what, std::uint64_t done, std::uint64_t total) {
        const Clock::time_point now = Clock::now();
        const std::lock_guard lock(mutex_);
        if (const std::string_view work = what.substr(0, what.find(',')); work_ != work)
            work_ = work, start_ = now, drawn_ = {};
        else if (!is_under_way_ && done < total)   // the same work starts again
            start_ = now;
        is_under_way_ = done < total;
        if (!is_under_way_) {
            wipe_line();
            shown_ = false;
            start_ = now;   // the start of work that reports no progress
        } else if (now - drawn_ >= std::chrono::milliseconds(100)) {
            what_ = what;
            share_ = double(done) / double(total);
            draw(now);
        }
    }

private:
    using Clock = std::chrono::steady_clock;

    void draw(Clock::time_point now) {
        const double seconds = std::chrono::duration<double>(now - start_).count();
        if (!is_under_way_)
            draw_line(
                fmt::format("{}: {:.0f} s so far", work_.empty() ? "preparing" : "after " + work_, seconds));
        else
            draw_line(share_ > 0 ? fmt::format("{}: {:3.0f} %, {:.0f} s left", what_, share_ * 100,
                                               seconds * (1 - share_) / share_)
                                 : fmt::format("{}: {:.0f} s so far", what_, seconds));
        drawn_ = now;
        shown_ = true;
    }

    void tick() {
        constexpr double silence = 0.95;   // in seconds; RTL builds draw the same line
        std::unique_lock lock(mutex_);
        while (!wake_.wait_for(lock, std::chrono::seconds(1), [&] { return ended_; }))
            if (seconds_since_line() > silence) draw(Clock::now());
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::string work_, what_;
    double share_ = 0;
    Clock::time_point start_ = Clock::now(), drawn_;
    bool is_under_way_ = false, shown_ = false, ended_ = false;
    std::thread ticker_;   // declared last because it uses the other members
};

}   // namespace

Progress terminal_progress() {
    if (!isatty(STDERR_FILENO)) return {};
    return [line = std::make_shared<WorkLine>()](std::string_view what, std::uint64_t done,
                                                 std::uint64_t total) { line->show(what, done, total); };
}

void write_file(const std::string& path, const std::string& text) {
    if (path == "-") {
        write_output(text);   // main() checks for write errors
        return;
    }
    write_bytes(path, text);
}

}   // namespace rayclock
