#pragma once
#include <stdexcept>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <glm/geometric.hpp>

#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// One geometry in Embree 3 or 4, single precision: its primitive numbers are the scene's.
class EmbreeGeometry {
public:
    EmbreeGeometry(RTCSceneFlags flags, RTCGeometryType type) : device_(rtcNewDevice("threads=1")) {
        if (device_ == nullptr) throw std::runtime_error("Embree has no device");
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, flags);
        geometry_ = rtcNewGeometry(device_, type);
    }
    ~EmbreeGeometry() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeGeometry(const EmbreeGeometry&) = delete;
    EmbreeGeometry& operator=(const EmbreeGeometry&) = delete;

    /// Closest hit; `direction` must be a unit vector, so that depth is the distance.
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
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
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect1(scene_, &query);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &query);
#endif
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        return {query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
    }

protected:
    template <class T>
    T* buffer(RTCBufferType type, RTCFormat format, std::size_t components, std::size_t count) {
        return static_cast<T*>(
            rtcSetNewGeometryBuffer(geometry_, type, 0, format, components * sizeof(T), count));
    }
    void commit() {
        rtcCommitGeometry(geometry_);
        rtcAttachGeometry(scene_, geometry_);
        rtcReleaseGeometry(geometry_);
        rtcCommitScene(scene_);
    }

private:
    RTCDevice device_;
    RTCScene scene_;
    RTCGeometry geometry_;
};

/// A scene's triangles.
class EmbreeScene : public EmbreeGeometry {
public:
    EmbreeScene(const Scene& scene, RTCSceneFlags flags) : EmbreeGeometry(flags, RTC_GEOMETRY_TYPE_TRIANGLE) {
        auto* vertex = buffer<float>(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3, scene.vertices.size());
        for (const glm::dvec3& v : scene.vertices)
            for (int k = 0; k < 3; ++k) *vertex++ = static_cast<float>(v[k]);
        auto* index = buffer<unsigned>(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3, scene.triangles.size());
        for (const Triangle& t : scene.triangles)
            for (const std::uint32_t v : t.vertex) *index++ = v;
        commit();
    }
};

/// A scene's spheres.
class EmbreeSpheres : public EmbreeGeometry {
public:
    explicit EmbreeSpheres(const Scene& scene)
        : EmbreeGeometry(RTC_SCENE_FLAG_ROBUST, RTC_GEOMETRY_TYPE_SPHERE_POINT) {
        auto* sphere = buffer<float>(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, scene.spheres.size());
        for (const Sphere& s : scene.spheres) {
            for (int k = 0; k < 3; ++k) *sphere++ = static_cast<float>(s.centre[k]);
            *sphere++ = static_cast<float>(s.radius);
        }
        commit();
    }
};

}   // namespace rayclock
