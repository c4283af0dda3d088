// Generates rc_pkg.sv from the configuration and from the tables of model/core, engine and machine.
#include "sim/run/gen/rc_pkg.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "model/core/parameters.hpp"
#include "model/core/stages.hpp"
#include "model/engine/spheres/tables.hpp"
#include "model/machine/links.hpp"
#include "model/mem/cache.hpp"
#include "model/unit/shade/state.hpp"
#include "model/fixed/tables.hpp"
#include "model/unit/tex/texel.hpp"
#include "model/unit/trav/children.hpp"
#include "sim/run/gen/registers.hpp"

namespace rayclock {

namespace {

/// Writes a payload's fields as members of a packed struct: all, or only those with one of the given names.
class StructVisitor {
public:
    explicit StructVisitor(std::vector<std::string_view> only = {}) : only_(std::move(only)) {}
    std::string text;
    int bits = 0;
    template <class T> void operator()(const char* name, const T&, int width) {
        member(name, width, std::is_signed_v<T> || sizeof(T) > 8);
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&, int width, int count) {
        member(name, width * count, false);
    }

private:
    std::vector<std::string_view> only_;
    void member(const char* name, int width, bool is_signed) {
        if (!only_.empty() && std::find(only_.begin(), only_.end(), name) == only_.end()) return;
        bits += width;
        text += width == 1
                    ? fmt::format("    logic {};\n", name)
                    : fmt::format("    logic {}[{}:0] {};\n", is_signed ? "signed " : "", width - 1, name);
    }
};

/// Collects the names of a payload's fields.
struct NameVisitor {
    std::set<std::string_view> names;
    template <class T, class... Widths> void operator()(const char* name, const T&, Widths...) {
        names.insert(name);
    }
};

/// Throws if a name is not a field of the payload, in a chip with all units or in one with the sheared test.
template <class Payload> void check_names(const std::vector<std::string_view>& names) {
    NameVisitor known;
    Config all;
    all.shading = all.spheres = all.planes = all.smooth = all.refraction = all.supersampling = all.horizon =
        all.textures = true;
    all.panes = max_panes, all.levels = 2;
    Config sheared;
    sheared.primitive_test = PrimitiveTest::sheared;
    for (const Config& config : {all, sheared}) Payload{}.fields(known, config);
    for (const std::string_view name : names)
        if (!known.names.count(name)) throw std::logic_error("no payload has a field " + std::string(name));
}

/// Returns entries as one vector, entry 0 in the lowest bits.
std::string list_text(const char* name, const std::vector<std::string>& entries, int width) {
    std::string text =
        fmt::format("  localparam logic [{}:0] {} = {{", int(entries.size()) * width - 1, name);
    for (std::size_t i = entries.size(); i-- > 0;) {
        if ((entries.size() - 1 - i) % 8 == 0) text += "\n   ";
        text += fmt::format(" {}'{}{}", width, entries[i], i > 0 ? "," : "");
    }
    return text + "};\n";
}

/// Converts "node_miss" to the style of Verilog's constants: "NodeMiss".
std::string camel(std::string_view name) {
    std::string text;
    bool upper = true;
    for (const char c : name) {
        if (c != '_') text += upper ? char(std::toupper(static_cast<unsigned char>(c))) : c;
        upper = c == '_';
    }
    return text;
}

/// Returns the constants of the host's registers: their addresses, the values that identify the chip, and the
/// positions of a frame's words in frame_t.
std::string host_constants(const Config& config) {
    const auto constant = [](const std::string& name, std::uint32_t value) {
        return fmt::format("  localparam int unsigned {} = {};\n", name, value);
    };
    const auto list = [](const char* name, const std::vector<std::uint32_t>& entries, int width) {
        std::vector<std::string> texts;
        for (const std::uint32_t entry : entries) texts.push_back(fmt::format("d{}", entry));
        return list_text(name, texts, width);
    };
    std::string text = "\n  // The host's registers: sim/run/gen/registers.hpp, docs/machine/chip.md.\n";
    text += constant("Magic", host_magic) + constant("Version", host_version);
    for (const HostRegister& r : host_registers())
        if (r.constant) text += constant(std::string("Reg") + r.constant, r.address);
    text += constant("RegParameters", parameter_base) + constant("RegFrame", frame_base);
    text += constant("RegCounters", counter_base);
    text += constant("RegAddrBits", address_bits) + constant("CounterNumberBits", counter_number_bits);
    std::vector<std::uint32_t> values, at, bits;
    for (const HostParameter& p : host_parameters(config)) values.push_back(p.value);
    for (const FrameWord& word : frame_words(config)) {
        at.push_back(std::uint32_t(word.at));
        bits.push_back(std::uint32_t(word.bits));
    }
    text += constant("Parameters", std::uint32_t(values.size())) + list("ParameterValues", values, 32);
    text += constant("FrameWords", std::uint32_t(at.size())) + list("FrameAt", at, 16);
    text += list("FrameBits", bits, 16);
    std::vector<std::uint32_t> units;   // the shared ones, then those of a pipeline
    for (std::size_t u = 0; u < shared_units; ++u)
        units.push_back(is_there(Unit(pipeline_units + u), config));
    for (std::size_t u = 0; u < pipeline_units; ++u) units.push_back(is_there(Unit(u), config));
    text += constant("CounterBits", counter_bits) + constant("PipelineUnits", pipeline_units);
    for (std::size_t u = 0; u < pipeline_units; ++u)   // the place of a unit's cause; node units follow
        if (!is_node_unit(Unit(u))) text += constant(camel(unit_infos[u].name) + "Unit", std::uint32_t(u));
    text += constant("NodeUnit", std::uint32_t(index(node_unit(config.engine()).unit)));
    text += constant("MeshUnit", std::uint32_t(index(node_unit(config.lower_engine()).unit)));
    return text + constant("SharedUnits", shared_units) + list("UnitsThere", units, 1);
}

class Package {
public:
    explicit Package(const Config& config) : config_(config) {}

