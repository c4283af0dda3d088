// 3DS: nested chunks, each with its length. Reads meshes, their materials, colours and pictures. Turns z,
// which is up in this format, to y. Leaves out cameras, lights, smoothing groups and the key frames of
// animations.
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "sim/files/text.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

static_assert(std::endian::native == std::endian::little, "3DS is read in place");

enum Id : std::uint16_t {
    main_chunk = 0x4d4d,
    editor = 0x3d3d,
    object = 0x4000,
    mesh = 0x4100,
    mesh_vertices = 0x4110,
    mesh_faces = 0x4120,
    face_material = 0x4130,
    mesh_coordinates = 0x4140,
    light = 0x4600,
    camera = 0x4700,
    material_block = 0xafff,
    material_name = 0xa000,
    diffuse = 0xa020,
    specular = 0xa030,
    shine = 0xa040,
    transparency = 0xa050,
    texture = 0xa200,
    specular_texture = 0xa204,
    opacity_texture = 0xa210,
    reflection_texture = 0xa220,
    bump_texture = 0xa230,
    second_texture = 0xa33a,
    shine_texture = 0xa33c,
    glow_texture = 0xa33d,
    texture_file = 0xa300,
    texture_tiling = 0xa351,
    texture_scale_s = 0xa354,
    texture_scale_t = 0xa356,
    texture_offset_s = 0xa358,
    texture_offset_t = 0xa35a,
    texture_angle = 0xa35c,
    colour_float = 0x0010,
    colour_bytes = 0x0011,
    colour_bytes_linear = 0x0012,
    colour_float_linear = 0x0013,
    percent_whole = 0x0030,
    percent_float = 0x0031,
    key_frames = 0xb000,
};

/// Reads the bytes of a chunk from the front. Throws UserError at their end.
class Bytes {
public:
    Bytes(std::string_view bytes, const SourcePosition& at, const char* what)
        : rest_(bytes), at_(&at), what_(what) {}
    bool empty() const { return rest_.empty(); }
    template <class T> T take() {
        T value;
        if (rest_.size() < sizeof value) at_->refuse(fmt::format("the file is cut off inside {}", what_));
        std::memcpy(&value, rest_.data(), sizeof value);
        rest_.remove_prefix(sizeof value);
        return value;
    }
    std::string text() {
        const std::size_t end = rest_.find('\0');
        if (end == rest_.npos) at_->refuse(fmt::format("a name without an end inside {}", what_));
        std::string name(rest_.substr(0, end));
        rest_.remove_prefix(end + 1);
        return name;
    }
    /// Takes the next chunk: its id and its content.
    std::pair<std::uint16_t, Bytes> chunk() {
        const auto id = take<std::uint16_t>();
        const auto length = take<std::uint32_t>();
        constexpr std::size_t head = 6;
        if (length < head || length - head > rest_.size())
            at_->refuse(fmt::format("the chunk {:04x} inside {} says {} bytes, and {} are there", id, what_,
                                    length, rest_.size() + head));
        const Bytes inner(rest_.substr(0, length - head), *at_, what_);
        rest_.remove_prefix(length - head);
        return {id, inner};
    }

private:
    std::string_view rest_;
    const SourcePosition* at_;
    const char* what_;
};

struct Face {
    std::uint16_t corner[3];
};
struct Mesh {
    std::string name;   ///< of its object
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> coordinates;   ///< of the vertices; t increases upwards
    std::vector<Face> faces;
    std::vector<std::uint32_t> material;   ///< of each face, number of a material name; 0: none
};

/// The picture of a material, and its place: coordinates * scale + offset.
struct TextureMap {
    enum Tiling : std::uint16_t { mirrors = 2, ends = 0x10 };
    std::string file;
    std::uint16_t tiling = 0;
    glm::dvec2 scale{1}, offset{0};
    float strength = 1, angle = 0;
};
struct Found {
    MtlSurface surface{.diffuse = glm::vec3(0.8f)};
    TextureMap map;   ///< without a file: no picture
    bool has_other_textures = false;
};
/// A material in use, and the map that places its texture.
struct Used {
    Material material;
    TextureMap map;
};

