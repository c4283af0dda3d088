// The host's accesses, in order.
#include "sim/board/host.hpp"

#include <cstring>

#include <fmt/format.h>

#include "sim/board/identity.hpp"
#include "sim/run/gen/registers.hpp"

namespace rayclock {

namespace {

constexpr std::uint32_t control_reset = 1, control_arm = 2, status_ready = 1, status_written = 2;
constexpr LinkTime longest_start{250'000};   // of the memory, which needs 200 us

std::vector<MemoryLine> lines_of(const std::vector<std::uint32_t>& words) {
    std::vector<MemoryLine> lines(words.size() / 16);
    for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t b = 0; b < 4; ++b) lines[i / 16][i % 16 * 4 + b] = std::uint8_t(words[i] >> (8 * b));
    return lines;
}

}   // namespace

BoardHost::BoardHost(BoardLink& link, const Config& config, const SdramPart& part)
    : link_(link), config_(config), part_(part) {
    const BoardIdentity board = link_.hello();
    if (board.config_hash != config_hash(config))
        throw UserError(
            fmt::format("the board's bitstream was made from another configuration than '{}': hash "
                        "{:016x} instead of {:016x}",
                        config.name, board.config_hash, config_hash(config)));
    if (board.lines * 64 != part.bytes())
        throw UserError(fmt::format("the board has {} MB of memory, and {} has {} MB", board.lines * 64 >> 20,
                                    part.name, part.bytes() >> 20));
    wait_for(status_ready, longest_start, "its memory has not started");
    reset();
}

void BoardHost::reset() {
    link_.write(BoardRegister::control, control_reset);
    link_.write(BoardRegister::control, 0);
}

void BoardHost::check_capacity(std::uint64_t lines) const {
    if (lines > Screens::base(part_, 0))
        throw UserError(
            fmt::format("the scene's memory image of {} bytes does not fit below the pictures: the "
                        "board has {} bytes for it",
                        lines * 64, std::uint64_t(Screens::base(part_, 0)) * 64));
}

void BoardHost::load(const MemoryImage& image, std::uint64_t& done, const Progress& progress) {
    const std::vector<MemoryLine> lines = lines_of(image.words);
    check_capacity(lines.size());
    link_.upload(0, lines, done, progress);
}

void BoardHost::update(const Upload& upload) {
    check_capacity(upload.image_lines);
    const std::vector<MemoryLine> lines = lines_of(upload.words);
    for (std::size_t begin = 0, end = 0; begin < lines.size(); begin = end) {   // consecutive lines
        for (end = begin + 1; end < lines.size() && upload.lines[end] == upload.lines[end - 1] + 1;) ++end;
        link_.write_lines(upload.lines[begin], std::span(lines).subspan(begin, end - begin));
    }
    if (upload.resets) reset();
}

void BoardHost::wait_for(std::uint32_t bit, LinkTime most, const char* event) {
    const LinkTime end = link_.now() + most;
    for (bool is_last = false; !(link_.read(BoardRegister::status) & bit); is_last = link_.now() >= end)
        if (is_last)
            throw UserError(fmt::format("the board hangs: {} after {} ms", event, most.count() / 1000));
}

std::uint64_t BoardHost::read_counter(std::uint32_t address) {
    const std::uint64_t low = link_.read_register(RegisterSpace::chip, address);
    return low | std::uint64_t(link_.read_register(RegisterSpace::chip, address + 1)) << 32;
}

void BoardHost::read_accounts(Accounts& accounts) {
    for (std::size_t u = 0; u < pipeline_units + shared_units; ++u)
        for (std::size_t c = 0; is_there(Unit(u), config_) && c < cause_count; ++c)
            accounts.units[u][c] = read_counter(counter_address(Unit(u), 0, c));
}

BoardFrame BoardHost::run(const Frame& frame, LinkTime most, const Progress& progress) {
    const auto chip = [&](std::uint32_t address, std::uint32_t value) {
        link_.write_register(RegisterSpace::chip, address, value);
    };
    std::uint32_t address = frame_base;
    for (const std::uint32_t value : frame_values(frame, config_)) chip(address++, value);
    chip(register_address("Count"), 1);

    // The screen shows the last picture, which has the same size, while this one is drawn.
    const std::uint32_t drawn = Screens::base(part_, drawn_), shown = Screens::base(part_, 1 - drawn_);
    link_.write(BoardRegister::draw_base, drawn);
    link_.write(BoardRegister::base, shown);
    link_.write(BoardRegister::width, frame.width);
    link_.write(BoardRegister::height, frame.height);
    link_.write(BoardRegister::doubled, Screens::doubles(frame.width, frame.height));
    link_.write(BoardRegister::control, control_arm);
    wait_for(status_written, most, "the frame has not ended");

    BoardFrame result;
    result.cycles = read_counter(register_address("Cycles"));
    result.written_cycles = link_.read(BoardRegister::cycles);
    result.written_cycles |= std::uint64_t(link_.read(BoardRegister::cycles_high)) << 32;
    result.underruns = link_.read(BoardRegister::underruns);
    read_accounts(result.accounts);

    link_.write(BoardRegister::base, drawn);
    const std::uint32_t across = (frame.width + 3) / 4, down = (frame.height + 3) / 4;
    std::vector<MemoryLine> blocks(std::size_t(across) * down);
    constexpr std::size_t lines_of_read = 1024;
    for (std::size_t at = 0; at < blocks.size(); at += lines_of_read) {
        const std::size_t count = std::min(lines_of_read, blocks.size() - at);
        link_.read_lines(drawn + std::uint32_t(at), std::span(blocks).subspan(at, count));
        if (progress) progress("reading the picture", at + count, blocks.size());
    }
    result.pixels.resize(std::size_t(frame.width) * frame.height);
    for (std::uint32_t y = 0; y < frame.height; ++y)
        for (std::uint32_t x = 0; x < frame.width; ++x) {
            const std::uint8_t* const word =
                &blocks[std::size_t(y / 4) * across + x / 4][16 * (y % 4) + 4 * (x % 4)];
            std::memcpy(result.pixels[std::size_t(y) * frame.width + x].data(), word, 3);
        }
    drawn_ = 1 - drawn_;
    return result;
}

}   // namespace rayclock
