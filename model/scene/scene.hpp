#pragma once
// A scene as given, in double precision, and its checks.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "model/scene/texture.hpp"

namespace rayclock {

/// Surface of a primitive, in the terms of Haines' NFF (spd: R G B Kd Ks shine T index).
struct Material {
    std::string name;
    glm::dvec3 colour{0.8};   ///< diffuse reflectance, linear RGB, 0..1
    double ambient = 0.1;     ///< weight of the surrounding light (Ka)
    double diffuse = 0.9;     ///< weight of Lambert's term (Kd)
    double highlight = 0;     ///< weight of the Phong highlight (Kh)
    double shine = 1;         ///< Phong cosine exponent
    double mirror = 0;        ///< weight of the reflected ray (Ks)
    double transmit = 0;      ///< weight of the refracted ray (T)
    double index = 1;         ///< refractive index of the inside; the surrounding medium is 1
    bool checkered = false;   ///< for a plane: every second square has the colour `other`
    glm::dvec3 other{0.2};
    /// Fresnel's term weights `mirror` and `transmit`, in the approximation of Schlick 1994.
    bool schlick = false;
    /// Index into Scene::textures: the picture multiplies the surface's colour. The picture on a sphere is
    /// octahedral (octahedral_picture()), so a loader gives textured spheres materials of their own.
    std::optional<std::uint32_t> texture{};
    /// A triangle has a hole where its texture's alpha is below this. 0: no holes. Spheres and planes have no
    /// holes. Only finished pictures show holes, and light passes through them.
    double cutoff = 0;
};

/// Point light without attenuation; `colour` is its strength (spd: 1/sqrt(number of lights)).
struct Light {
    glm::dvec3 position{0};
    glm::dvec3 colour{1};
};

/// A part of a picture: the pixel of the whole at its top left, and the size of the whole.
struct PictureWindow {
    int x = 0, y = 0;
    int whole_width = 0, whole_height = 0;
    friend bool operator==(const PictureWindow&, const PictureWindow&) = default;
};

/// Pin-hole camera. `fov_degrees` is the full vertical angle between the top and bottom edges of the picture.
/// A pixel is square, so the horizontal angle follows from the picture's aspect.
struct Camera {
    glm::dvec3 eye{0, 0, 5};
    glm::dvec3 at{0};
    glm::dvec3 up{0, 1, 0};
    double fov_degrees = 45;
    /// If given, the picture is a part of a larger one, and the other members describe the whole.
    std::optional<PictureWindow> window{};
};

/// Three indices into Scene::vertices, counter-clockwise seen from outside, and one into materials.
struct Triangle {
    std::array<std::uint32_t, 3> vertex{};
    std::uint32_t material = 0;
};

/// Seen from outside and, if its material transmits, from inside.
struct Sphere {
    glm::dvec3 centre{0};
    double radius = 1;
    std::uint32_t material = 0;
    /// The rotation from the axes of a picture to the axes of the scene. A loader applies it when it makes
    /// the picture octahedral: the picture's top lies on turn[1], and its middle on turn[2].
    glm::dmat3 turn{1};
};

/// The infinite plane of points point + s u + t v for all s and t. u and v, at right angles, are the sides of
/// a checker square: square (floor s, floor t) has the material's `other` colour if floor s + floor t is odd.
/// Seen from both sides.
struct Plane {
    glm::dvec3 point{0}, u{1, 0, 0}, v{0, 0, -1};
    std::uint32_t material = 0;
    /// (s, t) of a texture at point, point + u and point + v. By default the picture fills a square, with its
    /// upper edge at point + v.
    CornerCoordinates coordinates{{{0, 1}, {1, 1}, {0, 0}}};
};

/// A scene as given: double precision, scene units, without snapping. Every engine reports hits by a
/// primitive's number: its index in `triangles`, continued in `spheres` and then in `planes`.
struct Scene {
    std::string name;
    std::vector<glm::dvec3> vertices;
    std::vector<glm::dvec3> normals;   ///< unit vertex normals, or empty: flat shading everywhere
    std::vector<Triangle> triangles;
    /// (s, t) of the corners of each triangle. Empty if no triangle has a texture.
    std::vector<CornerCoordinates> coordinates;
    std::vector<Sphere> spheres;
    std::vector<Plane> planes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Light> lights;
    std::optional<Camera> camera;   ///< if absent, fit_camera() finds one
    glm::dvec3 background{0.078, 0.361, 0.753};
    /// The source of a scene with instances; a machine of two levels walks it.
    std::shared_ptr<const struct PlacedScene> placed;
};

inline std::size_t primitive_count(const Scene& scene) {
    return scene.triangles.size() + scene.spheres.size() + scene.planes.size();
}

/// Returns the number of the texture that a primitive shows, or nothing.
std::optional<std::uint32_t> texture_of(const Scene& scene, std::size_t primitive);
/// True if triangles of the scene have texture coordinates, or a sphere or plane shows a texture.
bool shows_textures(const Scene& scene);

/// Axis-aligned bounds of all vertices that triangles use, and of spheres. Planes are infinite and do not
/// count. A scene with only planes has the bounds of 10 x 10 squares around the first plane's point.
struct Bounds {
    glm::dvec3 lo{0}, hi{0};
};
/// Returns the bounds. Throws UserError if the scene has no primitive.
Bounds bounds(const Scene& scene);

constexpr double max_light = 16;   ///< largest component of a light's colour

/// Throws UserError unless the scene can be traced. It needs primitives and materials, and indices in range.
/// Coordinates must be finite, radii above 0, and sides of planes not parallel. Colours and weights must lie
/// within 0 and 1. A refractive index must be above 0 if the material transmits. Textured triangles must have
/// coordinates within max_coordinate. The camera must have a view, with an angle in (0, 180). A scene may
/// have no light. `where` begins the sentence.
void check_scene(const Scene& scene, const std::string& where);

/// Returns a camera that sees the whole scene from front, right and above, and looks at the middle of its
/// bounds. The angle is 45 degrees; `aspect` is width over height. Throws UserError if the scene is too large
/// to be seen whole.
Camera fit_camera(const Scene& scene, double aspect);

}   // namespace rayclock
