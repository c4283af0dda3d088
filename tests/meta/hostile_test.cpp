// RTL that says what no machine can mean: nothing crashes, the first divergence is named, and an RTL that
// runs alone is refused in one sentence. One module holds all faults, each asleep until its number is called.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "sim/load/load.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "sim/view/report/lockstep.hpp"
#include "tests/meta/campaign/schema.hpp"

using namespace rayclock;
namespace fs = std::filesystem;

namespace {

struct Hostile {
    int number;
    const char *file, *old, *fresh;
    /// The message that refuses this RTL when it runs alone. Null if it makes a frame or stops.
    const char* alone;
};

const Hostile hostile[] = {
    {1, "rc_top.sv", "= {client, client_miss};",
     "= {client, rc_mut::id == 1 ? client_miss | {rc_pkg::AddrBits{1'b1}} : CALLED};",
     "the memory image has"},
    {2, "", "", "rc_mut::id == 2 ? client_miss & {rc_pkg::AddrBits{1'b1}} : client_miss", "not answered yet"},
    {3, "unit/sched/rc_sched.sv", "= {place, pixel_i};", "= {rc_mut::id == 3 ? ~place : CALLED, pixel_i};",
     "outside the picture"},
    {4, "", "", "rc_mut::id == 4 ? place & '0 : place", "for the second time"},
    {5, "unit/list/rc_list.sv", "= is_found ? done_hit :",
     "= is_found ? done_hit | {$bits(done_hit){rc_mut::id == 5}} :", "and the scene has"},
    {6, "unit/list/rc_list.sv", "closest_o.ray   = done_i.ray;",
     "closest_o.ray   = done_i.ray ^ {rc_pkg::RayBits{rc_mut::id == 6}};", nullptr},
    {7, "unit/trav/rc_trav.sv", "rsp1_children.base   = rsp1.base;",
     "rsp1_children.base   = rsp1.base | {rc_mut::id == 7, {(rc_pkg::AddrBits-1){1'b0}}};",
     "the memory image has"},
    {8, "unit/sched/rc_dispatch.sv", "tile_o.x     = x_q;",
     "tile_o.x     = x_q ^ {TileCoordBits{rc_mut::id == 8}};", nullptr},
    {9, "unit/sched/rc_sched.sv", "slot_o.ray   = slot_ray;",
     "slot_o.ray   = slot_ray ^ {rc_pkg::RayBits{rc_mut::id == 9}};", nullptr},
    {10, "unit/sched/rc_sched.sv", "assign cause_o = give ?",
     "assign cause_o = rc_mut::id == 10 ? 3'd7 : give ?", nullptr},
    {11, "mem/rc_arbiter.sv", "<< source_o;", "<< (rc_mut::id == 11 ? ~source_o : source_o);", nullptr},
};

/// While it exists, the RTL is the copy with all faults, and call() selects one. The copy always has the same
/// path, because the path of the selecting file is part of the RTL's text and so of the cache's key.
class HostileRtl {
public:
    HostileRtl() : folder_(HOSTILE_FOLDER), caller_(folder_ / "called") {
        campaign::write_schema(RAYCLOCK_SOURCE_DIR, "rtl", folder_ / "rtl", {}, campaign::Language::verilog,
                               caller_);
        for (const Hostile& h : hostile) {
            if (!*h.file) continue;
            std::string fresh = h.fresh, text = campaign::text_of(folder_ / "rtl" / h.file);
            if (const std::size_t next = fresh.find("CALLED"); next != std::string::npos)
                fresh.replace(next, 6, (&h + 1)->fresh);
            const std::size_t at = text.find(h.old);
            REQUIRE(at != std::string::npos);
            REQUIRE(text.find(h.old, at + 1) == std::string::npos);
            std::ofstream(folder_ / "rtl" / h.file) << text.replace(at, std::string(h.old).size(), fresh);
        }
        caller_.call(0);
        setenv("RAYCLOCK_RTL", (folder_ / "rtl").c_str(), 1);
    }
    ~HostileRtl() {
        unsetenv("RAYCLOCK_RTL");
        fs::remove_all(folder_);
    }
    HostileRtl(const HostileRtl&) = delete;
    void call(int number) const { caller_.call(number); }

private:
    fs::path folder_;
    campaign::Caller caller_;
};

Job small_job() {
    Config config = named_config("small");
    Scene scene = load_scene("icosphere:2");
    scene.camera = fit_camera(scene, 4.0 / 3);
    return make_job(scene, *scene.camera, {24, 18}, config);
}

}   // namespace

TEST_CASE("nothing that faulty RTL sends crashes the program", "[long]") {
    const Job job = small_job();
    const HostileRtl rtl;
    REQUIRE(run_lockstep(job).agrees());
    for (const Hostile& h : hostile) {
        INFO("fault " << h.number);
        rtl.call(h.number);
        LockstepResult result;
        REQUIRE_NOTHROW(result = run_lockstep(job));
        INFO(lockstep_lines(result));
        CHECK_FALSE(result.agrees());
        CHECK((result.first || result.counter));
        if (result.first) CHECK_FALSE(result.first->got.empty());
        for (const Hit& hit : result.rtl.hits.hits)
            CHECK((hit.primitive == no_primitive || hit.primitive < job.image.primitives));
        if (h.alone) CHECK_THROWS_WITH(run_rtl(job), Catch::Contains(h.alone));
        if (h.number == 10) CHECK(result.counter->unit == "sched");
    }

    // The program shades what it was given, and judges it.
    rtl.call(5);
    const fs::path out = fs::temp_directory_path() / ("rayclock-hostile-" + std::to_string(getpid()));
    const int status = std::system((std::string("'") + RAYCLOCK_PROGRAM +
                                    "' verify icosphere:2 --size 24x18 --config small --no-wave > '" +
                                    out.string() + "' 2>&1")
                                       .c_str());
    const std::string said = campaign::text_of(out);
    fs::remove(out);
    INFO(said);
    CHECK(status == 1 << 8);
    CHECK(said.find("FIRST DIVERGENCE") != std::string::npos);
    CHECK(said.find("FAILED") != std::string::npos);
}
