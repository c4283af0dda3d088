// Judges a fault by the torture set.
#include "tests/meta/campaign/judge.hpp"

#include <csignal>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rayclock::campaign {

namespace {

std::string seen(const TortureCase& torture, const LockstepResult& result) {
    return torture.name +
           (result.first ? fmt::format(": {} {}", result.first->unit, result.first->link) : ": counters");
}

}   // namespace

TortureJudge::TortureJudge(const std::vector<std::string>& chips, bool records) {
    for (const std::string& chip : chips)
        for (TortureCase& torture : torture_cases(chip)) {
            cases_.push_back({std::move(torture), {}});
            Prepared& p = cases_.back();
            if (records) p.frames = record_torture(p.torture);
        }
}

Verdict TortureJudge::operator()(int seconds_at_most) const {
    return in_child(
        [this](std::string& by) {
            for (const Prepared& p : cases_) {
                by = p.torture.name;
                const LockstepResult result =
                    run_lockstep(p.torture.job, p.frames, p.torture.disturbance, {}, p.torture.seed);
                if (result.agrees()) continue;
                by = seen(p.torture, result);
                return true;
            }
            return false;
        },
        seconds_at_most);
}

Verdict TortureJudge::with_fault(int number, int seconds_at_most) const {
    return in_child(
        [this, number](std::string& by) {
            rc_fault = number;
            for (const Prepared& p : cases_) {
                by = p.torture.name;
                const LockstepResult result = run_torture(p.torture);
                if (result.agrees()) continue;
                by = seen(p.torture, result);
                return true;
            }
            return false;
        },
        seconds_at_most);
}

Verdict in_child(const std::function<bool(std::string&)>& work, int seconds_at_most) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, 1);
        dup2(nowhere, 2);
        // Of the processor, so that a busy machine changes no verdict.
        const rlimit limit{rlim_t(seconds_at_most), rlim_t(seconds_at_most)};
        setrlimit(RLIMIT_CPU, &limit);
        std::string by;
        bool noticed = true;
        try {
            noticed = work(by);
        } catch (const std::exception& e) {
            by += std::string(": ") + e.what();
        }
        const std::string said = by.substr(0, 200);
        [[maybe_unused]] const auto written = write(ends[1], said.data(), said.size());
        _exit(noticed ? 1 : 0);
    }
    close(ends[1]);
    Verdict verdict;
    char part[256];
    for (ssize_t n; (n = read(ends[0], part, sizeof part)) > 0;) verdict.by.append(part, std::size_t(n));
    close(ends[0]);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    verdict.noticed = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        verdict.by =
            signal == SIGXCPU || signal == SIGKILL ? "it does not end" : fmt::format("signal {}", signal);
    }
    for (const timeval& part : {used.ru_utime, used.ru_stime})
        verdict.seconds += double(part.tv_sec) + double(part.tv_usec) * 1e-6;
    return verdict;
}

}   // namespace rayclock::campaign
