// Writes the page of the study of textures.
#include "sim/study/textures/textures_page.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/table.hpp"
#include "sim/study/textures/block.hpp"
#include "sim/study/typed.hpp"

namespace rayclock::texture_study {

namespace {

struct Shown {
    const char* name;   ///< of the file
    Filter filter;
    Coding coding;
};
constexpr std::array shown_rows{
    Shown{"nearest", Filter::nearest, Coding::rgb888}, Shown{"bilinear", Filter::bilinear, Coding::rgb888},
    Shown{"levels", Filter::levels, Coding::rgb888}, Shown{"rgb565", Filter::levels, Coding::rgb565},
    Shown{"bc1", Filter::levels, Coding::blocks}};
constexpr const char* samples_name = "samples";

std::string decibels(double db) { return std::isfinite(db) ? fmt::format("{:.1f}", db) : "equal"; }
std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }
std::string kilobytes(std::uint64_t bytes) { return grouped((bytes + 512) / 1024); }

/// Returns "12.3 % fewer" or "12.3 % more".
std::string change(std::uint64_t from, std::uint64_t to) {
    const double share = (double(to) - double(from)) / double(from);
    return fmt::format("{:.1f} % {}", 100 * std::fabs(share), share < 0 ? "fewer" : "more");
}

std::string image(const std::string& alt, const std::string& name) {
    return fmt::format("![{}](figures/{})", alt, name);
}

std::string pictures_of(const SceneFigures& figures) {
    const auto cell = [&](const char* name, const std::string& title) {
        return image(title, picture_name(figures.scene, name));
    };
    std::vector<std::string> titles{"64 samples in a pixel"},
        cells{cell(samples_name, figures.scene + ", 64 samples in a pixel")};
    for (const Shown& shown : shown_rows) {
        titles.push_back(fmt::format("{}, {}", name_of(shown.coding), name_of(shown.filter)));
        cells.push_back(cell(shown.name, figures.scene + ", " + titles.back()));
    }
    std::string text;
    for (std::size_t first = 0; first < titles.size(); first += 3) {
        const auto row = [&](const std::vector<std::string>& all) {
            return fmt::format("| {} |\n", fmt::join(all.begin() + std::ptrdiff_t(first),
                                                     all.begin() + std::ptrdiff_t(first + 3), " | "));
        };
        text += row(titles) + "|---|---|---|\n" + row(cells) + "\n";
    }
    return text;
}

std::string rows_table(const SceneFigures& figures) {
    Table table({"texels", "filter", "PSNR, 64 samples", "PSNR, exact", "with 8-bit alpha", "cycles",
                 "bytes read", "`tex_cache` hits", "texels, KB", "image, KB"},
                2);
    for (const Row& row : figures.rows)
        table.add({name_of(row.coding), name_of(row.filter), decibels(row.psnr_samples),
                   decibels(row.psnr_exact), decibels(row.psnr_exact_alpha8), grouped(row.cost().cycles),
                   grouped(row.cost().bytes), percent(row.cost().hit_rate()), kilobytes(row.texel_bytes),
                   kilobytes(row.image_bytes)});
    return table.markdown();
}

std::string rows_prose(const SceneFigures& figures) {
    const Row &nearest = figures.row(Filter::nearest, Coding::rgb888),
              &bilinear = figures.row(Filter::bilinear, Coding::rgb888),
              &levels = figures.row(Filter::levels, Coding::rgb888),
              &narrow = figures.row(Filter::levels, Coding::rgb565);
    return fmt::format(
        "With rgb888, interpolation changes the PSNR against 64 samples from {} to {} dB, and mip levels "
        "change it to {} dB. A frame with mip levels takes {} cycles than with level 0, and reads {} bytes. "
        "With mip levels, rgb565 takes {} cycles than rgb888 and reads {} bytes. Its PSNR against 64 samples "
        "is {} dB, and against the exact picture {} dB instead of {} dB. With 8 bits of alpha the latter "
        "would be {} dB.\n",
        decibels(nearest.psnr_samples), decibels(bilinear.psnr_samples), decibels(levels.psnr_samples),
        change(bilinear.cost().cycles, levels.cost().cycles),
        change(bilinear.cost().bytes, levels.cost().bytes),
        change(levels.cost().cycles, narrow.cost().cycles), change(levels.cost().bytes, narrow.cost().bytes),
        decibels(narrow.psnr_samples), decibels(narrow.psnr_exact), decibels(levels.psnr_exact),
        decibels(narrow.psnr_exact_alpha8));
}

std::string coded_table(const SceneFigures& figures) {
    Table table({"picture", "texels", "rgb565, dB", "BC1, dB"}, 1);
    for (const CodedTexture& t : figures.textures)
        table.add({"`" + t.name + "`", fmt::format("{} x {}", t.width, t.height), decibels(t.rgb565),
                   decibels(t.blocks)});
    return table.markdown();
}

std::string machine_name(std::size_t machine, const Study& study) {
    std::string name = study.config.name;
    for (const char* item : machines[machine])
        if (*item) name += fmt::format(", {}", item);
    return name;
}

std::string machines_table(const SceneFigures& figures, const Study& study) {
    std::vector<std::string> head{"machine", "filter"};
    for (const char* name : coding_names) head.emplace_back(name);
    head.emplace_back("one line of texels");
    Table table(head, 2);
    for (std::size_t m = 0; m < machines.size(); ++m)
        for (const Filter filter : {Filter::bilinear, Filter::levels}) {
            std::vector<std::string> cells{machine_name(m, study), name_of(filter)};
            for (const Coding coding : {Coding::rgb888, Coding::rgb565, Coding::blocks})
                cells.push_back(grouped(figures.row(filter, coding).costs[m].cycles));
            cells.push_back(grouped(figures.least[m].cycles));
            table.add(cells);
        }
    return table.markdown();
}

/// Returns the range of the change from one coding to another over all machines: "1.2 % fewer to 0.3 % more".
std::string range(const SceneFigures& figures, Filter filter, Coding from, Coding to,
                  std::uint64_t Cost::*figure) {
    std::vector<std::pair<double, std::string>> changes;
    for (std::size_t m = 0; m < machines.size(); ++m) {
        const std::uint64_t a = figures.row(filter, from).costs[m].*figure,
                            b = figures.row(filter, to).costs[m].*figure;
        changes.emplace_back(double(b) / double(a), change(a, b));
    }
    std::ranges::sort(changes);
    return changes.front().second + " to " + changes.back().second;
}

std::string machines_prose(const SceneFigures& figures) {
    const Row &narrow = figures.row(Filter::levels, Coding::rgb565),
              &blocks = figures.row(Filter::levels, Coding::blocks);
    return fmt::format(
        "Over these machines, BC1 takes {} cycles than rgb565 with mip levels, and {} at level 0. With mip "
        "levels it reads {} bytes. The PSNR of the drawn picture against the exact one is {} dB with BC1 and "
        "{} dB with rgb565; with 8 bits of alpha, {} dB and {} dB.\n",
        range(figures, Filter::levels, Coding::rgb565, Coding::blocks, &Cost::cycles),
        range(figures, Filter::bilinear, Coding::rgb565, Coding::blocks, &Cost::cycles),
        range(figures, Filter::levels, Coding::rgb565, Coding::blocks, &Cost::bytes),
        decibels(blocks.psnr_exact), decibels(narrow.psnr_exact), decibels(blocks.psnr_exact_alpha8),
        decibels(narrow.psnr_exact_alpha8));
}

/// Returns a table of the formats of a line of memory: their tiles, their bits, and the bytes of a texel.
std::string layout_table() {
    Table table({"texels", "tile", "with border", "bits of a line", "bytes per texel in memory",
                 "bytes per texel alone"},
                1);
    const auto add = [&](const char* name, int log_width, int log_height, int bits, double alone) {
        const int w = 1 << log_width, h = 1 << log_height;
        table.add({name, fmt::format("{} x {}", w, h), fmt::format("{} x {}", w + 1, h + 1),
                   fmt::format("{}", bits), fmt::format("{:g}", double(line_bytes) / (w * h)),
                   fmt::format("{:g}", alone)});
    };
    for (const TexelFormat format : {TexelFormat::rgb888, TexelFormat::rgb565}) {
        const TileShape tile = tile_shape(format);
        add(format == TexelFormat::rgb888 ? "rgb888" : "rgb565", tile.log_width, tile.log_height,
            tile.texels() * tile.bits, tile.bits / 8.0);
    }
    constexpr double block_alone = double(block_bits) / (block_side * block_side) / 8;
    constexpr int plain_width = 3, plain_height = 2, plain_blocks = 6;
    static_assert(plain_blocks * block_side * block_side >=
                  ((1 << plain_width) + 1) * ((1 << plain_height) + 1));
    add("BC1, blocks over tile and border", plain_width, plain_height, plain_blocks * block_bits,
        block_alone);
    add("BC1, border in blocks of its own, 1 bit of alpha", block_tile_log, block_tile_log, block_line_bits,
        block_alone + 1.0 / 8);
    return table.markdown();
}

}   // namespace

