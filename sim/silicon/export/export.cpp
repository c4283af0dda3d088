// Writes the files of an exported frame.
#include "sim/silicon/export/export.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "model/machine/machine.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/gen/registers.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

extern const char *const bench_text, *const icarus_sed;   // sim/silicon/export/rc_bench.sv, icarus.sed

namespace {

/// Formats words as one hexadecimal number of `bits` bits.
std::string hex(const std::uint32_t* words, int bits) {
    std::string text;
    for (int digit = (bits + 3) / 4; digit-- > 0;)
        text += "0123456789abcdef"[words[digit / 8] >> 4 * (digit % 8) & 15];
    return text;
}

std::string memory_hex(const MemoryImage& image) {
    std::string text = "// Memory from address 0: a line of 64 bytes in each, its lowest bit on the right.\n";
    for (std::uint32_t line = 0; line < image.lines(); ++line)
        text += hex(image.line(line), line_bits) + "\n";
    return text;
}

std::string memory_bytes(const MemoryImage& image) {
    std::string bytes;
    bytes.reserve(image.words.size() * 4);
    for (const std::uint32_t word : image.words)
        for (int shift = 0; shift < 32; shift += 8) bytes += char(word >> shift & 255);
    return bytes;
}

std::string name_of(const FrameWord& word) {
    std::string name = word.element < 0 ? word.field : fmt::format("{}[{}]", word.field, word.element);
    return word.low > 0 ? fmt::format("{}, from bit {}", name, word.low) : name;
}

/// The bus writes of a frame, in order, and their number.
struct Settings {
    std::string text;
    int count = 0;
};
Settings settings_of(const Frame& frame, const Config& config) {
    Settings s{"// Writes on the bus, in order: address_value, counted in words of 32 bits.\n"};
    const auto write = [&](std::uint32_t address, std::uint32_t value, const std::string& what) {
        s.text += fmt::format("{:04x}_{:08x}   // {}\n", address, value, what);
        ++s.count;
    };
    const std::vector<FrameWord> words = frame_words(config);
    const std::vector<std::uint32_t> values = frame_values(frame, config);
    for (std::size_t i = 0; i < words.size(); ++i)
        write(frame_base + std::uint32_t(i), values[i], name_of(words[i]));
    write(register_address("Count"), 1, "count cycles");
    write(register_address("Start"), 1, "start");
    return s;
}

/// Collects the names of a payload's fields, the uppermost first.
class NameVisitor {
public:
    std::string text;
    template <class T> void operator()(const char* name, const T&, int width) { add(name, width, 1); }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&, int width, int count) {
        add(name, width, count);
    }

private:
    void add(const char* name, int width, int count) {
        text += fmt::format("{}{}:{}", text.empty() ? "" : ", ", name, width * count);
    }
};

std::string pixels_hex(const RecordedFrame& frame, const Config& config) {
    NameVisitor names;
    HitOut{}.fields(names, config);
    std::string text = fmt::format(
        "// Pixels, row by row, each as it comes out of the chip, but with ray = 0. Bits, the uppermost "
        "first:\n// {}\n",
        names.text);
    const int bits = bits_of<HitOut>(config);
    Words words;
    for (std::uint32_t i = 0; i < frame.trace.hits.size(); ++i) {
        HitOut out{i % frame.frame.width, i / frame.frame.width, frame.trace.hits[i], {}};
        out.closest.ray = 0;
        if (!frame.trace.colours.empty()) out.colour = frame.trace.colours[i];
        pack(out, config, words);
        text += hex(words.data(), bits) + "\n";
    }
    return text;
}

/// The expected values of the account's registers at the end of the frame, and their number.
struct Account {
    std::string text;
    int count = 0;
};
Account account_of(const Machine& machine, const Config& config) {
    Account a{"// What can be read after the frame: address_value.\n"};
    const auto expect = [&](std::uint32_t address, std::uint64_t value, const std::string& what) {
        a.text += fmt::format("{:06x}_{:010x}   // {}\n", address, value, what);
        ++a.count;
    };
    expect(register_address("Cycles"), machine.cycle(), "cycles");
    const auto unit = [&](const Accounts& accounts, std::size_t u, int pipeline) {
        if (!is_there(Unit(u), config)) return;
        for (std::size_t c = 0; c < cause_count; ++c) {
            const Cause& cause = unit_infos[u].causes[c];
            const char* kind = cause.kind == CauseKind::none      ? "never"
                               : cause.kind == CauseKind::busy    ? "busy:"
                               : cause.kind == CauseKind::starved ? "starved by"
                                                                  : "stalled by";
            expect(counter_address(Unit(u), pipeline, c), accounts.units[u][c],
                   fmt::format("{}{} {} {}", unit_infos[u].name,
                               u < pipeline_units ? fmt::format("[{}]", pipeline) : "", kind, cause.name));
        }
    };
    for (std::size_t u = pipeline_units; u < pipeline_units + shared_units; ++u)
        unit(machine.accounts(), u, 0);
    for (int p = 0; p < config.pipelines; ++p)
        for (std::size_t u = 0; u < pipeline_units; ++u) unit(machine.accounts(p), u, p);
    return a;
}

