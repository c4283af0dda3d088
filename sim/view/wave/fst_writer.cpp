// Writes FST files with fstapi, and reports full disks.
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <gtkwave/fstapi.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/input.hpp"
#include "sim/files/scratch.hpp"
#include "sim/view/wave/fst.hpp"

extern "C" int rc_fst_error;   // sim/view/wave/fst_io.h

namespace rayclock {

namespace {

constexpr int nanoseconds = -9;

[[noreturn]] void not_written(const std::string& path, int error) {
    throw UserError(fmt::format("{}: the waveform cannot be written: {}", printable(path),
                                std::strerror(error ? error : EIO)));
}

}   // namespace

/// The temporary file that GTKWave's writer needs. The writer puts further files next to it.
struct FstWriter::File {
    TemporaryFolder folder{"rayclock-wave"};
    std::string path = folder.path() / "wave.fst";
    void* writer = create(path);
    struct Known {
        int width;   ///< 0: text
        std::string value;
    };
    std::vector<Known> signals;   // [handle - 1]

    static void* create(const std::string& path) {
        errno = rc_fst_error = 0;
        void* const made = fstWriterCreate(path.c_str(), 1);
        if (!made) not_written(path, errno);
        return made;
    }

    fstHandle add(const std::string& name, fstVarType type, int width, fstHandle alias) {
        const fstHandle handle =
            fstWriterCreateVar(writer, type, FST_VD_IMPLICIT, std::uint32_t(width), name.c_str(), alias);
        if (handle > signals.size()) signals.push_back({width, {}});
        return handle;
    }
    bool changes(Signal signal, std::string_view value) {
        std::string& known = signals[signal - 1].value;
        if (known == value) return false;
        known = value;
        return true;
    }
};

FstWriter::FstWriter() : file_(std::make_unique<File>()) {
    fstWriterSetPackType(file_->writer, FST_WR_PT_LZ4);
    fstWriterSetTimescale(file_->writer, nanoseconds);
    fstWriterSetVersion(file_->writer, "rayclock");
    fstWriterSetDate(file_->writer, "-");   // a constant date, so that equal runs give equal files
}

FstWriter::~FstWriter() {
    if (file_->writer) fstWriterClose(file_->writer);
}

void FstWriter::open_scope(const std::string& name) {
    fstWriterSetScope(file_->writer, FST_ST_VCD_MODULE, name.c_str(), nullptr);
}
void FstWriter::close_scope() { fstWriterSetUpscope(file_->writer); }

FstWriter::Signal FstWriter::add_bits(const std::string& name, int width) {
    return file_->add(ranged(name, width), FST_VT_VCD_WIRE, width, 0);
}
FstWriter::Signal FstWriter::add_text(const std::string& name) {
    return file_->add(name, FST_VT_GEN_STRING, 0, 0);
}
void FstWriter::add_alias(const std::string& name, int width, Signal signal) {
    file_->add(ranged(name, width), FST_VT_VCD_WIRE, width, signal);
}

void FstWriter::set_time(std::uint64_t time) { fstWriterEmitTimeChange(file_->writer, time); }

void FstWriter::set_bits(Signal signal, std::string_view digits) {
    if (int(digits.size()) != file_->signals[signal - 1].width)
        throw std::logic_error("a signal of a waveform has another width");
    if (file_->changes(signal, digits)) fstWriterEmitValueChange(file_->writer, signal, digits.data());
}

void FstWriter::set_value(Signal signal, std::uint64_t value) {
    const int width = file_->signals[signal - 1].width;
    set_bits(signal, digits_of({std::uint32_t(value), std::uint32_t(value >> 32)}, 0, width));
}

void FstWriter::set_text(Signal signal, std::string_view text) {
    if (file_->changes(signal, text))
        fstWriterEmitVariableLengthValueChange(file_->writer, signal, text.data(),
                                               std::uint32_t(text.size()));
}

std::string FstWriter::finish() {
    fstWriterClose(file_->writer);
    file_->writer = nullptr;
    if (rc_fst_error != 0) not_written(file_->path, rc_fst_error);
    std::string bytes = read_if_there(file_->path);
    if (bytes.empty()) not_written(file_->path, errno);
    return bytes;
}

std::string ranged(const std::string& name, int width) {
    const bool has_range = width == 1 || name.ends_with(']');
    return has_range ? name : name + "[" + std::to_string(width - 1) + ":0]";
}

std::string digits_of(const std::vector<std::uint32_t>& words, int at, int count) {
    std::string digits(std::size_t(count), '0');
    for (int i = 0; i < count; ++i) {
        const int bit = at + count - 1 - i;
        if (words[std::size_t(bit / 32)] >> (bit % 32) & 1) digits[std::size_t(i)] = '1';
    }
    return digits;
}

}   // namespace rayclock
