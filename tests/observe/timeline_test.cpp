// Timelines, read by protobuf's own decoder and by a reader of the published Kanata rules, and counted
// against the machine's accounts.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "model/base/error.hpp"
#include "model/base/split.hpp"
#include "sim/view/timeline/timeline.hpp"
#include "sim/view/wave/fst.hpp"
#include "tests/observe/watched.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

struct Seen {
    FrameCosts costs;
    Timeline timeline;
};
Seen seen(const Watching& made, const Watched& w, const TimelineChoice& choice) {
    Timeline timeline(made.job.config, made.job.size, choice);
    FrameCosts costs = observe(made.job.config, 66000, made.traces, w.disturbance, 0, &timeline);
    timeline.finish();
    return {std::move(costs), std::move(timeline)};
}
TimelineChoice cycles(std::uint64_t first, std::uint64_t last) {
    TimelineChoice choice;
    choice.first = first, choice.last = last, choice.whole_frame = false;
    return choice;
}

/// A file in Kanata 0004, read line by line. Every rule of the format's description is checked.
class KanataReader {
public:
    struct Stage {
        int lane = 0;
        std::string name;
        std::uint64_t first = 0, last = 0;
    };
    std::map<int, std::vector<Stage>> stages;   ///< of each instruction
    std::set<int> retired;
    int dependencies = 0;

    explicit KanataReader(const std::string& text) {
        std::istringstream in(text);
        std::string line;
        REQUIRE(std::getline(in, line));
        REQUIRE(line == "Kanata\t0004");
        REQUIRE(std::getline(in, line));
        REQUIRE(line.starts_with("C=\t"));
        now_ = std::stoull(line.substr(3));
        while (std::getline(in, line)) read(split(line, '\t'));
        CHECK(open_.empty());
        CHECK(retired.size() == stages.size());
    }

private:
    void read(const std::vector<std::string>& words) {
        const std::string& command = words.at(0);
        if (command == "C") {
            REQUIRE(std::stoull(words.at(1)) > 0);
            now_ += std::stoull(words.at(1));
            return;
        }
        const int id = std::stoi(words.at(1));
        if (command == "I") {
            REQUIRE(id == int(stages.size()));   // sequential
            stages[id];
            return;
        }
        REQUIRE(stages.contains(id));
        REQUIRE_FALSE(retired.contains(id));
        if (command == "S") {
            const auto key = std::pair(id, std::stoi(words.at(2)));
            REQUIRE_FALSE(open_.contains(key));
            open_[key] = {key.second, words.at(3), now_, 0};
        } else if (command == "E") {
            const auto key = std::pair(id, std::stoi(words.at(2)));
            REQUIRE(open_.contains(key));
            Stage stage = open_[key];
            REQUIRE(stage.name == words.at(3));
            stage.last = now_;
            REQUIRE(stage.first < stage.last);
            stages[id].push_back(stage);
            open_.erase(key);
        } else if (command == "W") {
            REQUIRE(stages.contains(std::stoi(words.at(2))));
            ++dependencies;
        } else if (command == "R") {
            REQUIRE(words.at(3) == "0");
            retired.insert(id);
        } else {
            REQUIRE(command == "L");
            REQUIRE((words.at(2) == "0" || words.at(2) == "1"));
        }
    }
    std::uint64_t now_ = 0;
    std::map<std::pair<int, int>, Stage> open_;
};

/// Slices of a Perfetto trace by the name of their track, as protoc sees them.
struct Slice {
    std::string name;
    std::uint64_t first = 0, last = 0;
};
const char* description = R"(syntax = "proto2";
message Trace { repeated TracePacket packet = 1; }
message TracePacket { optional uint64 timestamp = 8; optional uint32 trusted_packet_sequence_id = 10;
  optional TrackEvent track_event = 11; optional TrackDescriptor track_descriptor = 60; }
message TrackDescriptor { optional uint64 uuid = 1; optional string name = 2; optional ProcessDescriptor process = 3;
  optional ThreadDescriptor thread = 4; optional uint64 parent_uuid = 5; }
