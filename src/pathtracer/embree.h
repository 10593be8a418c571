#pragma once
// Embree 3 or 4, whichever is installed: the difference between them stays in this file.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace emulsion {

#if RTC_VERSION_MAJOR >= 4

template <int Width, class Rays>
void embree_intersect(const int* valid, RTCScene scene, Rays& rays) noexcept {
    if constexpr (Width == 16) rtcIntersect16(valid, scene, &rays, nullptr);
    if constexpr (Width == 8) rtcIntersect8(valid, scene, &rays, nullptr);
    if constexpr (Width == 4) rtcIntersect4(valid, scene, &rays, nullptr);
}

template <int Width, class Rays>
void embree_occluded(const int* valid, RTCScene scene, Rays& rays) noexcept {
    if constexpr (Width == 16) rtcOccluded16(valid, scene, &rays, nullptr);
    if constexpr (Width == 8) rtcOccluded8(valid, scene, &rays, nullptr);
    if constexpr (Width == 4) rtcOccluded4(valid, scene, &rays, nullptr);
}

#else

template <int Width, class Rays>
void embree_intersect(const int* valid, RTCScene scene, Rays& rays) noexcept {
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    if constexpr (Width == 16) rtcIntersect16(valid, scene, &context, &rays);
    if constexpr (Width == 8) rtcIntersect8(valid, scene, &context, &rays);
    if constexpr (Width == 4) rtcIntersect4(valid, scene, &context, &rays);
}

template <int Width, class Rays>
void embree_occluded(const int* valid, RTCScene scene, Rays& rays) noexcept {
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    if constexpr (Width == 16) rtcOccluded16(valid, scene, &context, &rays);
    if constexpr (Width == 8) rtcOccluded8(valid, scene, &context, &rays);
    if constexpr (Width == 4) rtcOccluded4(valid, scene, &context, &rays);
}

#endif

/// Embree's packet types by width.
template <int Width>
struct EmbreePacket;
template <>
struct EmbreePacket<4> {
    using Ray = RTCRay4;
    using RayHit = RTCRayHit4;
};
template <>
struct EmbreePacket<8> {
    using Ray = RTCRay8;
    using RayHit = RTCRayHit8;
};
template <>
struct EmbreePacket<16> {
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;
};

}  // namespace emulsion
