// Measures how rounding and quantising child boxes increases node visits: the tables at the end of
// docs/proofs/boxes.md.
//
// rc_boxes PAGE: replaces everything after the page's line `<!-- measured -->` with the tables.
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/scene/builtin.hpp"
#include "sim/judge/oracle/extra_visits.hpp"
#include "sim/view/report/text.hpp"

using namespace rayclock;

namespace {

constexpr std::array scenes{"gears:8", "balls:3", "mount:8", "tree:6", "teapot:12"};

ExtraVisits measure(const char* spec, const Config& config) {
    const Scene scene = make_builtin(spec);
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, 512.0 / 384);
    const MemoryImage image = compile_scene(scene, camera.eye, config);
    const ExtraVisits extra =
        extra_visits(image, make_frame(camera, {512, 384}, image.lattice, config), config);
    if (extra.boxes_lost + extra.t_late + extra.other_hits > 0)
        throw std::runtime_error(std::string(spec) + ": a box was lost");
    fmt::print(stderr, "{}\n", spec);
    return extra;
}

/// Returns a table with a row for each scene and a column for each value of `member`. Cells hold `figure` in
/// percent.
std::string table(const char* key, int Config::*member, const std::vector<int>& values,
                  double (ExtraVisits::*figure)() const) {
    std::vector<std::string> head{key};
    for (const int value : values) head.push_back(std::to_string(value));
    Table table(head, Table::words_only);
    for (const char* scene : scenes) {
        std::vector<std::string> row{scene};
        for (const int value : values) {
            Config config;
            config.stack_depth = 64;
            config.*member = value;
            row.push_back(fmt::format("{:.2f} %", 100 * (measure(scene, config).*figure)()));
        }
        table.add(row);
    }
    return table.markdown();
}

std::string measured() {
    return "\nAdditional node visits of the machine, compared with exact tests of the same boxes, R = "
           "16:\n\n" +
           table("N", &Config::coord_bits, {12, 14, 16, 18, 20}, &ExtraVisits::rounding) +
           "\nThe same, N = 18:\n\n" +
           table("R", &Config::recip_bits, {8, 9, 10, 11, 12, 13, 14, 15, 16}, &ExtraVisits::rounding) +
           "\nAdditional visits with exact tests of quantised boxes, compared with exact tests of the real "
           "boxes, N = 18:\n\n" +
           table("B", &Config::box_bits, {4, 5, 6, 7, 8}, &ExtraVisits::quantisation);
}

}   // namespace

int main(int argc, char** argv) {
    const std::string marker = "<!-- measured -->\n";
    if (argc != 2) {
        fmt::print(stderr, "usage: rc_boxes PAGE\n");
        return 2;
    }
    std::stringstream text;
    text << std::ifstream(argv[1]).rdbuf();
    const std::size_t at = text.str().find(marker);
    if (at == std::string::npos) {
        fmt::print(stderr, "{}: there is no line {}", argv[1], marker);
        return 2;
    }
    const std::string tables = measured();
    std::ofstream page(argv[1]);
    page << text.str().substr(0, at + marker.size()) << tables;
    return page.flush() ? 0 : 2;
}
