#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rayclock {

/// Surface of a triangle, in the terms of Haines' NFF (spd: R G B Kd Ks shine T index).
struct Material {
    std::string name;
    glm::dvec3 colour{0.8};      ///< diffuse reflectance, linear RGB, 0..1
    double ambient = 0.1;        ///< weight of the surrounding light (Ka)
    double diffuse = 0.9;        ///< weight of Lambert's term (Kd)
    double highlight = 0;        ///< weight of the Phong highlight (Kh)
    double shine = 1;            ///< Phong cosine exponent
    double mirror = 0;           ///< weight of the reflected ray (Ks)
    double transmit = 0;         ///< weight of the refracted ray (T)
    double index = 1;            ///< refractive index of the inside; the surrounding medium is 1
};

/// Point light without attenuation; `colour` is its strength (spd: 1/sqrt(number of lights)).
struct Light {
    glm::dvec3 position{0};
    glm::dvec3 colour{1};
};

/// Pin-hole camera. `fov_degrees` is the full vertical angle between the top and bottom edges of the
/// picture; a pixel is square, so the horizontal angle follows from the picture's aspect.
struct Camera {
    glm::dvec3 eye{0, 0, 5};
    glm::dvec3 at{0};
    glm::dvec3 up{0, 1, 0};
    double fov_degrees = 45;
};

/// Three indices into Scene::vertices, counter-clockwise seen from outside, and one into materials.
struct Triangle {
    std::array<std::uint32_t, 3> vertex{};
    std::uint32_t material = 0;
};

/// A scene as given: double precision, scene units, nothing snapped. A primitive's number is its index
/// in `triangles`; every engine reports hits by that number.
struct Scene {
    std::string name;
    std::vector<glm::dvec3> vertices;
    std::vector<glm::dvec3> normals;      ///< unit vertex normals, or empty: flat shading everywhere
    std::vector<Triangle> triangles;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::optional<Camera> camera;         ///< absent: found by fit_camera()
    glm::dvec3 background{0.078, 0.361, 0.753};
};

/// Axis-aligned bounds of all vertices that triangles use. The scene must have a triangle.
struct Bounds {
    glm::dvec3 lo{0}, hi{0};
};
Bounds bounds(const Scene& scene);

/// Throws UserError unless the scene can be traced: it has triangles and materials, indices are in range,
/// coordinates are finite, the camera looks somewhere and its angle lies in (0, 180). `where` begins the sentence.
void check_scene(const Scene& scene, const std::string& where);

/// A camera that sees the whole scene from front, right and above, looking at the middle of its bounds.
/// The angle is 45 degrees; `aspect` is width over height.
Camera fit_camera(const Scene& scene, double aspect);

} // namespace rayclock