message ProcessDescriptor { optional int32 pid = 1; optional string process_name = 6; }
message ThreadDescriptor { optional int32 pid = 1; optional int32 tid = 2; optional string thread_name = 5; }
message DebugAnnotation { optional uint64 uint_value = 3; optional string string_value = 6; optional string name = 10; }
message TrackEvent { repeated DebugAnnotation debug_annotations = 4; optional int32 type = 9;
  optional uint64 track_uuid = 11; repeated string categories = 22; optional string name = 23; }
)";
bool has_protoc() { return std::system("command -v protoc > /dev/null 2>&1") == 0; }

std::map<std::string, std::vector<Slice>> decoded(const std::string& bytes) {
    const std::string name =
        (std::filesystem::temp_directory_path() / ("rayclock_timeline_" + std::to_string(getpid()))).string();
    std::ofstream(name + ".proto") << description;
    std::ofstream(name + ".pftrace", std::ios::binary) << bytes;
    const std::string folder = name.substr(0, name.rfind('/'));
    REQUIRE(std::system(("protoc --decode=Trace -I " + folder + " " + name + ".proto < " + name +
                         ".pftrace > " + name + ".txt")
                            .c_str()) == 0);
    std::ifstream in(name + ".txt");
    std::map<std::string, std::string> tracks;
    std::map<std::string, std::vector<Slice>> open, done;
    std::string line, uuid, track, timestamp, type, slice, key, value;
    std::uint64_t now = 0;
    while (std::getline(in, line)) {
        INFO(line);
        // Unknown fields are shown by their number.
        REQUIRE_FALSE(std::isdigit(static_cast<unsigned char>(line[line.find_first_not_of(' ')])));
        if (line == "packet {") uuid = track = timestamp = type = slice = "";
        std::istringstream(line) >> key >> value;
        const auto quoted = [&] {
            return line.substr(line.find('"') + 1, line.rfind('"') - line.find('"') - 1);
        };
        if (key == "uuid:" || key == "track_uuid:") uuid = value;
        if (key == "thread_name:") tracks[uuid] = quoted();
        if (key == "timestamp:") timestamp = value;
        if (key == "type:") type = value;
        if (key == "name:" && line.starts_with("    name:")) slice = quoted();
        if (line != "}" || type.empty()) continue;
        const std::uint64_t at = std::stoull(timestamp);
        REQUIRE(at >= now);   // in order
        now = at;
        REQUIRE(tracks.contains(uuid));
        if (type == "1") {
            open[uuid].push_back({slice, at, 0});
        } else {
            REQUIRE(type == "2");
            REQUIRE_FALSE(open[uuid].empty());
            open[uuid].back().last = at;
            done[tracks[uuid]].push_back(open[uuid].back());
            open[uuid].pop_back();
        }
    }
    for (const auto& [id, slices] : open) CHECK(slices.empty());
    for (const char* ending : {".proto", ".pftrace", ".txt"}) std::remove((name + ending).c_str());
    return done;
}

/// A waveform of texts, read by GTKWave's code: for each signal and each of its texts, the number of cycles.
struct WavesOfText {
    std::map<std::string, std::map<std::string, std::uint64_t>> cycles;
    WavesOfText(const std::string& bytes, std::uint64_t last) {
        const auto file =
            std::filesystem::temp_directory_path() / ("rayclock-timeline-" + std::to_string(getpid()));
        std::ofstream(file, std::ios::binary) << bytes;
        std::string path;
        std::map<std::uint32_t, std::string> names;
        std::map<std::uint32_t, std::pair<std::uint64_t, std::string>> now;
        const auto count = [&](std::uint32_t signal, std::uint64_t until) {
            const auto& [since, text] = now[signal];
            if (!text.empty()) cycles[names[signal]][text] += until - since;
        };
        FstVisitor visitor;
        visitor.open_scope = [&](const std::string& name) { path += name + "."; };
        visitor.close_scope = [&] {
            path.pop_back();
            path.resize(path.rfind('.') + 1);
        };
        visitor.signal = [&](std::uint32_t signal, const std::string& name, int, bool) {
            if (name != "cycle[39:0]") names[signal] = path + name;
        };
        visitor.change = [&](std::uint64_t time, std::uint32_t signal, std::string_view value) {
            if (!names.contains(signal)) return;
            count(signal, time / 10);
            now[signal] = {time / 10, std::string(value)};
        };
        read_fst(file, visitor);
        for (const auto& [signal, name] : names) count(signal, last);
        std::filesystem::remove(file);
    }
};

}   // namespace

