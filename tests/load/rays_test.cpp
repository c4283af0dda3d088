// Rays from files. The .npy files are written here by hand, as numpy.save writes them.
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "sim/load/rays/rays.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test::rays_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity(),
                 not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Returns an .npy file of version 1.0 with this head and data.
std::string npy(std::string head, const std::string& data) {
    head.append(63 - (10 + head.size()) % 64, ' ');
    head += '\n';
    const auto length = std::uint16_t(head.size());
    return "\x93NUMPY" + std::string("\1\0", 2) + raw(length) + head + data;
}
std::string head_of(const std::string& descr, const std::string& shape, const char* fortran = "False") {
    return "{'descr': " + descr + ", 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
}
template <class Number> std::string data_of(const std::vector<double>& numbers) {
    std::string data;
    for (const double x : numbers) data += raw(Number(x));
    return data;
}

const std::vector<double> plain{0, 1, 2, 0, 0, -1};

std::string complaint_of(const std::string& name, const std::string& bytes, bool any_hit = false) {
    const SceneFolder folder;
    const std::string file = folder.write(name, bytes);
    try {
        const RayFile rays(file, any_hit);
    } catch (const UserError& error) {
        const std::string sentence = error.what();
        CHECK(sentence.starts_with(file + ": "));
        CHECK(sentence.find('\n') == std::string::npos);
        return sentence.substr(file.size() + 2);
    }
    return "";
}
std::string complaint_of_numbers(std::vector<double> numbers) {
    const auto columns = std::to_string(numbers.size());
    return complaint_of("a.npy", npy(head_of("'<f8'", "(1, " + columns + ")"), data_of<double>(numbers)));
}

}   // namespace

TEST_CASE("rays of every width and type are read", "[rays]") {
    const SceneFolder folder;
    std::vector<double> numbers{0.5, 1, 2, 0.25, 0, -1};
    const auto check = [&](const RayFile& rays, double t_min, double t_max, bool any) {
        REQUIRE(rays.size() == 1);
        CHECK(rays[0].origin == glm::dvec3(0.5, 1, 2));
        CHECK(rays[0].direction == glm::dvec3(0.25, 0, -1));
        CHECK(rays[0].t_min == t_min);
        CHECK(rays[0].t_max == t_max);
        CHECK(rays[0].any_hit == any);
    };
    const auto read = [&](const std::string& type, const std::vector<double>& row, bool any = false) {
        const std::string data = type == "<f4" ? data_of<float>(row) : data_of<double>(row);
        return RayFile(
            folder.write("a.npy",
                         npy(head_of("'" + type + "'", "(1, " + std::to_string(row.size()) + ")"), data)),
            any);
    };
    for (const std::string type : {"<f4", "<f8"}) {
        check(read(type, numbers), 0, inf, false);
        check(read(type, numbers, true), 0, inf, true);
        check(read(type, {0.5, 1, 2, 0.25, 0, -1, 7}), 0, 7, false);
        check(read(type, {0.5, 1, 2, 0.25, 0, -1, 0.5, 7}), 0.5, 7, false);
        check(read(type, {0.5, 1, 2, 0.25, 0, -1, 0.5, inf, 1}), 0.5, inf, true);
    }
    check(RayFile(folder.write("a.rays", data_of<float>(numbers))), 0, inf, false);
}