    void parameters() {
        for (const Parameter& p : rayclock::parameters())
            if (p.in_rtl && p.type == Parameter::Type::flag)
                flag(camel(p.key), p.get(config_) != 0);
            else if (p.in_rtl)
                constant(camel(p.key), p.is("structure")        ? int(config_.engine())
                                       : p.is("mesh_structure") ? int(config_.lower_engine())
                                                                : p.get(config_));
        constant("NodeWords", config_.node_line / line_bytes);
        constant("PrimWords", config_.prim_line / line_bytes);
        constant("SurfWords", config_.surf_line / line_bytes);
        constant("StreamWords", config_.stream_line / line_bytes);
        constant("TexWords", config_.tex_line / line_bytes);
        constant("L2Words", config_.l2_line / line_bytes);
    }
    void constant(const std::string& name, int value) {
        text_ += fmt::format("  localparam int unsigned {} = {};\n", name, value);
    }
    void flag(const std::string& name, bool value) {
        text_ += fmt::format("  localparam bit {} = {};\n", name, int(value));
    }
    /// Adds a constant that has a width.
    void bits(const char* name, int width, std::uint64_t value) {
        text_ += fmt::format("  localparam logic [{}:0] {} = {}'h{:x};\n", width - 1, name, width, value);
    }
    void say(const char* comment) { text_ += fmt::format("\n  // {}\n", comment); }

