#pragma once
// Scenes in Embree, the second opinion on the reference.
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <glm/geometric.hpp>

#include "model/scene/hit.hpp"
#include "model/scene/placed.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Returns what a ray with a unit direction meets, with its distance.
inline RTCRayHit embree_hit(RTCScene scene, const glm::dvec3& origin, const glm::dvec3& direction) {
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(origin.x);
    query.ray.org_y = static_cast<float>(origin.y);
    query.ray.org_z = static_cast<float>(origin.z);
    query.ray.dir_x = static_cast<float>(direction.x);
    query.ray.dir_y = static_cast<float>(direction.y);
    query.ray.dir_z = static_cast<float>(direction.z);
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = 0xffff'ffffu;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
#endif
    return query;
}

/// A scene in Embree 3 or 4, in single precision.
class EmbreeWorld {
public:
    explicit EmbreeWorld(RTCSceneFlags flags) : device_(rtcNewDevice("threads=1")) {
        if (device_ == nullptr) throw std::runtime_error("Embree has no device");
        scene_ = new_scene(flags);
    }
    ~EmbreeWorld() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeWorld(const EmbreeWorld&) = delete;
    EmbreeWorld& operator=(const EmbreeWorld&) = delete;

protected:
    RTCScene new_scene(RTCSceneFlags flags) {
        RTCScene made = rtcNewScene(device_);
        rtcSetSceneFlags(made, flags);
        return made;
    }
    RTCGeometry new_geometry(RTCGeometryType type) { return rtcNewGeometry(device_, type); }
    template <class T> static T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                                        std::size_t components, std::size_t count) {
        return static_cast<T*>(
            rtcSetNewGeometryBuffer(geometry, type, 0, format, components * sizeof(T), count));
    }
    /// Attaches a geometry and returns its number.
    static unsigned attach(RTCScene scene, RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        const unsigned number = rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        return number;
    }
    /// `Mesh` is a Scene or a SharedMesh.
    template <class Mesh> unsigned add_triangles(RTCScene scene, const Mesh& mesh) {
        RTCGeometry geometry = new_geometry(RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex =
            buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3, mesh.vertices.size());
        for (const glm::dvec3& v : mesh.vertices)
            for (int k = 0; k < 3; ++k) *vertex++ = static_cast<float>(v[k]);
        auto* index =
            buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3, mesh.triangles.size());
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t v : t.vertex) *index++ = v;
        return attach(scene, geometry);
    }

    RTCScene scene_;

private:
    RTCDevice device_;
};

/// A single geometry, whose primitive numbers are the scene's.
class EmbreeGeometry : public EmbreeWorld {
public:
    using EmbreeWorld::EmbreeWorld;

    /// Returns the closest hit. `direction` must be a unit vector, so that depth is the distance.
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
        const RTCRayHit query = embree_hit(scene_, origin, direction);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        return {query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
    }
};

/// A scene's triangles.
class EmbreeScene : public EmbreeGeometry {
public:
    EmbreeScene(const Scene& scene, RTCSceneFlags flags) : EmbreeGeometry(flags) {
        add_triangles(scene_, scene);
        rtcCommitScene(scene_);
    }
};

/// A scene's spheres.
class EmbreeSpheres : public EmbreeGeometry {
public:
    explicit EmbreeSpheres(const Scene& scene) : EmbreeGeometry(RTC_SCENE_FLAG_ROBUST) {
        RTCGeometry geometry = new_geometry(RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* sphere =
            buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, scene.spheres.size());
        for (const Sphere& s : scene.spheres) {
            for (int k = 0; k < 3; ++k) *sphere++ = static_cast<float>(s.centre[k]);
            *sphere++ = static_cast<float>(s.radius);
        }
        attach(scene_, geometry);
        rtcCommitScene(scene_);
    }
};

/// A scene of triangles and instances, as Embree's own instances. A primitive has its number in the flat
/// scene.
class EmbreeInstances : public EmbreeWorld {
public:
    explicit EmbreeInstances(const PlacedScene& scene) : EmbreeWorld(RTC_SCENE_FLAG_ROBUST) {
        if (!scene.own.triangles.empty()) add_triangles(scene_, scene.own);
        for (const SharedMesh& mesh : scene.meshes) {
            meshes_.push_back(new_scene(RTC_SCENE_FLAG_ROBUST));
            add_triangles(meshes_.back(), mesh);
            rtcCommitScene(meshes_.back());
        }
        auto next = static_cast<std::uint32_t>(scene.own.triangles.size());
        for (const Instance& instance : scene.instances) {
            RTCGeometry geometry = new_geometry(RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(geometry, meshes_[instance.mesh]);
            float place[16];
            for (int i = 0; i < 16; ++i) place[i] = static_cast<float>(instance.place[i / 4][i % 4]);
            rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, place);
            firsts_[attach(scene_, geometry)] = next;
            next += static_cast<std::uint32_t>(scene.meshes[instance.mesh].triangles.size());
        }
        rtcCommitScene(scene_);
    }
    ~EmbreeInstances() {
        for (RTCScene mesh : meshes_) rtcReleaseScene(mesh);
    }

    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
        const RTCRayHit query = embree_hit(scene_, origin, direction);
        const unsigned instance = query.hit.instID[0];
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        const std::uint32_t first = instance == RTC_INVALID_GEOMETRY_ID ? 0 : firsts_.at(instance);
        return {first + query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
    }

private:
    std::vector<RTCScene> meshes_;
    std::map<unsigned, std::uint32_t> firsts_;   ///< the first primitive of each instance
};

}   // namespace rayclock
