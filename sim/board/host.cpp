// The host's accesses, in order.
#include "sim/board/host.hpp"

#include <algorithm>
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
    reset();
    // The first frame after this is drawn into picture 0, as in the model.
    link_.write(BoardRegister::base, Screens::base(part_, 1));
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
    const LinkTime longest = most * link_.slower(), end = link_.now() + longest;
    for (bool is_last = false; !(link_.read(BoardRegister::status) & bit); is_last = link_.now() >= end)
        if (is_last)
            throw UserError(fmt::format("the board hangs: {} after {} ms", event, longest.count() / 1000));
}

std::uint64_t BoardHost::read_counter(std::uint32_t address) {
    const std::uint64_t low = link_.read_register(RegisterSpace::chip, address);
    return low | std::uint64_t(link_.read_register(RegisterSpace::chip, address + 1)) << 32;
}

void BoardHost::set_frame(const Frame& frame) {
    std::uint32_t address = frame_base;
    for (const std::uint32_t value : frame_values(frame, config_))
        link_.write_register(RegisterSpace::chip, address++, value);
    link_.write(BoardRegister::width, frame.width);
    link_.write(BoardRegister::height, frame.height);
    link_.write(BoardRegister::doubled, Screens::doubles(frame.width, frame.height));
}

BoardTiming BoardHost::draw(LinkTime most) {
    if (link_.read(BoardRegister::width) == 0 || link_.read(BoardRegister::height) == 0)
        throw UserError("the board has no frame to draw, since no scene was loaded after its reset");
    link_.write_register(RegisterSpace::chip, register_address("Count"), 1);
    // The screen shows the last picture, which has the same size, while this one is drawn.
    const std::uint32_t picture = link_.read(BoardRegister::base) == Screens::base(part_, 0) ? 1 : 0;
    const std::uint32_t drawn = Screens::base(part_, picture);
    link_.write(BoardRegister::draw_base, drawn);
    link_.write(BoardRegister::base, Screens::base(part_, 1 - picture));
    link_.write(BoardRegister::control, control_arm);
    wait_for(status_written, most, "the frame has not ended");
    link_.write(BoardRegister::base, drawn);
    return timing();
}

void BoardHost::check_drawn() {
    if (!(link_.read(BoardRegister::status) & status_written))
        throw UserError("the board has not drawn a frame since the last reset of its chip");
}

BoardTiming BoardHost::timing() {
    check_drawn();
    BoardTiming timing;
    timing.cycles = read_counter(register_address("Cycles"));
    timing.written_cycles = link_.read(BoardRegister::cycles);
    timing.written_cycles |= std::uint64_t(link_.read(BoardRegister::cycles_high)) << 32;
    timing.underruns = link_.read(BoardRegister::underruns);
    return timing;
}

std::uint32_t BoardHost::underruns(LinkTime after) {
    for (const LinkTime end = link_.now() + after * link_.slower();;) {
        const bool is_last = link_.now() >= end;
        const std::uint32_t underruns = link_.read(BoardRegister::underruns);
        if (is_last) return underruns;
    }
}

Accounts BoardHost::accounts() {
    check_drawn();
    Accounts accounts;
    for (std::size_t u = 0; u < pipeline_units + shared_units; ++u)
        for (std::size_t c = 0; is_there(Unit(u), config_) && c < cause_count; ++c)
            accounts.units[u][c] = read_counter(counter_address(Unit(u), 0, c));
    return accounts;
}

std::vector<MemoryLine> BoardHost::read_lines(std::uint64_t first, std::uint64_t count,
                                              const Progress& progress) {
    const std::uint64_t all = part_.bytes() / 64;
    if (first >= all || count > all - first)
        throw UserError(fmt::format("the board has lines 0 to {}, and lines {} to {} are asked for", all - 1,
                                    first, first + count - 1));
    std::vector<MemoryLine> lines(count);
    constexpr std::size_t lines_of_read = 1024;
    for (std::size_t at = 0; at < lines.size(); at += lines_of_read) {
        const std::size_t more = std::min(lines_of_read, lines.size() - at);
        link_.read_lines(std::uint32_t(first + at), std::span(lines).subspan(at, more));
        if (progress) progress("reading the board's memory", at + more, lines.size());
    }
    return lines;
}

BoardPicture BoardHost::picture(const Progress& progress) {
    check_drawn();
    BoardPicture picture{link_.read(BoardRegister::width), link_.read(BoardRegister::height), {}};
    if (picture.width > Screens::width || picture.height > Screens::height)
        throw UserError(
            fmt::format("the board's registers name a picture of {}x{} pixels, and its frame "
                        "buffer has {}x{}",
                        picture.width, picture.height, Screens::width, Screens::height));
    const std::uint32_t across = (picture.width + 3) / 4, down = (picture.height + 3) / 4;
    const std::vector<MemoryLine> blocks =
        read_lines(link_.read(BoardRegister::draw_base), std::uint64_t(across) * down, progress);
    picture.pixels.resize(std::size_t(picture.width) * picture.height);
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const std::uint8_t* const word =
                &blocks[std::size_t(y / 4) * across + x / 4][16 * (y % 4) + 4 * (x % 4)];
            std::memcpy(picture.pixels[std::size_t(y) * picture.width + x].data(), word, 3);
        }
    return picture;
}

BoardFrame BoardHost::run(const Frame& frame, LinkTime most, const Progress& progress) {
    set_frame(frame);
    BoardFrame result;
    static_cast<BoardTiming&>(result) = draw(most);
    result.accounts = accounts();
    result.pixels = picture(progress).pixels;
    return result;
}

}   // namespace rayclock
