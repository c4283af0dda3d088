#pragma once
#include <stdexcept>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// A scene in Embree 3, single precision, one geometry: its primitive numbers are the scene's.
class EmbreeScene {
public:
    EmbreeScene(const Scene& scene, RTCSceneFlags flags) : device_(rtcNewDevice("threads=1")) {
        if (device_ == nullptr) throw std::runtime_error("Embree has no device");
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, flags);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), scene.vertices.size()));
        for (const glm::dvec3& v : scene.vertices)
            for (int k = 0; k < 3; ++k) *vertex++ = static_cast<float>(v[k]);
        auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), scene.triangles.size()));
        for (const Triangle& t : scene.triangles)
            for (const std::uint32_t v : t.vertex) *index++ = v;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// Closest hit; `direction` must be a unit vector, so that depth is the distance.
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
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
        rtcIntersect1(scene_, &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        return {query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
    }

private:
    RTCDevice device_;
    RTCScene scene_;
};

} // namespace rayclock