    /// Adds names for values. The fields that hold them are plain vectors, since Yosys 0.23 has no casts to
    /// enums.
    template <class Value> void enumeration(const std::string& type, const std::string& prefix, int bits,
                                            const std::vector<std::pair<std::string, Value>>& values) {
        text_ += fmt::format("  typedef enum logic [{}:0] {{", bits - 1);
        for (const auto& [name, value] : values)
            text_ += fmt::format("{}\n    {}{} = {}'d{}", name == values[0].first ? "" : ",", prefix, name,
                                 bits, unsigned(value));
        text_ += fmt::format("\n  }} {};\n", type);
    }
    /// Adds the codes by which a unit reports its activity in a cycle.
    void causes(const char* name, const UnitInfo& unit) {
        constexpr std::array kinds{"", "Busy", "Starved", "Stalled"};
        std::vector<std::pair<std::string, std::size_t>> names;
        for (const Cause& cause : unit.causes)
            if (cause.kind != CauseKind::none)
                names.emplace_back(kinds[std::size_t(cause.kind)] + camel(cause.name), names.size());
        enumeration(fmt::format("{}_cause_e", name), camel(name), cause_bits, names);
    }
    template <class Payload> void record(const char* name) {
        StructVisitor v;
        Payload{}.fields(v, config_);
        record(name, v);
    }
    /// Adds a record of those fields of a payload that have one of these names, in the payload's order.
    /// Fields that the configuration does not have are left out.
    template <class Payload> void part(const char* name, std::vector<std::string_view> fields) {
        part<Payload>(name, std::move(fields), config_);
    }
    template <class Payload>
    void part(const char* name, std::vector<std::string_view> fields, const Config& config) {
        check_names<Payload>(fields);
        StructVisitor v(std::move(fields));
        Payload{}.fields(v, config);
        record(name, v);
    }
    /// Adds a record of parts of a payload, each a plain vector: name and width, the highest part first.
    /// Parts that the configuration does not have, of width 0, are left out. `bits` is the payload's width.
    void groups(const char* name, const std::vector<std::pair<const char*, int>>& parts, int bits) {
        StructVisitor v;
        for (const auto& [part, width] : parts)
            if (width > 0) v(part, 0u, width);
        if (v.bits != bits) throw std::logic_error(std::string("the groups do not fill ") + name);
        record(name, v);
    }
    /// Adds the payloads of the links, in their order.
    template <std::size_t i = 0> void links() {
        if constexpr (i < link_count) {
            record<std::tuple_element_t<i, LinkPayloads>>(link_infos[i].name);
            links<i + 1>();
        }
    }
    template <std::size_t n>
    void table(const char* name, const std::array<TableEntry, n>& entries, int value_bits, int step_bits) {
        std::vector<std::string> texts;   // value in the upper bits, step in the lower
        for (const TableEntry& entry : entries)
            texts.push_back(fmt::format("h{:x}", std::uint64_t(entry.value) << step_bits | entry.step));
        text_ += list_text(name, texts, value_bits + step_bits);
    }
    void text(const std::string& more) { text_ += more; }
    std::string end() && { return std::move(text_) + "endpackage\n"; }

private:
    void record(const char* name, const StructVisitor& v) {
        text_ +=
            fmt::format("\n  typedef struct packed {{\n{}  }} {}_t;\n  localparam int unsigned {}W = {};\n",
                        v.text, name, camel(name), v.bits);
    }
    const Config& config_;
    std::string text_ =
        "// GENERATED by sim/run/gen/rc_pkg.cpp from a configuration and the tables of model/core,\n"
        "// model/engine and model/machine. Do not edit.\n"
        "// Regenerate: cmake --build --preset release --target regen\n"
        "package rc_pkg;\n";
};

/// Returns the width of a link's payload in bits.
int bits_on(Link link, const Config& config) {
    int bits = 0;
    const auto find_link = [&]<std::size_t... i>(std::index_sequence<i...>) {
        ((i == index(link) ? void(bits = bits_of<std::tuple_element_t<i, LinkPayloads>>(config)) : void()),
         ...);
    };
    find_link(std::make_index_sequence<link_count>());
    return bits;
}

// The groups of a context's state that a chip stores separately, in the order of ShadeState. `inner`,
// `albedo` and `share` are groups of one field.
using Names = std::vector<std::string_view>;
const Names pixel_group{"x", "y"};
const Names every_group{"next_event", "pending", "found",  "prim",       "t",     "u",
                        "v",          "colour",  "weight", "depth",      "light", "in_cell",
                        "across",     "path",    "holes",  "light_holes"};
const Names point_group{"o", "normal", "view", "cosine"};
const Names face_group{"n", "is_far", "is_lost"};
const Names samples_group{"sample", "sum", "least", "most"};
const Names waits_group{"waiting", "total"};
const Names look_group{"diffuse", "highlight", "mirror", "shine", "ambient", "record", "is_round"};
const Names bend_group{"transmit", "ratio", "schlick", "r0"};
const Names self_group{"self", "is_inside"};

// The part of a hit that waits in tri for the divisions.
const Names tri_tail{"cutout", "back", "num", "det", "prim"};

/// Returns the width of those fields of a payload that have one of these names.
template <class Payload> int width_of(const Config& config, std::vector<std::string_view> fields) {
    check_names<Payload>(fields);
    StructVisitor v(std::move(fields));
    Payload{}.fields(v, config);
    return v.bits;
}

/// Adds records that show a payload as a few parts.
void group_records(Package& p, const Config& c) {
    const int ray = c.ray_bits();
    const auto node_request = [&](const std::string& name, Structure structure) {
        const int node = node_bits(c, structure), bits = bits_on(node_unit(structure).req, c);
        const int fields = bits - ray - node, o = 3 * c.origin_width();
        p.groups((name + "_req").c_str(), {{"ray", ray}, {"ray_fields", fields}, {"node", node}}, bits);
        p.groups((name + "_ray").c_str(), {{"o", o}, {"others", fields - o}}, fields);
    };
    p.say("Requests for nodes, whose fields depend on the structure, and the ray in them; list's request.");
    node_request("node_unit", c.engine());
    node_request("mesh", c.lower_engine());
    const int primitive = bits_of<PrimData>(c), best = bits_of<Best>(c) - 1, tri = bits_of<TriReq>(c);
    p.groups("tri_req_parts",
             {{"ray", ray},
              {"ray_fields", tri - ray - primitive - 1 - best},
              {"prim_data", primitive},
              {"found", 1},
              {"best", best}},
             tri);

    const int rsp = bits_of<TriRsp>(c), tail = width_of<TriRsp>(c, tri_tail), hit = rsp - ray - 1;
    p.say("tri's answer, the part of a hit that waits for the divisions, and the primitive's number.");
    p.groups("tri_rsp_parts", {{"ray", ray}, {"closer", 1}, {"hit", hit}}, rsp);
    p.groups("tri_hit", {{"tail", tail}, {"t", c.t_bits()}, {"u", c.uv_bits()}, {"v", c.uv_bits()}}, hit);
    const int cutout = c.has_textures() ? 1 : 0;
    p.groups("tri_number", {{"cutout", cutout}, {"prim", c.prim_bits}, {"any", 1}}, cutout + c.prim_bits + 1);

    p.say("A group of siblings on a ray's stack: all except the nearest, which was visited.");
    const int siblings = c.node_width - 1;
    const int group = c.t_bits() + c.addr_bits + c.group_bits() + siblings * (c.t_bits() + c.slot_bits());
    p.groups("stack_group",
             {{"below", c.t_bits()},
              {"base", c.addr_bits},
              {"count", c.group_bits()},
              {"t_near", siblings * c.t_bits()},
              {"slot", siblings * c.slot_bits()}},
             group);

    p.say("The groups of shade_state_t and of material_t.");
    const auto width = [&](std::vector<std::string_view> fields) {
        return width_of<ShadeState>(c, std::move(fields));
    };
    p.groups("shade_groups",
             {{"pixel", width(pixel_group)},
              {"every", width(every_group)},
              {"point", width(point_group)},
              {"inner", width({"inner"})},
              {"face", width(face_group)},
              {"albedo", width({"albedo"})},
              {"share", width({"share"})},
              {"samples", width(samples_group)},
              {"waits", width(waits_group)},
              {"look", width(look_group)},
              {"bend", width(bend_group)},
              {"self", width(self_group)}},
             bits_of<ShadeState>(c));
    const int look = width(look_group), bend = width(bend_group), self = width(self_group);
    p.groups("material_groups", {{"look", look}, {"bend", bend}, {"self", self}}, look + bend + self);
}

/// Adds records for state inside units: subsets of the payloads above.
void parts(Package& p, const Config& config) {
    p.say("Parts that list stores: the ray for tri, a node's leaves, the best hit.");
    p.part<TriReq>("tri_ray",
                   {"axis", "neg", "size", "slope", "kind", "is_partial", "self", "is_inside", "o", "d"});
    p.part<Leaves>("leaf_group", {"base", "leaves", "t_near", "offset", "count"});
    p.part<TriReq>("best", {"best_num", "best_det", "best_prim"});
    p.part<Closest>("stored_hit", {"cutout", "back", "prim", "t", "u", "v"});
    p.part<TriRsp>("tri_tail", tri_tail);

    p.say("The fields of a ray that a node unit takes, in their three forms.");
    p.part<BoxReq>("signs_ray", {"o", "neg", "recip", "len"});
    p.part<SlantReq>("along_ray", {"o", "recip", "len", "along"});
    p.part<GlobeReq>("toward_ray", {"o", "toward", "len"});

    p.say("Fields of a ray that raygen and xform delay unchanged, and that trav stores for xform.");
    p.part<Spawn>("spawn_tag",
                  {"ray", "holes", "is_partial", "self", "is_inside", "home", "home_o", "home_d"});
    p.part<XformReq>("xform_ray", {"kind", "home", "home_o", "home_d", "d"});
    p.part<Change>("change_tag", {"ray", "kind", "first", "root", "here"});

    p.say("Parts that shade stores: model/unit/shade/state.hpp.");
    Config shading = config;   // other chips do not use these records, but tools parse the units of shade
    shading.shading = true;
    p.part<Closest>("shade_hit", {"cutout", "found", "back", "prim", "t", "u", "v"}, shading);
    p.part<Placement>("shade_place", {"here", "texel_scale", "a", "b"}, shading);
    p.part<Placement>("instance_map", {"here", "a", "b"}, shading);
    p.part<Surface>("surface_material", {"schlick", "colour", "other", "ambient", "diffuse", "highlight",
                                         "mirror", "transmit", "r0", "shine", "enter", "leave"});
    p.part<TexRsp>("texel", {"hole", "colour"});
    p.record<ShadeChanges>("shade_changes");
    p.part<ShadeState>("shade_pixel", pixel_group);
    p.part<ShadeState>("shade_every", every_group);
    p.part<ShadeState>("shade_point", point_group);
    p.part<ShadeState>("shade_face", face_group);
    p.part<ShadeState>("shade_albedo", {"albedo"});
    p.part<ShadeState>("shade_share", {"share"});
    p.part<ShadeState>("shade_samples", samples_group);
    p.part<ShadeState>("shade_waits", waits_group);
    p.part<ShadeState>("shade_look", look_group);
    p.part<ShadeState>("shade_bend", bend_group);
    p.part<ShadeState>("shade_self", self_group);
    p.part<ShadeState>("material", {"diffuse", "highlight", "mirror", "shine", "ambient", "record",
                                    "is_round", "transmit", "ratio", "schlick", "r0", "self", "is_inside"});
}

/// Adds the widths of distances, rays and hits, and what the chip has.
void ray_widths(Package& p, const Config& c) {
    p.constant("TBits", c.t_bits());
    p.constant("PathBits", c.path_bits());
    p.constant("EdgeBits", c.edge_bits());
    p.constant("NumBits", c.num_bits());
    p.constant("OriginBits", c.origin_frac());
    p.flag("HasShade", c.has_shade());
    p.flag("IsStream", c.is_stream());           // rays come from records in memory
    p.flag("WritesHits", c.writes_hits());       // into memory, as records
    p.constant("HitsOfLine", hits_of_line(c));   // records
    p.constant("MostAnswers", c.writes_hits() ? hits_of_line(c) : c.pipelines);   // that leave in a cycle
    p.flag("HasTextures", c.has_textures());
    p.flag("HasPrimKinds", c.has_kinds());
    p.constant("HoleBits", hole_bits);
    p.flag("HasHomes", c.has_homes());       // secondary rays start on instances
    p.flag("HasSelf", c.has_self());         // rays name the sphere that they leave
    p.flag("HasPartial", c.has_partial());   // some rays meet only some primitives
    p.constant("OriginWidth", c.origin_width());
    p.constant("PointWidth", c.point_width());
    p.constant("ApproachShift", c.approach_shift());
    p.constant("ApproachSteps", approach_steps);
    p.constant("RayDirBits", c.ray_dir_bits());
    p.constant("UvBits", c.uv_bits());
}

/// Adds the widths of shading: lights, vectors, colours, materials.
void shade_widths(Package& p, const Config& c) {
    p.constant("LightBits", c.light_bits());
    p.constant("NormalBits", c.normal_bits());
    p.constant("UnitBits", unit_bits);
    p.constant("ValueBits", unit_bits + 1);   // 0 to 1, both included: a weight, cosine, colour
    p.bits("ValueOne", unit_bits + 1, 1ull << unit_bits);
    // Half of a value's last bit, in a product of two values.
    p.bits("ProductHalf", 2 * unit_bits + 2, 1ull << (unit_bits - 1));
    p.constant("AxisBits", unit_bits + 2);   // -1 to 1: a component of a unit vector
    p.constant("ShareBits", share_bits);
    p.constant("ColourBits", share_bits + 1);             // 0 to 1: a channel of a surface's colour
    p.constant("SumBits", unit_bits + 1 + sample_bits);   // a channel of the sum of a pixel's samples
    p.constant("CornerBits", corner_bits);
    p.constant("FarDrop", far_drop);
    p.constant("ShineFrac", shine_frac);
    p.constant("ShineBits", shine_bits);
    p.constant("IndexFrac", index_frac);
    p.constant("RatioBits", ratio_bits);
    p.constant("StrengthBits", strength_bits);
    p.constant("PlaneBits", plane_bits);
    p.constant("RootBits", root_bits);
    p.constant("MaxFine", max_fine);
}

/// Adds the widths of samples and textures.
void texture_widths(Package& p) {
    p.constant("SampleBits", sample_bits);
    p.constant("CoordinateBits", coordinate_bits);   // of a texture coordinate
    p.constant("CoordinateFrac", coordinate_frac);
    p.constant("TexelFrac", texel_frac);
    p.constant("SideBits", side_bits);
    p.constant("LevelBits", level_bits);
    p.constant("LevelFrac", level_frac);
    p.constant("LengthBits", length_bits);
    p.constant("LogIndexBits", log_index_bits);
}

/// Adds the widths of camera rays, and the number of memory clients.
void camera_widths(Package& p, const Config& c) {
    p.constant("SubPixelBits", sub_pixel_bits);
    p.constant("DepthBits", depth_bits);
    p.constant("Clients", c.clients());
    p.constant("GuardBits", guard_bits);
    p.constant("GuardDirBits", c.guard_dir_bits());
    p.constant("MaxShift", max_shift);
}

/// Adds the widths of nodes, of their requests, and of instances.
void node_widths(Package& p, const Config& c) {
    p.constant("RayBits", c.ray_bits());
    p.constant("GroupBits", c.group_bits());
    p.constant("SlotBits", c.slot_bits());
    p.constant("StackBits", c.stack_bits());
    p.constant("ExpBits", exp_bits);
    p.constant("OffsetBits", offset_bits);
    p.constant("CountBits", count_bits);
    p.constant("GlobeBits", globe_bits);
    p.constant("TowardBits", toward_bits);
    // The scene's tree has NodeBits. The next constant is for the meshes' trees.
    p.constant("NodeBits", node_bits(c, c.engine()));
    p.constant("MeshNodeBits", node_bits(c, c.lower_engine()));
    p.constant("NodePartBits", bits_of<NodeRsp>(c) - c.ray_bits());   // of a line in the node cache
    p.constant("NodeReqBits", bits_on(node_unit(c.engine()).req, c));
    p.constant("MeshReqBits", bits_on(node_unit(c.lower_engine()).req, c));
    p.constant("LineKindBits", line_kind_bits);
    p.constant("MapFrac", c.map_frac());
    p.constant("MapBits", c.map_bits());
    p.constant("NodePlanes", c.planes_of_node());
    p.constant("NormalStepBits", normal_step_bits);
    p.constant("PlaneOffsetBits", c.offset_of_plane_bits());
    p.constant("CrossingBits", crossing_bits);
}

/// Adds the widths of memory lines and of ids.
void memory_widths(Package& p, const Config& c) {
    p.constant("LineBits", line_bits);
    p.constant("TileCoordBits", c.tile_coord_bits());
    p.constant("ClientBits", c.client_bits());
    p.constant("ClientIdBits", c.client_id_bits());
    p.constant("MemIdBits", c.mem_id_bits());
}

/// Adds the stages of the tests of nodes and primitives.
void test_stages(Package& p, const Config& c) {
    const Stages stages(c);
    p.constant("PathCut", stages.cut);
    p.constant("FarPathCut", stages.shading_cut);
    p.constant("MulStages", stages.multiply);
    p.constant("SlabPlanes", stages.slab_planes);
    p.constant("SlabStages", stages.slab);
    p.constant("MeetStages", stages.meet);
    p.constant("RankStages", stages.rank);
    p.constant("PlaneStages", stages.plane);
    p.constant("ExitStages", stages.exits);
    p.constant("GlobeStages", stages.globe);
    p.constant("CrossingStages", stages.crossing);
    p.constant("QuotientBits", stages.quotient_bits);
    p.constant("HitBits", stages.hit_bits);
    p.constant("CrossShare", stages.cross_share);
    p.constant("DotShare", stages.dot_share);
    p.constant("PairShare", stages.pair_share);
    p.constant("PairParts", stages.pair_parts);
    p.constant("PairStages", stages.pair);
    p.constant("EdgesStages", stages.edges);
    p.constant("ShearStages", stages.shear);
    p.constant("HitdivStages", stages.hit_divide);
    p.constant("SphereLevels", stages.sphere_levels);
    p.constant("SphereStages", stages.sphere);
}

/// Adds the stages of raygen and xform.
void raygen_and_xform_stages(Package& p, const Config& c) {
    const Stages stages(c);
    p.constant("SampleStages", stages.sample);
    p.constant("PixelStages", stages.pixel);
    p.constant("DirectionStages", stages.direction);
    p.constant("RecipStages", stages.recip);
    p.constant("SlopeStages", stages.slope);
    p.constant("MapShare", stages.map_share);
    p.constant("RecipShare", stages.recip_share);
    p.constant("MapStages", stages.map);
    p.constant("StackStages", stages.stack_delay);
}

/// Adds the latencies of units, apart from tex and shade.
void latencies(Package& p, const Config& c) {
    p.constant("RaygenLatency", c.raygen_latency());
    p.constant("BoxInterval", c.box_interval());
    for_each_engine(
        [&]<class E>(E) { p.constant(camel(unit_name(E::structure)) + "Latency", E::latency(c)); });
    // Pads the answers of the faster unit.
    p.constant("NodePad", node_latency(c) - node_latency(c, c.engine()));
    p.constant("MeshPad", node_latency(c) - node_latency(c, c.lower_engine()));
    p.constant("XformLatency", c.xform_latency());
    p.constant("TriLatency", c.tri_latency());
}

/// Adds the stages of tex and shade.
void tex_and_shade_stages(Package& p, const Config& c) {
    const Stages stages(c);
    p.constant("TexAddressStages", stages.tex_address);
    p.constant("TexFilterStages", stages.tex_filter);
    p.constant("OctahedralSteps", c.bary_bits / 2);   // each finds two of bary_bits - 1 bits
    p.constant("ShadeStages", stages.pass);
    p.constant("PassCut", stages.pass_cut);
    p.constant("PassOutStage", stages.pass_out);
    p.constant("PassParts", stages.pass_parts);
    p.constant("PassReadCycles", stages.pass_read);
    p.constant("ShadeLatency", c.shade_latency());
    p.constant("UnitStages", unit_stages);
    p.constant("PowerStages", power_stages);
    // The stages of a pass in which these are ready: the vectors that become unit vectors, the unit vectors,
    // their cosines, the base of a highlight's power, the power, the light's reflected part. With two levels
    // also the new ray in the space of its mesh. StageWeight has the weight of the next ray.
    constexpr int toward = 5, unit = toward + unit_stages, cosine = unit + 2, power = cosine + 2;
    constexpr int phong = power + power_stages, lit = phong + 2;
    if (lit + 2 != stages.pass) throw std::logic_error("a pass has other stages");
    p.constant("StageToward", toward);
    p.constant("StageWeight", 9);
    p.constant("StageUnit", unit);
    p.constant("StageCosine", cosine);
    p.constant("StageHome", cosine + 4);
    p.constant("StagePower", power);
    p.constant("StagePhong", phong);
    p.constant("StageLit", lit);
}

/// Adds widths and latencies that follow from the parameters.
void derived(Package& p, const Config& c) {
    ray_widths(p, c);
    shade_widths(p, c);
    texture_widths(p);
    camera_widths(p, c);
    node_widths(p, c);
    memory_widths(p, c);
    test_stages(p, c);
    raygen_and_xform_stages(p, c);
    latencies(p, c);
    tex_and_shade_stages(p, c);
}

void enumerations(Package& p) {
    p.say("What holds the scene.");
    std::vector<std::pair<std::string, Structure>> structures{{"None", Structure::none}};
    for_each_engine([&]<class E>(E) { structures.emplace_back(camel(name_of(E::structure)), E::structure); });
    p.enumeration("structure_e", "Structure", 32, structures);
    p.say("What a line of memory holds, if there are two levels.");
    p.enumeration<LineKind>("line_kind_e", "Line", line_kind_bits,
                            {{"SceneNode", LineKind::scene_node},
                             {"MeshNode", LineKind::mesh_node},
                             {"Placement", LineKind::placement}});
    p.say("What a ray is for, what a primitive is, which test tri makes.");
    p.enumeration<RayKind>("ray_kind_e", "Ray", ray_kind_bits,
                           {{"Camera", RayKind::camera},
                            {"Bounce", RayKind::bounce},
                            {"Shadow", RayKind::shadow},
                            {"Away", RayKind::away}});
    p.enumeration<PrimKind>("prim_kind_e", "Prim", prim_kind_bits,
                            {{"Triangle", PrimKind::triangle},
                             {"Plane", PrimKind::plane},
                             {"Sphere", PrimKind::sphere},
                             {"Cutout", PrimKind::cutout}});
    p.enumeration<PrimitiveTest>("primitive_test_e", "Test", 32,
                                 {{"Exact", PrimitiveTest::exact}, {"Sheared", PrimitiveTest::sheared}});
    p.say("What a pass of shade is for, what it leaves to be added, and where the context goes after it.");
    p.enumeration<ShadeEvent>("shade_event_e", "Event", shade_event_bits,
                              {{"Arrive", ShadeEvent::arrive},
                               {"Light", ShadeEvent::light},
                               {"Refract", ShadeEvent::refract},
                               {"Reflect", ShadeEvent::reflect},
                               {"Pop", ShadeEvent::pop},
                               {"Transform", ShadeEvent::transform},
                               {"Texture", ShadeEvent::texture}});
    p.enumeration<Pending>("pending_e", "Pending", pending_bits,
                           {{"None", Pending::none},
                            {"Answer", Pending::answer},
                            {"Sure", Pending::sure},
                            {"Texture", Pending::texture}});
    using Leave = PassOut::Leave;
    p.enumeration<Leave>("leave_e", "Leave", 2,
                         {{"Again", Leave::again},
                          {"Spawn", Leave::spawn},
                          {"Pixel", Leave::pixel},
                          {"Texture", Leave::texture}});
    p.say("How a texture continues beyond its edges, and the formats of its texels.");
    p.enumeration<WrapMode>(
        "wrap_e", "Wrap", wrap_bits,
        {{"Repeat", WrapMode::repeat}, {"Mirror", WrapMode::mirror}, {"Clamp", WrapMode::clamp}});
    p.enumeration<TexelFormat>("texel_format_e", "Texels", 32,
                               {{"Rgb888", TexelFormat::rgb888}, {"Rgb565", TexelFormat::rgb565}});
    p.say("What a unit did in a cycle; first a cache's outcomes.");
    p.constant("CauseBits", cause_bits);
    p.enumeration<CacheOutcome>("cache_outcome_e", "Cache", cause_bits,
                                {{"Hit", CacheOutcome::hit},
                                 {"Miss", CacheOutcome::miss},
                                 {"Merge", CacheOutcome::merge},
                                 {"Drain", CacheOutcome::drain},
                                 {"Starved", CacheOutcome::starved},
                                 {"Mshrs", CacheOutcome::mshrs},
                                 {"Conflict", CacheOutcome::conflict},
                                 {"Answers", CacheOutcome::answers}});
    for (std::size_t u = 0; u < unit_count; ++u) {
        const UnitInfo& unit = unit_infos[u];
        if (unit.place < UnitPlace::outside && !is_node_unit(Unit(u)) &&
            unit.causes.back().kind == CauseKind::none)
            p.causes(unit.name, unit);
    }
    p.causes("node_unit", unit_infos[index(node_units[0].unit)]);   // for all node units
}

}   // namespace

std::string rc_package(const Config& config) {
    Package p(config);
    p.parameters();
    p.say("What follows from these: model/core/config.hpp.");
    derived(p, config);
    enumerations(p);
    p.say("Tables of the shade unit's cells: model/fixed/tables.hpp.");
    p.table("InverseRoot", inverse_root_table(), root_value_bits, root_step_bits);
    p.table("Log", log_table(), log_value_bits, log_step_bits);
    p.table("Exp", exp_table(), exp_value_bits, exp_step_bits);
    p.say("Intensities of sRGB codes: model/unit/tex/texel.hpp.");
    std::vector<std::string> intensities;
    for (const std::uint32_t value : srgb_table()) intensities.push_back(fmt::format("d{}", value));
    p.text(list_text("SrgbTable", intensities, share_bits + 1));
    p.say("Fractions of logarithms: log_fractions() in the same file.");
    std::vector<std::string> fractions;
    for (const std::uint32_t value : log_fractions()) fractions.push_back(fmt::format("d{}", value));
    p.text(list_text("LogFraction", fractions, level_frac));
    p.say("Tables of the unit globe: model/engine/spheres/tables.hpp.");
    p.table("NearInverse", near_inverse_table(), near_inverse_bits, near_inverse_step_bits);
    p.table("RootUp", root_up_table(), root_up_bits, 0);
    p.text(host_constants(config));
    p.say("What the links carry: model/machine/links.hpp.");
    p.links();
    p.say("What passes between units without a link of its own, or is kept.");
    p.record<Frame>("frame");
    p.record<ShadeFrame>("shade_frame");
    p.record<NodeRsp>("node_rsp");
    p.record<NodeAnswer>("node_answer");   // of every node unit
    p.record<PrimRsp>("prim_rsp");
    p.record<Start>("start");
    p.record<Shear>("shear");
    p.record<Children>("children");
    p.record<Done>("done");
    p.record<Pixel>("pixel");
    p.record<L2Miss>("l2_miss");
    p.record<ShadeState>("shade_state");
    p.record<Waiting>("waiting");
    p.record<TexelPlace>("texel_place");
    parts(p, config);
    group_records(p, config);
    p.say(
        "What lies in lines of memory, in their lowest bits: model/engine/*/node.hpp, model/core/lines.hpp, "
        "docs/machine/chip.md.");
    for_each_engine([&]<class E>(E) { p.record<typename E::Node>(E::node_name); });
    p.record<Placement>("placement");
    p.record<PrimData>("primitive");
    p.record<Surface>("surface");
    p.record<TexRecord>("tex_record");
    p.record<HitRecord>("hit_record");
    return std::move(p).end();
}

}   // namespace rayclock