class Reader {
public:
    Reader(const std::filesystem::path& path, std::string_view bytes, Loading& loading)
        : folder_(path.parent_path()),
          bytes_(bytes),
          at_{path.string()},
          loading_(loading),
          warnings_(at_.file),
          pictures_(at_.file, "mesh", loading) {}

    Scene read() {
        Bytes all(bytes_, at_, "the file");
        const auto [id, inner] = all.chunk();
        if (id != main_chunk) at_.refuse(fmt::format("this is not 3DS: it begins with the chunk {:04x}", id));
        each(inner, [&](std::uint16_t part, Bytes in) {
            if (part == editor) each(in, [&](std::uint16_t item, Bytes what) { edited(item, what); });
            animated_ |= part == key_frames;
        });
        std::size_t faces = 0;
        for (const Mesh& m : meshes_) faces += m.faces.size();
        if (faces == 0) at_.refuse("the file has no triangles");
        return joined();
    }

private:
    template <class Take> void each(Bytes in, Take take) {
        while (!in.empty()) {
            const auto [id, inner] = in.chunk();
            take(id, inner);
        }
    }

    void edited(std::uint16_t id, Bytes in) {
        if (id == object) {
            const std::string name = in.text();
            each(in, [&](std::uint16_t part, Bytes what) {
                if (part == mesh) read_mesh(what, name);
                left_out_ += part == light || part == camera;
            });
        } else if (id == material_block) {
            read_material(in);
        }
    }

    void read_mesh(Bytes in, const std::string& name) {
        Mesh made{.name = name, .positions = {}, .coordinates = {}, .faces = {}, .material = {}};
        each(in, [&](std::uint16_t id, Bytes what) {
            if (id == mesh_vertices) vertices(made, what);
            if (id == mesh_faces) faces(made, what);
            if (id == mesh_coordinates) coordinates(made, what);
        });
        for (const Face& face : made.faces)
            for (const std::uint16_t corner : face.corner)
                if (corner >= made.positions.size())
                    at_.refuse(
                        fmt::format("vertex index {} is out of range: the mesh has {} (0 is the first)",
                                    corner, made.positions.size()));
        meshes_.push_back(std::move(made));
    }

    void vertices(Mesh& made, Bytes in) {
        made.positions.clear();
        for (auto left = in.take<std::uint16_t>(); left > 0; --left) {
            glm::vec3 p(0);
            for (int i = 0; i < 3; ++i)
                if (!std::isfinite(p[i] = in.take<float>()))
                    at_.refuse(fmt::format("vertex {} has the coordinate {}, which is not a finite number",
                                           made.positions.size(), p[i]));
            made.positions.emplace_back(p.x, p.z, -p.y);
        }
    }

    void coordinates(Mesh& made, Bytes in) {
        made.coordinates.clear();
        for (auto left = in.take<std::uint16_t>(); left > 0; --left) {
            const auto s = in.take<float>();
            made.coordinates.emplace_back(s, in.take<float>());
        }
    }

    void faces(Mesh& made, Bytes in) {
        made.faces.clear();
        for (auto left = in.take<std::uint16_t>(); left > 0; --left) {
            Face face{};
            for (std::uint16_t& corner : face.corner) corner = in.take<std::uint16_t>();
            in.take<std::uint16_t>();   // flags of visible edges
            made.faces.push_back(face);
        }
        made.material.assign(made.faces.size(), 0);
        each(in, [&](std::uint16_t id, Bytes what) {
            if (id != face_material) return;
            const std::uint32_t number = number_of(what.text());
            for (auto left = what.take<std::uint16_t>(); left > 0; --left) {
                const auto face = what.take<std::uint16_t>();
                if (face >= made.material.size())
                    at_.refuse(fmt::format("a material of face {}, and the mesh has {} (0 is the first)",
                                           face, made.material.size()));
                made.material[face] = number;
            }
        });
    }

