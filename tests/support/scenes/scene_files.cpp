// Writes one octahedron in every format.
#include "tests/support/scenes/scene_files.hpp"

#include <sstream>

#include <zlib.h>

namespace rayclock::test {

std::vector<Corners> Octahedron::corners() const {
    std::vector<Corners> all;
    for (const auto& [a, b, c] : triangles) all.push_back({vertices[a], vertices[b], vertices[c]});
    return all;
}

std::string Octahedron::obj() const {
    std::ostringstream out;
    for (const auto& v : vertices) out << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    for (const auto& [a, b, c] : triangles) out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    return out.str();
}

namespace {

std::string ply_header(const std::string& form, const std::string& real, std::size_t vertices,
                       std::size_t faces) {
    std::ostringstream out;
    out << "ply\nformat " << form << " 1.0\ncomment made by hand\nelement vertex " << vertices
        << "\nproperty " << real << " x\nproperty " << real << " y\nproperty " << real << " z\nelement face "
        << faces << "\nproperty list uchar int vertex_indices\nend_header\n";
    return out.str();
}

}   // namespace

std::string Octahedron::ply_ascii() const {
    std::ostringstream out;
    out << ply_header("ascii", "float", vertices.size(), triangles.size());
    for (const auto& v : vertices) out << v.x << ' ' << v.y << ' ' << v.z << '\n';
    for (const auto& [a, b, c] : triangles) out << "3 " << a << ' ' << b << ' ' << c << '\n';
    return out.str();
}

std::string Octahedron::ply_binary(bool big) const {
    std::string out = ply_header(big ? "binary_big_endian" : "binary_little_endian", big ? "double" : "float",
                                 vertices.size(), triangles.size());
    for (const auto& v : vertices)
        for (const double x : {v.x, v.y, v.z}) out += big ? raw(x, true) : raw(static_cast<float>(x));
    for (const auto& t : triangles) {
        out += '\3';
        for (const std::uint32_t i : t) out += raw(i, big);
    }
    return out;
}

std::string Octahedron::stl_ascii() const {
    std::ostringstream out;
    out << "solid An Octahedron\n";
    for (const Corners& t : corners()) {
        out << "  facet normal 0 0 0\n    outer loop\n";
        for (const auto& v : t) out << "      vertex " << v.x << ' ' << v.y << ' ' << v.z << '\n';
        out << "    endloop\n  endfacet\n";
    }
    out << "endsolid An Octahedron\n";
    return out.str();
}

std::string Octahedron::stl_binary() const {
    std::string out = "solid and yet binary";
    out.resize(80, ' ');
    out += raw(static_cast<std::uint32_t>(triangles.size()));
    for (const Corners& t : corners()) {
        out += raw(0.0f) + raw(0.0f) + raw(1.0f);
        for (const auto& v : t)
            for (const double x : {v.x, v.y, v.z}) out += raw(static_cast<float>(x));
        out += raw(std::uint16_t{0});
    }
    return out;
}

std::string Octahedron::bin() const {
    std::string out;
    for (const auto& v : vertices)
        for (const double x : {v.x, v.y, v.z}) out += raw(static_cast<float>(x));
    for (const auto& t : triangles)
        for (const std::uint32_t i : t) out += raw(static_cast<std::uint16_t>(i));
    return out;
}

std::string Octahedron::gltf(const std::string& uri) const {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5123,"count":24,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":48}],)"
           R"("buffers":[{"byteLength":120)" +
           (uri.empty() ? "" : ",\"uri\":\"" + uri + "\"") + "}]}";
}

std::string Octahedron::glb() const { return glb_of(gltf(""), bin()); }

std::string Octahedron::json() const {
    std::ostringstream out;
    out << R"({"meshes": {"o": {"vertices": [)";
    for (std::size_t i = 0; i < vertices.size(); ++i)
        out << (i ? "," : "") << '[' << vertices[i].x << ',' << vertices[i].y << ',' << vertices[i].z << ']';
    out << R"(], "triangles": [)";
    for (std::size_t i = 0; i < triangles.size(); ++i)
        out << (i ? "," : "") << '[' << triangles[i][0] << ',' << triangles[i][1] << ',' << triangles[i][2]
            << ']';
    out << R"(]}}, "objects": [{"mesh": "o"}]})";
    return out.str();
}

std::string Octahedron::off() const {
    std::ostringstream out;
    out << "OFF\n" << vertices.size() << ' ' << triangles.size() << " 0\n";
    for (const auto& v : vertices) out << v.x << ' ' << v.y << ' ' << v.z << '\n';
    for (const auto& [a, b, c] : triangles) out << "3 " << a << ' ' << b << ' ' << c << '\n';
    return out.str();
}

std::string chunk(std::uint16_t id, const std::string& inside) {
    return raw(id) + raw(static_cast<std::uint32_t>(6 + inside.size())) + inside;
}

std::string Octahedron::tds() const {
    std::string corners = raw(static_cast<std::uint16_t>(vertices.size())),
                faces = raw(static_cast<std::uint16_t>(triangles.size()));
    for (const auto& v : vertices)
        for (const double x : {v.x, -v.z, v.y}) corners += raw(static_cast<float>(x));
    for (const auto& t : triangles) {
        for (const std::uint32_t i : t) faces += raw(static_cast<std::uint16_t>(i));
        faces += raw(std::uint16_t{7});
    }
    const std::string mesh = chunk(0x4100, chunk(0x4110, corners) + chunk(0x4120, faces));
    const std::string object = chunk(0x4000, std::string("An Octahedron\0", 14) + mesh);
    return chunk(0x4d4d, chunk(0x0002, raw(std::uint32_t{3})) + chunk(0x3d3d, object));
}

std::string Octahedron::dae(const std::string& up_axis) const {
    std::ostringstream out;
    out << "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\"><asset><up_axis>" << up_axis
        << "</up_axis></asset>\n<library_geometries><geometry id=\"g\"><mesh><source id=\"p\">"
        << "<float_array id=\"a\" count=\"18\">\n";
    for (const auto& v : vertices)
        if (up_axis == "Z_UP")
            out << v.x << ' ' << -v.z << ' ' << v.y << '\n';
        else if (up_axis == "X_UP")
            out << v.y << ' ' << -v.x << ' ' << v.z << '\n';
        else
            out << v.x << ' ' << v.y << ' ' << v.z << '\n';
    out << "</float_array><technique_common><accessor source=\"#a\" count=\"6\" "
           "stride=\"3\"/></technique_common>"
        << "</source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
        << "<triangles count=\"8\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>\n";
    for (const auto& [a, b, c] : triangles) out << a << ' ' << b << ' ' << c << '\n';
    out << "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene "
           "id=\"s\">"
        << "<node><instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
        << "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
    return out.str();
}

std::string gz_of(const std::string& bytes) {
    z_stream z{};
    deflateInit2(&z, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string out(bytes.size() + 1000, '\0');
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    z.avail_in = static_cast<uInt>(bytes.size());
    z.next_out = reinterpret_cast<Bytef*>(out.data());
    z.avail_out = static_cast<uInt>(out.size());
    deflate(&z, Z_FINISH);
    out.resize(z.total_out);
    deflateEnd(&z);
    return out;
}

std::string glb_of(std::string text, std::string binary) {
    while (text.size() % 4 != 0) text += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    const auto size = [](const std::string& s) { return raw(static_cast<std::uint32_t>(s.size())); };
    const std::string body = size(text) + "JSON" + text + size(binary) + std::string("BIN\0", 4) + binary;
    return "glTF" + raw(std::uint32_t{2}) + raw(static_cast<std::uint32_t>(12 + body.size())) + body;
}

std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t held = 0;
        for (std::size_t k = 0; k < 3; ++k)
            held = held << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : digits[held >> (18 - 6 * k) & 63];
    }
    return out;
}

}   // namespace rayclock::test