TEST_CASE("a file of rays of another form is refused in a sentence", "[rays]") {
    const std::string data = data_of<double>(plain);
    const auto complaint = [&](const std::string& bytes) { return complaint_of("a.npy", bytes); };
    CHECK(complaint(npy(head_of("'<f8'", "(1, 6)"), data)).empty());
    CHECK(complaint("hello").find("does not begin as an .npy file does") != std::string::npos);
    CHECK(complaint("\x93NUMPY\1").find("ends within its head") != std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(1, 6)", "True"), data)).find("Fortran order") !=
          std::string::npos);
    CHECK(complaint(npy(head_of("'>f8'", "(1, 6)"), data)).find(">f8") != std::string::npos);
    CHECK(complaint(npy(head_of("'<i8'", "(1, 6)"), data)).find("<i8") != std::string::npos);
    CHECK(complaint(npy(head_of("'|O'", "(6,)"), data)).find("never loaded") != std::string::npos);
    CHECK(complaint(npy(head_of("[('o', '<f8', (3,)), ('d', '<f8', (3,))]", "(1,)"), data))
              .find("a structure") != std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(6,)"), data)).find("and these are 6") != std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(2, 3)"), data)).find("and these are 2 x 3") != std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(2, 6)"), data)).find("needs 96 bytes") != std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(1, 6)"), data) + "x")
              .find("needs 48 bytes of data, and 49 follow") != std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(18446744073709551615, 6)"), data)).find("more than 2^64") !=
          std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(1000000000, 6)"), data)).find("needs 48000000000 bytes") !=
          std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(0, 6)"), "")).find("there are no rays") != std::string::npos);
    CHECK(complaint(npy("{'descr': '<f8', 'shape': (1, 6), }", data)).find("lacks") != std::string::npos);
    CHECK(complaint(npy("{'descr': '<f8', 'descr': '<f8', 'fortran_order': False, 'shape': (1, 6), }", data))
              .find("twice") != std::string::npos);
    CHECK(complaint(npy(head_of("'<f8'", "(1, 6)") + " x", data)).find("does not end") != std::string::npos);
    std::string later = npy(head_of("'<f8'", "(1, 6)"), data);
    later[6] = 9;
    CHECK(complaint(later).find("version 9") != std::string::npos);
    CHECK(complaint_of("a.rays", data + "x").find("not a multiple") != std::string::npos);
    CHECK(complaint_of("a.txt", data).find(".npy and .rays") != std::string::npos);
}

TEST_CASE("a faulty ray is refused with its number", "[rays]") {
    CHECK(complaint_of_numbers({0, 1, not_a_number, 0, 0, -1}) ==
          "ray 0 has a coordinate that is NaN or infinite");
    CHECK(complaint_of_numbers({0, 1, 2, 0, inf, -1}) == "ray 0 has a coordinate that is NaN or infinite");
    CHECK(complaint_of_numbers({0, 1, 2, 0, 0, 0}) == "ray 0 has the direction 0");
    const std::string limits = "has a direction whose largest component is";
    CHECK(complaint_of_numbers({0, 1, 2, 0, 0, 0x1p-501}).find(limits) != std::string::npos);
    CHECK(complaint_of_numbers({0, 1, 2, 1, 0, -0x1p501}).find(limits) != std::string::npos);
    CHECK(complaint_of_numbers({0, 1, -0x1p501, 0, 0, 1}).find("has an origin with a coordinate of") !=
          std::string::npos);
    for (const double size : {0x1p-500, 0x1p500})
        CHECK(complaint_of_numbers({0, 0x1p500, -0x1p500, 0x1p-1074, 0, size}).empty());
    CHECK(complaint_of_numbers({0, 1, 2, 0, 0, -1, 2, 1}) == "ray 0 has t_min 2 above t_max 1");
    CHECK(complaint_of_numbers({0, 1, 2, 0, 0, -1, not_a_number}) == "ray 0 has t_min 0 and t_max nan");
    CHECK(complaint_of_numbers({0, 1, 2, 0, 0, -1, 0, 1, 2}).starts_with("ray 0 has 2 in its ninth column"));
    std::vector<double> two = plain;
    two.insert(two.end(), {0, 0, 0, 0, 0, 0});
    CHECK(complaint_of("a.npy", npy(head_of("'<f4'", "(2, 6)"), data_of<float>(two))) ==
          "ray 1 has the direction 0");
}

}   // namespace rayclock::test::rays_test
