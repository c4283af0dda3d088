// Payloads as bits: nothing is lost, nothing overlaps, and the order is that of SystemVerilog.
#include <algorithm>
#include <tuple>

#include "model/engine/engines.hpp"
#include "model/unit/trav/children.hpp"
#include "model/machine/links.hpp"
#include "tests/support/dut/format.hpp"
#include "tests/support/world/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

using Payloads =
    std::tuple<Frame, Slot, Ray, Node, PrimData, NodeReq, PrimReq, NodeRsp, PrimRsp, BoxReq, NodeAnswer,
               Children, Leaves, Start, Best, TriReq, TriRsp, Tested, Done, Closest, HitOut>;

/// Lists a payload's values, to compare two payloads without packing.
class ListVisitor {
public:
    std::vector<std::int64_t> values;
    template <class T> void operator()(const char*, const T& value, int) {
        values.push_back(std::int64_t(value));
    }
    template <class T, std::size_t n>
    void operator()(const char*, const std::array<T, n>& value, int, int count) {
        for (std::size_t i = 0; i < std::size_t(count); ++i) values.push_back(std::int64_t(value[i]));
    }
};
template <class P> std::vector<std::int64_t> values_of(P payload, const Config& config) {
    ListVisitor list;
    payload.fields(list, config);
    return list.values;
}

/// Lists the bits of a payload from the top, by the rule in layout.hpp alone.
class BitVisitor {
public:
    std::vector<bool> bits;
    template <class T> void operator()(const char*, const T& value, int width) {
        add(std::uint64_t(value), width);
    }
    template <class T, std::size_t n>
    void operator()(const char*, const std::array<T, n>& value, int width, int count) {
        for (int i = count - 1; i >= 0; --i) add(std::uint64_t(value[std::size_t(i)]), width);
    }

private:
    void add(std::uint64_t value, int width) {
        for (int i = width - 1; i >= 0; --i)
            bits.push_back(value >> std::min(i, 63) & 1);   // beyond 64 bits, the sign
    }
};

}   // namespace

TEMPLATE_LIST_TEST_CASE("a payload survives packing, and every bit is where the rule says", "[layout]",
                        Payloads) {
    const Config config = format(GENERATE("default", "small", "narrow", "wide", "sheared:default"));
    const int bits = bits_of<TestType>(config);
    Draw draw{7};
    for (int i = 0; i < 200; ++i) {
        auto payload = random_payload<TestType>(draw, config);
        const Words words = pack(payload, config);
        REQUIRE(int(words.size()) == (bits + 31) / 32);
        REQUIRE(values_of(unpack<TestType>(words.data(), config), config) == values_of(payload, config));
        BitVisitor plain;
        payload.fields(plain, config);
        REQUIRE(int(plain.bits.size()) == bits);
        for (int at = 0; at < int(words.size()) * 32; ++at) {
            const bool expected = at < bits && plain.bits[std::size_t(bits - 1 - at)];
            if ((words[std::size_t(at / 32)] >> (at % 32) & 1) != expected) FAIL("bit " << at);
        }
    }
}

TEST_CASE("a negative number too wide for its field is cut to it", "[layout]") {
    const Config config = format("small");
    PrimReq req{0xffff'ffffu, 5};
    REQUIRE(unpack<PrimReq>(pack(req, config).data(), config).ray == 15);
    REQUIRE(unpack<PrimReq>(pack(req, config).data(), config).addr == 5);
}

TEST_CASE("payloads of the default format have the widths that its parameters give", "[layout]") {
    const Config config = format("default");
    CHECK(bits_of<Slot>(config) == 6 + 14 + 14);
    CHECK(bits_of<Ray>(config) == 6 + 3 * 18 + 3 * 20 + 3 * 17 + 3 * 5);
    CHECK(bits_of<Node>(config) == 3 * 18 + 3 * 5 + 24 + 8 * 3 + 2 * 24 * 8);
    CHECK(bits_of<PrimData>(config) == 9 * 18 + 32);
    CHECK(bits_of<NodeReq>(config) == 6 + 24);
    CHECK(bits_of<Done>(config) == 6);
    CHECK(bits_of<HitOut>(config) == 28 + 6 + 1 + 32 + 24 + 17 + 17);
}

TEST_CASE("links have the payloads and names that lockstep and reports use", "[layout]") {
    STATIC_REQUIRE(std::tuple_size_v<LinkPayloads> == link_count);
    for (std::size_t a = 0; a < link_count; ++a)
        for (std::size_t b = 0; b < a; ++b) REQUIRE(std::string(link_infos[a].name) != link_infos[b].name);
}

TEST_CASE("two records of hits fit into a line of memory in the chip with the widest fields", "[hits]") {
    struct Lattice {
        int coord, dir, origin;   // bits; wider ones are refused
    };
    int most = 0;
    for (const Lattice& l : {Lattice{20, 20, 10}, {20, 19, 10}, {18, 24, 12}})
        for (const bool planes : {false, true})
            for (const int levels : {1, 2}) {
                Config c = test::format("default");
                c.coord_bits = l.coord, c.dir_bits = l.dir, c.origin_bits = l.origin;
                c.t_frac_bits = 8, c.pixel_bits = max_pixel_bits, c.bary_bits = planes ? 19 : 24;
                c.contexts = 1024, c.pipelines = 8;
                c.shading = c.spheres = c.pixel_writes = true;
                c.planes = planes, c.levels = levels, c.source = RaySource::stream;
                REQUIRE_NOTHROW(check_config(c, "test"));
                CHECK(bits_of<HitRecord>(c) * hits_of_line(c) <= line_bits);
                most = std::max(most, bits_of<HitRecord>(c));
            }
    CHECK(most == 191);   // docs/guide/streams.md
}