TEST_CASE("a timeline of a whole frame has every stay, and every unit's cycles by cause") {
    for (const Watched& w : watched_machines()) {
        INFO(w.scene << ", case " << (&w - watched_machines().data()));
        const Watching made = watching(w, {13, 9});
        const Seen s = seen(made, w, cycles(0, 1'000'000));
        std::map<std::size_t, std::uint64_t> stays, places;
        for (const TimelineRay& ray : s.timeline.rays)
            for (const TimelineStay& stay : ray.stays) {
                ++stays[stay.place];
                CHECK(stay.first < stay.last);
                places[stay.place] += stay.last - stay.first;
            }
        const FrameCosts::Sums sums = s.costs.total();
        CHECK(s.timeline.rays.size() == sums.rays);
        auto visits = stays[index(Unit::xform)];
        for (const NodeUnit& u : node_units) visits += stays[index(u.unit)];
        CHECK(visits == (made.job.config.is_list() ? 0 : sums.visits));
        CHECK(stays[index(Unit::tri)] == sums.tests);
        std::uint64_t all = 0;
        for (const auto& [place, cycles_there] : places) all += cycles_there;
        CHECK(all == sums.cycles);
        Accounts accounts;
        for (const UnitSpan& span : s.timeline.units)
            accounts.units[index(span.unit)][span.code] += span.last - span.first;
        CHECK(accounts == s.costs.accounts);
    }
}

TEST_CASE("a stretch of time holds what lies in it") {
    const Watched& w = watched_machines()[4];
    const Watching made = watching(w, {13, 9});
    const Seen whole = seen(made, w, cycles(0, 1'000'000)), some = seen(made, w, cycles(300, 500));
    std::uint64_t expected = 0, found = 0, units = 0;
    for (const TimelineRay& ray : whole.timeline.rays)
        for (const TimelineStay& stay : ray.stays)
            if (stay.first < 500 && stay.last > 300)
                expected +=
                    std::min<std::uint64_t>(stay.last, 500) - std::max<std::uint64_t>(stay.first, 300);
    for (const TimelineRay& ray : some.timeline.rays)
        for (const TimelineStay& stay : ray.stays) found += stay.last - stay.first;
    for (const UnitSpan& span : some.timeline.units) units += span.last - span.first;
    CHECK(found == expected);
    CHECK(units == 200 * 13);   // units of a chip that shades, without l2
    TimelineChoice choice;
    choice.x0 = choice.x1 = 6, choice.y0 = 2, choice.y1 = 4;
    choice.purposes = {false, true, false, false};
    const Seen shadows = seen(made, w, choice);
    CHECK(shadows.timeline.units.empty());
    REQUIRE_FALSE(shadows.timeline.rays.empty());
    for (const TimelineRay& ray : shadows.timeline.rays) {
        CHECK(ray.purpose == RayPurpose::shadow);
        CHECK((ray.pixel % 13 == 6 && ray.pixel / 13 >= 2 && ray.pixel / 13 <= 4));
    }
}