std::string bench(const Job& job, const Frame& frame, int settings, const Account& account,
                  std::uint64_t cycles) {
    const Config& c = job.config;
    std::string constants;
    const auto constant = [&](const char* name, std::uint64_t value) {
        constants += fmt::format("{}localparam int {} = {};", constants.empty() ? "" : "\n  ", name, value);
    };
    constant("Lines", job.image.lines());
    constant("Settings", std::uint64_t(settings));
    constant("Accounts", std::uint64_t(account.count));
    constant("Width", frame.width);
    constant("Height", frame.height);
    constant("Pixels", std::uint64_t(frame.width) * frame.height);
    constant("Cycles", cycles);
    constant("MostCycles", std::min<std::uint64_t>(10 * cycles + 100'000, 2'000'000'000));
    constant("MemLatency", std::uint64_t(c.mem_latency));
    constant("MemInterval", std::uint64_t(c.mem_interval));
    constant("ResetCycles", std::uint64_t(c.clear_cycles()));
    const std::string mark = "// @settings@";
    std::string text = bench_text;
    return text.replace(text.find(mark), mark.size(), constants);
}

std::string readme(const Job& job, const std::string& title, const std::string& command,
                   std::uint64_t cycles) {
    return fmt::format(
        R"(# {0}

Made by `{1}`.

| file | what it is |
|---|---|
| `rtl/`, `chip.f` | the chip, top module `rc_chip`, and the list of its files |
| `registers.hex` | the writes on the bus that set up and start the frame, in order: address and value |
| `memory.hex`, `memory.bin` | the memory image from address 0 on, {2} lines of 64 bytes: a number of 512 bits each, and bytes |
| `pixels.hex` | the pixels that come out, {3}x{4}, row by row: the bits of `hit_t` with `ray` 0 |
| `counters.hex` | what the host reads after the frame of {5} cycles: address of the lower word and value. They hold for the memory of the bench, which answers a request after {6} cycles and takes one every {7} |
| `rc_bench.sv` | a test bench that checks all of it |
| `icarus.sed` | what must be changed in the sources for Icarus Verilog 11 |

The `.hex` files are in the format of `$readmemh`. An underscore stands between address and value.

With Verilator (5.006 or newer):

    verilator --binary --timing --x-assign unique --x-initial unique -f chip.f rc_bench.sv --top-module rc_bench
    obj_dir/Vrc_bench +verilator+rand+reset+2 +verilator+seed+1
    obj_dir/Vrc_bench +verilator+rand+reset+2 +verilator+seed+2 +seed=1

Registers start at random values, by Verilator's own seed: a missing reset shows. With `+seed=N` the memory
answers after random times and in any order, and the memory and the sink of the pixels are ready at random:
the pixels are the same, the cycles and the counters are not, and the bench leaves these out.

With Icarus Verilog 11, which knows unknown values and is much slower:

    cat $(grep '\.sv$' chip.f) rc_bench.sv | sed -f icarus.sed > icarus.sv
    iverilog -g2012 -DSYNTHESIS -s rc_bench -o icarus.vvp icarus.sv
    vvp icarus.vvp
    vvp icarus.vvp +seed=1

The bench prints PASS. Or it prints what differs and FAIL, and its exit code is not 0. The project's
docs/machine/chip.md describes the registers, the memory image, the ports and their protocols.
)",
        title, command, job.image.lines(), job.size.width, job.size.height, cycles, job.config.mem_latency,
        job.config.mem_interval);
}

}   // namespace

Export make_export(const Job& job, const std::string& title, const std::string& command,
                   const Progress& progress) {
    check_rtl(job.config);
    if (job.config.dram_part()) throw std::logic_error("an export's memory is the ideal one");
    Export result;
    const auto add = [&](const std::string& name, std::string bytes) {
        result.files.push_back({name, std::move(bytes)});
    };
    std::string list = "rtl/lint.vlt\nrtl/rc_pkg.sv\n";
    add("rtl/rc_pkg.sv", rc_package(job.config));
    for (RtlText& source : rtl_texts()) {
        if (source.name.ends_with(".sv")) list += "rtl/" + source.name + "\n";
        add("rtl/" + source.name, std::move(source.text));
    }
    add("chip.f", list);

    const RecordedFrame frame = record_frame(job, job.frame, 0, progress);
    Machine machine(job.config, job.khz);
    machine.start(frame.frame, frame.trace);
    const std::uint64_t limit = patience(job.config, job.khz, {});
    while (!machine.done()) {
        machine.run(machine.cycle() + 100'000);
        if (machine.quiet() > limit) throw std::runtime_error("model: nothing has moved for too long");
        if (progress) progress("model", machine.finished_pixels(), frame.trace.rays.size());
    }
    result.cycles = machine.cycle();
    result.digest = digest_of(frame.trace.hits, result.cycles, frame.trace.colours);

    const Settings settings = settings_of(job.frame, job.config);
    const Account account = account_of(machine, job.config);
    add("registers.hex", settings.text);
    add("memory.hex", memory_hex(job.image));
    add("memory.bin", memory_bytes(job.image));
    add("pixels.hex", pixels_hex(frame, job.config));
    add("counters.hex", account.text);
    add("rc_bench.sv", bench(job, job.frame, settings.count, account, result.cycles));
    add("icarus.sed", icarus_sed);
    add("README.md", readme(job, title, command, result.cycles));
    return result;
}

}   // namespace rayclock
