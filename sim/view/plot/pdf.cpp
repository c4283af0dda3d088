// Converts SVG to PDF with librsvg's program.
#include "sim/view/plot/pdf.hpp"

#include <chrono>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/process/stopping.hpp"

namespace rayclock::plot {

namespace {

/// An anonymous file in memory that other programs open by its path.
class NamelessFile {
public:
    explicit NamelessFile(std::string_view text = {}) : file_(memfd_create("plot", MFD_CLOEXEC)) {
        bool whole = file_ >= 0;
        while (whole && !text.empty()) {
            const ssize_t put = write(file_, text.data(), text.size());
            whole = put > 0;
            if (whole) text.remove_prefix(std::size_t(put));
        }
        if (!whole) throw UserError("not enough memory for a plot");
    }
    ~NamelessFile() { close(file_); }
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;

    std::string path() const { return fmt::format("/proc/{}/fd/{}", getpid(), file_); }
    std::string text() const {
        std::string all;
        char block[4096];
        for (ssize_t got = 0; (got = pread(file_, block, sizeof block, off_t(all.size()))) > 0;)
            all.append(block, std::size_t(got));
        return all;
    }

private:
    int file_;
};

}   // namespace

void check_pdf(const std::string& path) {
    if (find_program(pdf_program).empty())
        throw UserError(fmt::format(
            "{}: a PDF needs the program {} (Debian's package librsvg2-bin), which is not installed; a name "
            "that ends in .svg needs none",
            shown(path), pdf_program));
}

std::string pdf(const std::string& svg) {
    const NamelessFile in(svg), out;
    // A constant date, so that the same plot has the same bytes.
    Process process({{"env", "SOURCE_DATE_EPOCH=0", pdf_program, "-f", "pdf", "-o", out.path(), in.path()},
                     {},
                     "/dev/null",
                     {}});
    while (!process.ended()) {
        stop_if_interrupted();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    std::string bytes = process.code() == 0 ? out.text() : "";
    if (!bytes.starts_with("%PDF"))
        throw std::runtime_error(fmt::format("{} has made no PDF of a plot", pdf_program));
    return bytes;
}

}   // namespace rayclock::plot