TEST_CASE("a Kanata file keeps the format's rules and says what the timeline says") {
    for (const std::size_t i : {1, 4}) {
        const Watched& w = watched_machines()[i];
        const Watching made = watching(w, {13, 9});
        const Seen s = seen(made, w, cycles(0, 1'000'000));
        const KanataReader read(kanata(s.timeline));
        REQUIRE(read.stages.size() == s.timeline.rays.size());
        std::uint64_t boxes = 0, memory = 0, lane0 = 0;
        for (const auto& [id, stages] : read.stages)
            for (const KanataReader::Stage& stage : stages) {
                boxes += stage.name == "box";
                memory += stage.lane == 1 && stage.name == "for_memory";
                if (stage.lane == 0) lane0 += stage.last - stage.first;
            }
        CHECK(boxes == s.costs.total().visits);
        CHECK(memory == s.costs.total().misses);
        CHECK(lane0 == s.costs.total().cycles);
        CHECK(std::uint64_t(read.dependencies) == s.costs.total().rays - 13 * 9);
    }
}

TEST_CASE("protobuf's decoder reads a Perfetto trace, and its slices are the accounts") {
    if (!has_protoc()) {
        WARN("protoc is not installed");
        return;
    }
    const Watched& w = watched_machines()[4];
    const Watching made = watching(w, {13, 9});
    const Seen s = seen(made, w, cycles(0, 1'000'000));
    const auto tracks = decoded(perfetto(s.timeline));
    for (std::size_t u = 0; u < unit_count; ++u) {
        if (!is_there(Unit(u), made.job.config)) continue;
        INFO(unit_infos[u].name);
        REQUIRE(tracks.contains(unit_infos[u].name));
        std::map<std::string, std::uint64_t> by_cause;
        for (const Slice& slice : tracks.at(unit_infos[u].name))
            by_cause[slice.name] += slice.last - slice.first;
        for (std::size_t c = 0; c < cause_count; ++c)
            if (s.costs.accounts.units[u][c] > 0)
                CHECK(by_cause[cause_name(Unit(u), c)] == s.costs.accounts.units[u][c]);
    }
    std::uint64_t boxes = 0, rays = 0;
    for (const auto& [track, slices] : tracks)
        for (const Slice& slice : slices)
            if (track.starts_with("context "))
                boxes += slice.name == "box", rays += slice.name.starts_with("pixel ");
    CHECK(boxes == s.costs.total().visits);
    CHECK(rays == s.costs.total().rays);
}

TEST_CASE("GTKWave's reader reads a timeline, and its states are the accounts") {
    for (const std::size_t i : {1, 4}) {
        const Watched& w = watched_machines()[i];
        const Watching made = watching(w, {13, 9});
        const Seen s = seen(made, w, cycles(0, 1'000'000));
        const WavesOfText read(fst(s.timeline), s.costs.cycles);
        Accounts accounts;
        std::uint64_t under_way = 0;
        for (const auto& [name, cycles] : read.cycles)
            if (name.ends_with(".place"))
                for (const auto& [place, count] : cycles) under_way += place == "-" ? 0 : count;
        for (std::size_t u = 0; u < unit_count; ++u)
            for (std::size_t c = 0; c < cause_count; ++c)
                for (const auto& [name, cycles] : read.cycles)
                    if (name.ends_with(std::string(".") + unit_infos[u].name) &&
                        cycles.contains(cause_name(Unit(u), c)))
                        accounts.units[u][c] += cycles.at(cause_name(Unit(u), c));
        CHECK(accounts == s.costs.accounts);
        CHECK(under_way == s.costs.total().cycles);
        // The save file shows what is there.
        std::istringstream view(fst_view(s.timeline, "folder/a.fst"));
        std::size_t shown = 0;
        for (std::string line; std::getline(view, line);)
            if (line.starts_with("pipeline_") || line.starts_with("rays_") || line.starts_with("shared.")) {
                CHECK(read.cycles.contains(line));
                ++shown;
            }
        CHECK(shown == read.cycles.size());
    }
}

TEST_CASE("a timeline's file is written by its ending") {
    CHECK_NOTHROW(timeline_writer("a.fst"));
    CHECK_NOTHROW(timeline_writer("a.kanata"));
    CHECK_NOTHROW(timeline_writer("a.pftrace"));
    CHECK_THROWS_AS(timeline_writer("a.vcd"), UserError);
}
