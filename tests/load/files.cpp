#include "tests/load/files.hpp"

#include <sstream>

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
