// Writes a timeline as Perfetto's TrackEvent messages in protobuf's wire format. It writes about a dozen
// fields, so it needs no generated code. The field numbers are those of perfetto/protos/perfetto/trace.
#include <algorithm>

#include <fmt/format.h>

#include "sim/view/timeline/timeline.hpp"

namespace rayclock {

namespace {

class Message {
public:
    Message& number(std::uint32_t field, std::uint64_t value) {
        varint(field << 3);
        varint(value);
        return *this;
    }
    Message& text(std::uint32_t field, std::string_view value) {
        varint(field << 3 | 2);
        varint(value.size());
        bytes_ += value;
        return *this;
    }
    Message& message(std::uint32_t field, const Message& inner) { return text(field, inner.bytes_); }
    const std::string& bytes() const { return bytes_; }

private:
    void varint(std::uint64_t value) {
        for (; value >= 128; value >>= 7) bytes_ += char((value & 127) | 128);
        bytes_ += char(value);
    }
    std::string bytes_;
};

namespace packet {   // TracePacket
constexpr std::uint32_t timestamp = 8, sequence = 10, event = 11, track = 60;
}
namespace track {   // TrackDescriptor, ProcessDescriptor, ThreadDescriptor
constexpr std::uint32_t uuid = 1, process = 3, thread = 4, parent = 5;
constexpr std::uint32_t process_pid = 1, process_name = 6, thread_pid = 1, thread_tid = 2, thread_name = 5;
}   // namespace track
namespace event {   // TrackEvent, DebugAnnotation
constexpr std::uint32_t annotations = 4, type = 9, track = 11, category = 22, name = 23;
constexpr std::uint32_t begin = 1, end = 2;
constexpr std::uint32_t annotation_number = 3, annotation_text = 6, annotation_name = 10;
}   // namespace event

class Writer {
public:
    explicit Writer(const Timeline& timeline) : timeline_(timeline) {}

    std::string write() {
        const int pipelines = timeline_.config().pipelines;
        if (!timeline_.units.empty()) {
            for (int p = -1; p < pipelines; ++p)
                process(unit_process(p),
                        p < 0 ? "units that all share" : fmt::format("units of pipeline {}", p));
            for (const UnitSpan& span : timeline_.units) unit_track(span);
        }
        for (int p = 0; p < pipelines; ++p) process(ray_process(p), fmt::format("rays of pipeline {}", p));
        for (const TimelineRay& ray : timeline_.rays) context_track(ray);
        for (const UnitSpan& span : timeline_.units)
            slice(unit_uuid(span), span.first, span.last, cause_name(span.unit, span.code), "unit");
        for (const TimelineRay& ray : timeline_.rays) show(ray);
        return in_order();
    }

private:
    static std::uint32_t unit_process(int pipeline) { return std::uint32_t(pipeline + 2); }
    std::uint32_t ray_process(int pipeline) const {
        return std::uint32_t(timeline_.config().pipelines + 2 + pipeline);
    }
    static std::uint64_t process_uuid(std::uint32_t pid) { return pid; }
    static std::uint64_t unit_uuid(const UnitSpan& span) {
        return std::uint64_t(unit_process(span.pipeline)) << 20 | (index(span.unit) + 1);
    }
    std::uint64_t context_uuid(const TimelineRay& ray) const {
        return std::uint64_t(ray_process(ray.pipeline)) << 20 | (ray.context + 1);
    }

