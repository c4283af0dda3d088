// 3DS: nested chunks, each with its length. Reads meshes, their materials and colours. Turns z, which is up
// in this format, to y. Leaves out cameras, lights, textures, smoothing groups and the key frames of
// animations.
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "sim/files/text.hpp"
#include "sim/load/mesh/mesh_file.hpp"

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
    light = 0x4600,
    camera = 0x4700,
    material_block = 0xafff,
    material_name = 0xa000,
    diffuse = 0xa020,
    specular = 0xa030,
    shine = 0xa040,
    transparency = 0xa050,
    texture = 0xa200,
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
    std::vector<glm::vec3> positions;
    std::vector<Face> faces;
    std::vector<std::uint32_t> material;   ///< of each face, number of a material name; 0: none
};
struct Found {
    MtlSurface surface{.diffuse = glm::vec3(0.8f)};
    bool has_texture = false;
};

class Reader {
public:
    Reader(std::string_view bytes, const SourcePosition& at, Loading& loading)
        : bytes_(bytes), at_(at), loading_(loading) {}

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
            in.text();
            each(in, [&](std::uint16_t part, Bytes what) {
                if (part == mesh) read_mesh(what);
                left_out_ += part == light || part == camera;
            });
        } else if (id == material_block) {
            read_material(in);
        }
    }

    void read_mesh(Bytes in) {
        Mesh made;
        each(in, [&](std::uint16_t id, Bytes what) {
            if (id == mesh_vertices) vertices(made, what);
            if (id == mesh_faces) faces(made, what);
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
            found.has_texture |= id == texture;
        });
        materials_.try_emplace(name, found);
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

    /// Joins the faces in the order of the file. Each run of faces with one material becomes a part.
    Scene joined() {
        Assembly assembly(at_.file, loading_);
        std::vector<std::uint32_t> of_part;
        for (const Mesh& m : meshes_)
            for (std::size_t f = 0; f < m.faces.size();) {
                const std::uint32_t material = m.material[f];
                std::size_t end = f;
                while (end < m.faces.size() && m.material[end] == material) ++end;
                PartBuilder builder(end - f, false);
                for (; f < end; ++f) {
                    const auto corner = [&](int k) {
                        return Corner{glm::dvec3(m.positions[m.faces[f].corner[k]])};
                    };
                    builder.add(corner(0), corner(1), corner(2), 0);
                }
                assembly.add(std::move(builder));
                of_part.push_back(material);
            }
        std::uint64_t odd = 0, textured = 0;
        for (std::size_t i = 0; i < of_part.size(); ++i)
            assembly.place(i, glm::dmat4(1), of_part[i], [&] {
                if (of_part[i] == 0) return Material{.name = "default"};
                const std::string& name = names_[of_part[i] - 1];
                const auto known = materials_.find(name);
                const Found found = known == materials_.end() ? Found{} : known->second;
                odd += is_out_of_range(found.surface);
                textured += found.has_texture;
                return material_of(found.surface, name);
            });
        const auto say = [&](std::uint64_t count, const char* what, const char* sentence) {
            if (count > 0) loading_.note(at_.file, counted(count, what) + sentence);
        };
        say(odd, "material", " with values out of range, taken as the nearest within");
        say(textured, "material", " with textures, which are not drawn");
        say(left_out_, "light or camera", " left out");
        if (animated_)
            loading_.note(at_.file, "its key frames are left out: meshes stand where they were modelled");
        return assembly.take();
    }

    std::string_view bytes_;
    SourcePosition at_;
    Loading& loading_;
    std::vector<Mesh> meshes_;
    std::map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> names_;
    std::map<std::string, Found> materials_;
    std::uint64_t left_out_ = 0;
    bool animated_ = false;
};

}   // namespace

Scene read_3ds(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    return Reader(bytes, {path.string()}, loading).read();
}

}   // namespace rayclock
