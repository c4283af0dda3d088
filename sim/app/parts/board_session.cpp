// The board of a command: at a port, or simulated in this process.
#include "sim/app/parts/board_session.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/image/srgb.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"

namespace rayclock {

namespace {

constexpr std::uint32_t port_baud = 3'000'000;
/// Cycles of a bit on the wire of a simulated board: few, because each cycle costs time. rc_baud needs
/// at least four.
constexpr int simulated_cycles_per_bit = 5;
/// A board that another process simulates runs at about 0.15 million cycles per second while it draws,
/// instead of 75 million.
constexpr int patience_with_simulation = 500;

std::uint32_t simulated_baud(int khz) { return std::uint32_t(khz) * 1000 / simulated_cycles_per_bit; }

/// Ends every wait for a board at Ctrl-C.
class StoppableChannel : public Channel {
public:
    /// slice: the longest wait without a check for Ctrl-C, in the channel's time.
    StoppableChannel(Channel& inner, LinkTime slice) : inner_(inner), slice_(slice) {}

    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) override {
        stop_if_interrupted();
        return inner_.exchange(out, in, std::min(most, slice_));
    }
    LinkTime now() override { return inner_.now(); }

private:
    Channel& inner_;
    LinkTime slice_;
};

}   // namespace

int settle_board(const BoardOptions& o, Config& config) {
    config.board_sdram = o.sdram;
    if (!config.is_board())
        throw UserError("board needs a configuration with dram=board, such as ulx3s-board");
    const int khz = one_clock_of(o.clock, config);
    // A screen period must last a whole number of cycles. Otherwise the cycles of a frame would depend on the
    // number of periods before it.
    constexpr int step = 5;
    if (khz % step != 0)
        throw UserError(
            fmt::format("--clock {:g}: a screen period must last a whole number of cycles, "
                        "so the clock must be a multiple of {:g} MHz",
                        khz / 1e3, step / 1e3));
    return khz;
}

BoardRequest board_request(const BoardOptions& o, const Progress& progress) {
    BoardRequest asked{parse_size(o.size), nullptr, {}};
    o.json.check();
    sdram_part(o.sdram);   // throws
    asked.port = open_port(o);
    asked.request = request_of(o.scene, o.config, o.finish, 1, asked.size, progress, o.view);
    asked.khz = settle_board(o, asked.request.config);
    return asked;
}

std::unique_ptr<Port> open_port(const BoardOptions& o) {
    return o.is_simulated() ? nullptr : std::make_unique<Port>(o.port, port_baud);
}

std::unique_ptr<SimulatedBoard> simulate_board(const BoardOptions& o, const Config& config, int khz) {
    return std::make_unique<SimulatedBoard>(
        config, BoardShape{.khz = khz, .baud = simulated_baud(khz), .sdram = o.sdram, .is_lit = !o.dark});
}

BoardSession::BoardSession(const BoardOptions& o, const Config& config, int khz, std::unique_ptr<Port> port)
    : port_(std::move(port)) {
    LinkSettings settings;
    settings.name = o.port;
    Channel* inner = port_.get();
    LinkTime slice(100'000);
    if (port_) {
        settings.baud = port_baud;
        settings.slower = o.patience.value_or(port_->is_pseudo_terminal() ? patience_with_simulation : 1);
    } else {
        simulated_ = simulate_board(o, config, khz);
        settings.baud = simulated_baud(khz);
        settings.hello = 1;
        inner = simulated_.get();
        slice = LinkTime(50);   // about a tenth of a second too
    }
    channel_ = std::make_unique<StoppableChannel>(*inner, slice);
    link_ = std::make_unique<BoardLink>(*channel_, settings);
    host_ = std::make_unique<BoardHost>(*link_, config, sdram_part(o.sdram));
}

BoardSession::~BoardSession() = default;

Picture picture_of(FrameSize size, const std::vector<PixelBytes>& bytes) {
    Picture picture{size, {}};
    for (const PixelBytes& pixel : bytes)
        picture.pixels.emplace_back(linear_from_srgb(pixel[0] / 255.0), linear_from_srgb(pixel[1] / 255.0),
                                    linear_from_srgb(pixel[2] / 255.0));
    return picture;
}

void check_png(const std::string& path) {
    if (std::filesystem::path(path).extension() != ".png")
        throw UserError("-o: " + shown(path) + " is not the name of a PNG file");
    check_writable(path);
}

std::vector<std::string> memory_faults(const SimulatedBoard& board) {
    std::vector<std::string> faults;
    for (const SdramChip::Violation& violation : board.sdram().violations()) faults.push_back(violation.text);
    return faults;
}

std::vector<std::string> screen_faults(const SimulatedBoard& board) {
    std::vector<std::string> faults = board.screen().errors();
    faults.insert(faults.end(), board.receiver().errors().begin(), board.receiver().errors().end());
    return faults;
}

}   // namespace rayclock