    void process(std::uint32_t pid, const std::string& name) {
        describe(process_uuid(pid),
                 Message()
                     .number(track::uuid, process_uuid(pid))
                     .message(track::process,
                              Message().number(track::process_pid, pid).text(track::process_name, name)));
    }
    void thread(std::uint64_t uuid, std::uint32_t pid, std::uint32_t tid, const std::string& name) {
        describe(uuid, Message()
                           .number(track::uuid, uuid)
                           .number(track::parent, process_uuid(pid))
                           .message(track::thread, Message()
                                                       .number(track::thread_pid, pid)
                                                       .number(track::thread_tid, tid)
                                                       .text(track::thread_name, name)));
    }
    void unit_track(const UnitSpan& span) {
        thread(unit_uuid(span), unit_process(span.pipeline),
               unit_process(span.pipeline) * 1000 + std::uint32_t(index(span.unit)),
               unit_infos[index(span.unit)].name);
    }
    void context_track(const TimelineRay& ray) {
        thread(context_uuid(ray), ray_process(ray.pipeline), ray_process(ray.pipeline) * 1000 + ray.context,
               fmt::format("context {}", ray.context));
    }
    /// Writes the descriptor of each track once.
    void describe(std::uint64_t uuid, const Message& descriptor) {
        if (std::find(described_.begin(), described_.end(), uuid) != described_.end()) return;
        described_.push_back(uuid);
        out_ += packet_of(Message().number(packet::sequence, 1).message(packet::track, descriptor));
    }
    static std::string packet_of(const Message& packet) { return Message().message(1, packet).bytes(); }

    /// `depth` orders slices that share a cycle: an inner slice begins after the slice that holds it, and
    /// ends before it.
    void slice(std::uint64_t uuid, std::uint64_t first, std::uint64_t last, const std::string& name,
               const char* category, int depth = 0, const std::vector<Message>& annotations = {}) {
        Message begin = Message().number(event::type, event::begin).number(event::track, uuid);
        begin.text(event::category, category).text(event::name, name);
        for (const Message& annotation : annotations) begin.message(event::annotations, annotation);
        const Message end = Message().number(event::type, event::end).number(event::track, uuid);
        add(first, 1 + depth, begin);
        add(last, -depth, end);
    }
    void add(std::uint64_t cycle, int rank, const Message& what) {
        packets_.push_back({cycle, rank,
                            packet_of(Message()
                                          .number(packet::timestamp, cycle)
                                          .number(packet::sequence, 1)
                                          .message(packet::event, what))});
    }
    static Message note(const char* name, std::uint64_t value) {
        return Message().text(event::annotation_name, name).number(event::annotation_number, value);
    }
    static Message note(const char* name, const char* value) {
        return Message().text(event::annotation_name, name).text(event::annotation_text, value);
    }

    void show(const TimelineRay& ray) {
        const std::uint64_t uuid = context_uuid(ray);
        const auto width = std::uint32_t(timeline_.width());
        slice(uuid, ray.stays.front().first, ray.stays.back().last,
              fmt::format("pixel {},{} ray {} {}", ray.pixel % width, ray.pixel / width, ray.ray,
                          purpose_names[std::size_t(ray.purpose)]),
              "ray");
        for (const TimelineStay& stay : ray.stays) {
            std::vector<Message> notes;
            constexpr const char* outcomes[] = {"hit", "miss", "merge"};
            if (stay.lookup)
                notes = {note("address", stay.addr), note("look-up", outcomes[std::size_t(*stay.lookup)])};
            slice(uuid, stay.first, stay.last, place_name(stay.place), "stay", 1, notes);
            if (stay.wait_first < stay.last)
                slice(uuid, stay.wait_first, stay.last, "waits for " + stay.waits_for, "wait", 2);
        }
    }

    std::string in_order() {
        // Within a cycle ends precede begins. Inner slices end before outer ones, and outer slices begin
        // before inner ones.
        std::stable_sort(packets_.begin(), packets_.end(), [](const Packet& a, const Packet& b) {
            return a.cycle != b.cycle ? a.cycle < b.cycle : a.rank < b.rank;
        });
        for (const Packet& packet : packets_) out_ += packet.bytes;
        return std::move(out_);
    }

    struct Packet {
        std::uint64_t cycle = 0;
        int rank = 0;
        std::string bytes;
    };
    const Timeline& timeline_;
    std::string out_;
    std::vector<std::uint64_t> described_;
    std::vector<Packet> packets_;
};

}   // namespace

std::string perfetto(const Timeline& timeline) { return Writer(timeline).write(); }

}   // namespace rayclock
