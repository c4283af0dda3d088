// Descriptions of units and links are equal in all places.
#include <fstream>
#include <stdexcept>

#include "model/machine/links.hpp"
#include "sim/run/gen/chip_page.hpp"
#include "tests/support/world/traffic.hpp"

using namespace rayclock;

namespace {

std::string read(const char* path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}   // namespace

TEST_CASE("the tables in rtl/README.md are those of the description", "[description]") {
    const std::string page = read("rtl/README.md");
    CHECK(with_tables(page) == page);
    CHECK_THROWS_AS(with_tables("<!-- made: no such table -->\n<!-- end -->"), std::logic_error);
}

TEST_CASE("every link has two ends that exist whenever it does", "[description]") {
    const auto unit = [](std::string_view name) -> const UnitInfo* {
        for (const UnitInfo& info : unit_infos)
            if (info.name == name) return &info;
        return nullptr;
    };
    std::vector<Config> configs(6);
    for (std::size_t i = 0; i < configs.size(); ++i) configs[i].structure = Structure(i % 3);
    for (std::size_t i = 3; i < configs.size(); ++i) configs[i].shading = 1, configs[i].l2_sets = 8;
    for (const LinkInfo& link : link_infos) {
        INFO(link.name);
        REQUIRE(unit(link.from));
        CHECK((unit(link.to) || std::string_view(link.to) == "sink"));
        for (const char* name : {link.from, link.to})
            if (const UnitInfo* end = unit(name))
                for (const Config& config : configs)
                    CHECK((is_there(end->when, config) || !is_there(link.when, config)));
    }
}