    std::uint32_t number_of(const std::string& name) {
        const auto [found, is_new] = numbers_.try_emplace(name, std::uint32_t(names_.size() + 1));
        if (is_new) names_.push_back(name);
        return found->second;
    }

    void read_material(Bytes in) {
        std::string name;
        Found found;
        each(in, [&](std::uint16_t id, Bytes what) {
            if (id == material_name) name = what.text();
            if (id == diffuse) colour(what, found.surface.diffuse);
            if (id == specular) {
                colour(what, found.surface.specular);
                found.surface.illumination = 2;
            }
            if (id == shine) found.surface.shine = 100 * share(what);
            if (id == transparency) found.surface.opacity = 1 - share(what);
            if (id == texture) {
                found.map = texture_map(what);
                found.has_other_textures |= found.map.file.empty();
            }
            found.has_other_textures |= id == specular_texture || id == opacity_texture ||
                                        id == reflection_texture || id == bump_texture ||
                                        id == second_texture || id == shine_texture || id == glow_texture;
        });
        materials_.try_emplace(name, found);
    }

    TextureMap texture_map(Bytes in) {
        TextureMap made;
        const Bytes whole = in;
        bool has_strength = false;
        each(in, [&](std::uint16_t id, Bytes what) {
            has_strength |= id == percent_whole || id == percent_float;
            if (id == texture_file) made.file = portable_name(what.text());
            if (id == texture_tiling) made.tiling = what.take<std::uint16_t>();
            if (id == texture_scale_s) made.scale.x = what.take<float>();
            if (id == texture_scale_t) made.scale.y = what.take<float>();
            if (id == texture_offset_s) made.offset.x = what.take<float>();
            if (id == texture_offset_t) made.offset.y = what.take<float>();
            if (id == texture_angle) made.angle = what.take<float>();
        });
        if (has_strength) made.strength = share(whole);
        return made;
    }

    void colour(Bytes in, glm::vec3& out) {
        each(in, [&](std::uint16_t id, Bytes what) {
            if (id == colour_float || id == colour_float_linear)
                for (int i = 0; i < 3; ++i) out[i] = what.take<float>();
            if (id == colour_bytes || id == colour_bytes_linear)
                for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(what.take<std::uint8_t>()) / 255.0f;
        });
    }
    float share(Bytes in) {
        float out = 0;
        each(in, [&](std::uint16_t id, Bytes what) {
            if (id == percent_whole) out = static_cast<float>(what.take<std::int16_t>()) / 100.0f;
            if (id == percent_float) out = what.take<float>();
        });
        return out;
    }

    /// Returns the texture of a material. Returns nothing if the load averages textures, or the picture
    /// cannot be read.
    std::optional<std::uint32_t> texture_of(const TextureMap& map) {
        if (map.file.empty() || !loading_.draws_textures()) return std::nullopt;
        const auto pyramid = pictures_.pyramid(folder_, map.file);
        if (!pyramid) return std::nullopt;
        if (map.strength != 1)
            warnings_.count("picture", "that is mixed with a colour, drawn alone", 0, map.file);
        if (map.angle != 0) warnings_.count("picture", "that is turned, drawn upright", 0, map.file);
        Wrap wrap = map.tiling & TextureMap::mirrors ? Wrap::mirror : Wrap::repeat;
        if (wrap == Wrap::repeat && (map.tiling & TextureMap::ends)) {
            wrap = Wrap::clamp;
            warnings_.count("picture", "that does not repeat, drawn clamped to its edge", 0, map.file);
        }
        textures_.push_back({printable(map.file, 80), pyramid, wrap, wrap});
        return static_cast<std::uint32_t>(textures_.size() - 1);
    }

    /// Returns the material of a number above 0. Its picture replaces the diffuse colour.
    Used material(std::uint32_t number) {
        const std::string& name = names_[number - 1];
        const auto known = materials_.find(name);
        Found found = known == materials_.end() ? Found{} : known->second;
        const std::optional<std::uint32_t> texture = texture_of(found.map);
        if (texture) found.surface.diffuse = glm::vec3(1);
        if (!found.map.file.empty() && !loading_.draws_textures())
            if (const auto average = pictures_.average(folder_, found.map.file)) {
                found.surface.diffuse = glm::vec3(*average);
                warnings_.count("material", averaged_texture, 0, name);
            }
        if (is_out_of_range(found.surface))
            warnings_.count("material", "with values out of range, taken as the nearest within");
        if (found.has_other_textures)
            warnings_.count("material", "with other textures, which are not drawn", 0, name);
        Used made{material_of(found.surface, name), found.map};
        made.material.texture = texture;
        return made;
    }

