#pragma once
// Builds the RTL that tests load before any of them runs: two modules at a time, with a line for each.
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <vector>

#include "sim/run/rtl/builder.hpp"
#include "sim/files/process/parallel.hpp"

namespace rayclock::test {

struct RtlJob {
    std::string module, name;   ///< name of the configuration, for the reader
    Config config;
};

/// Builds the missing modules. Throws the first failure after all were tried.
inline void build_all(const std::vector<RtlJob>& jobs) {
    std::mutex mutex;
    std::exception_ptr failed;
    std::size_t done = 0, kept = 0;
    parallel::for_each(jobs.size(), 2, [&](std::size_t i) {
        const RtlJob& job = jobs[i];
        RtlBuild build;
        std::exception_ptr error;
        try {
            build = build_rtl(job.config, job.module);
        } catch (...) {
            error = std::current_exception();
        }
        const std::lock_guard lock(mutex);
        ++done;
        if (!failed) failed = error;
        if (build.was_cached) {
            ++kept;
        } else {
            std::printf("RTL module %zu of %zu: %s, %s: ", done, jobs.size(), job.module.c_str(),
                        job.name.c_str());
            if (error)
                std::printf("FAILED\n");
            else
                std::printf("built in %.0f s\n", build.seconds);
            std::fflush(stdout);
        }
    });
    if (kept > 0) std::printf("%zu of %zu RTL modules were there before\n", kept, jobs.size());
    std::fflush(stdout);
    if (failed) std::rethrow_exception(failed);
}

}   // namespace rayclock::test