std::string picture_name(const std::string& scene, const std::string& what) {
    std::string stem = std::filesystem::path(scene).stem().string();
    for (char& c : stem)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '-';
    return fmt::format("textures-{}-{}.png", stem, what);
}

void prepare_pictures(const std::vector<std::string>& scenes, const std::string& folder) {
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (picture_name(scenes[i], samples_name) == picture_name(scenes[k], samples_name))
                throw UserError(fmt::format("--scenes: the pictures of {} and {} would have the same names",
                                            printable(scenes[k]), printable(scenes[i])));
    const std::filesystem::path figures = std::filesystem::path(folder) / "figures";
    std::error_code error;
    std::filesystem::create_directories(figures, error);
    if (error || !std::filesystem::is_directory(figures))
        throw UserError(printable(figures.string()) + ": cannot be made a folder for the pictures");
    for (const std::string& scene : scenes)
        check_writable((figures / picture_name(scene, samples_name)).string());
}

void write_pictures(const std::vector<SceneFigures>& all, const std::string& folder) {
    const auto write = [&](const SceneFigures& figures, const char* what, const Picture& picture) {
        write_picture(
            (std::filesystem::path(folder) / "figures" / picture_name(figures.scene, what)).string(), picture,
            {picture.size, std::vector<Hit>(picture.pixels.size())});
    };
    for (const SceneFigures& figures : all) {
        write(figures, samples_name, figures.samples);
        for (const Shown& shown : shown_rows)
            write(figures, shown.name, figures.row(shown.filter, shown.coding).picture);
    }
}