    /// Returns the materials of all faces by their numbers. 0 is the default material.
    std::map<std::uint32_t, Used> used_materials() {
        std::map<std::uint32_t, Used> used;
        for (const Mesh& m : meshes_)
            for (const std::uint32_t number : m.material)
                if (!used.contains(number))
                    used.emplace(number,
                                 number == 0 ? Used{Material{.name = "default"}, {}} : material(number));
        return used;
    }

    /// Returns the coordinates of a vertex on a picture, with t downwards. In the file t increases upwards.
    /// Throws UserError if the vertex has no coordinates or they are too large.
    glm::dvec2 on_picture(const Mesh& m, std::uint16_t vertex, const TextureMap& map) const {
        if (vertex >= m.coordinates.size())
            at_.refuse(fmt::format("the mesh {} has {} texture coordinates for {} vertices", shown(m.name),
                                   m.coordinates.size(), m.positions.size()));
        const glm::dvec2 given = glm::dvec2(m.coordinates[vertex]) * map.scale + map.offset;
        for (const double x : {given.x, given.y})
            if (!(std::abs(x) <= max_given_coordinate))
                at_.refuse(
                    fmt::format("the mesh {} has the texture coordinate {} at vertex {}; the most is {}",
                                shown(m.name), x, vertex, max_given_coordinate));
        return {given.x, 1 - given.y};
    }

    /// Joins the faces in the order of the file. Each run of faces with one material becomes a part.
    Scene joined() {
        Assembly assembly(at_.file, loading_);
        const std::map<std::uint32_t, Used> used = used_materials();
        std::vector<std::uint32_t> of_part;
        for (const Mesh& m : meshes_)
            for (std::size_t f = 0; f < m.faces.size();) {
                const std::uint32_t material = m.material[f];
                std::size_t end = f;
                while (end < m.faces.size() && m.material[end] == material) ++end;
                PartBuilder builder(end - f, false);
                const Used& paint = used.at(material);
                const bool has_coordinates = paint.material.texture && !m.coordinates.empty();
                for (; f < end; ++f) {
                    const auto corner = [&](int k) {
                        const std::uint16_t vertex = m.faces[f].corner[k];
                        return Corner{glm::dvec3(m.positions[vertex]), glm::dvec3(0),
                                      has_coordinates ? on_picture(m, vertex, paint.map) : no_coordinates};
                    };
                    builder.add(corner(0), corner(1), corner(2), 0);
                }
                assembly.add(std::move(builder));
                of_part.push_back(material);
            }
        for (std::size_t i = 0; i < of_part.size(); ++i)
            assembly.place(i, glm::dmat4(1), of_part[i], [&] { return used.at(of_part[i]).material; });
        warnings_.say(loading_);
        if (left_out_ > 0) loading_.note(at_.file, counted(left_out_, "light or camera") + " left out");
        if (animated_)
            loading_.note(at_.file, "its key frames are left out: meshes stand where they were modelled");
        Scene made = assembly.take();
        made.textures = std::move(textures_);
        return made;
    }

    std::filesystem::path folder_;
    std::string_view bytes_;
    SourcePosition at_;
    Loading& loading_;
    Warnings warnings_;
    PictureFiles pictures_;
    std::vector<Texture> textures_;   ///< of the materials in use
    std::vector<Mesh> meshes_;
    std::map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> names_;
    std::map<std::string, Found> materials_;
    std::uint64_t left_out_ = 0;
    bool animated_ = false;
};

}   // namespace

Scene read_3ds(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    return Reader(path, bytes, loading).read();
}

}   // namespace rayclock