std::string page(const std::vector<SceneFigures>& all, const Study& study, const std::string& command) {
    std::string text = fmt::format(R"(# Textures, measured

Made by `{}`. Do not edit. [Textures](../machine/shading.md#textures) explains the unit.

Each picture has {} x {} pixels, and its paths have at most {} bounce{}. The machine is `{}` at {:g} MHz, with cold
caches. *64 samples* is the reference tracer's picture with 8 x 8 samples per pixel and the scene's own filters. *exact*
is its picture with one sample per pixel and the filter of the row. PSNR is over 8-bit sRGB values, in dB. *with 8-bit
alpha* is the PSNR against *exact* if colours have the format of the row and alpha has 8 bits. *hits* is the share of
look-ups in `tex_cache` that hit, for records and texels. A texture whose filter is `nearest` in the scene keeps this
filter in every row. *texels, KB* counts textures on triangles.
)",
                                   command, study.size.width, study.size.height, study.depth,
                                   study.depth == 1 ? "" : "s", study.config.name, default_khz / 1e3);
    for (const SceneFigures& figures : all)
        text += fmt::format("\n## `{}`\n\n{}{}\n{}", page_path(figures.scene), pictures_of(figures),
                            rows_table(figures), rows_prose(figures));
    text += fmt::format(R"(
## Block compression

The machine has no compressed format. These figures show what BC1 would change. BC1 stores {} x {} texels in {} bits:
two colours of 16 bits, and 2 bits for each texel. `stb_dxt` encodes the blocks. Alpha has one bit, as with rgb565.

A line of memory holds a tile and its border, so that one line has all texels of a filter. The border repeats texels of
other tiles:

{}
The rows *BC1* have the last of these forms. Their cycles, bytes and hits come from the recorded rays of rgb565, in
which the lines of the larger tiles replace the lines of texels. The decoder's latency is not included. Texels of the
border have the decoded colours of the neighbouring tiles. For each scene, the first table has the PSNR of level 0 of
each picture. The second table has cycles on several machines. In its last column each picture has a single line of
texels, so nearly all look-ups hit.
)",
                        block_side, block_side, block_bits, layout_table());
    for (const SceneFigures& figures : all)
        text += fmt::format("\n### `{}`\n\n{}\n{}", page_path(figures.scene), coded_table(figures),
                            machines_table(figures, study) + "\n" + machines_prose(figures));
    return text;
}

nlohmann::ordered_json figures_json(const std::vector<SceneFigures>& all, const Study& study) {
    using Json = nlohmann::ordered_json;
    const auto db = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    const auto costs = [&](const Costs& all_machines) -> Json {
        Json list = Json::array();
        for (std::size_t m = 0; m < machines.size(); ++m) {
            const Cost& c = all_machines[m];
            list.push_back({{"machine", machine_name(m, study)},
                            {"cycles", c.cycles},
                            {"bytes_read", c.bytes},
                            {"tex_cache_look_ups", c.look_ups},
                            {"tex_cache_hits", c.hits}});
        }
        return {{"costs", std::move(list)}};
    };
    Json scenes = Json::array();
    for (const SceneFigures& figures : all) {
        Json rows = Json::array(), textures = Json::array();
        for (const Row& row : figures.rows) {
            Json one{{"texels", name_of(row.coding)},
                     {"filter", name_of(row.filter)},
                     {"psnr_64_samples_db", db(row.psnr_samples)},
                     {"psnr_exact_db", db(row.psnr_exact)}};
            one["psnr_exact_8_bit_alpha_db"] = db(row.psnr_exact_alpha8);
            one.update(costs(row.costs));
            one["texel_bytes"] = row.texel_bytes;
            one["image_bytes"] = row.image_bytes;
            rows.push_back(std::move(one));
        }
        for (const CodedTexture& t : figures.textures)
            textures.push_back({{"name", t.name},
                                {"width", t.width},
                                {"height", t.height},
                                {"rgb565_db", db(t.rgb565)},
                                {"bc1_db", db(t.blocks)}});
        scenes.push_back({{"scene", page_path(figures.scene)},
                          {"texels", figures.texels},
                          {"rows", std::move(rows)},
                          {"textures", std::move(textures)},
                          {"one_line_of_texels", costs(figures.least)}});
    }
    return {{"scenes", std::move(scenes)}};
}

}   // namespace rayclock::texture_study
