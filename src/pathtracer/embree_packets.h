#pragma once
// Rays in packets, as Embree takes them, and its answers out of them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pathtracer/accelerator.h"
#include "pathtracer/embree.h"

namespace emulsion {

[[nodiscard]] inline int widest_native_packet(RTCDevice device) {
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) return 16;
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0) return 8;
    return 4;
}

/// Fills the lanes of a packet; those past the end of `rays` repeat the last ray and are switched off.
template <int Width, class Packet>
void fill(Packet& packet, int* valid, std::span<const Ray> rays) noexcept {
    for (std::size_t lane = 0; lane < Width; ++lane) {
        valid[lane] = lane < rays.size() ? -1 : 0;
        const Ray& ray = rays[std::min(lane, rays.size() - 1)];
        packet.org_x[lane] = ray.origin.x;
        packet.org_y[lane] = ray.origin.y;
        packet.org_z[lane] = ray.origin.z;
        packet.tnear[lane] = 0.0f;
        packet.dir_x[lane] = ray.direction.x;
        packet.dir_y[lane] = ray.direction.y;
        packet.dir_z[lane] = ray.direction.z;
        packet.time[lane] = 0.0f;
        packet.tfar[lane] = ray.t_max;
        packet.mask[lane] = ~0u;
        packet.id[lane] = 0;
        packet.flags[lane] = 0;
    }
}

/// hits[i] = hit_of(t, u, v, geometry, primitive, instance), by Embree's numbers, for the first hit of rays[i].
template <int Width, class HitOf>
void intersect_packets(RTCScene scene, std::span<const Ray> rays, std::span<Hit> hits, const HitOf& hit_of) noexcept {
    typename EmbreePacket<Width>::RayHit packet;
    alignas(4 * Width) int valid[Width];
    for (std::size_t begin = 0; begin < rays.size(); begin += Width) {
        const auto chunk = rays.subspan(begin, std::min<std::size_t>(Width, rays.size() - begin));
        fill<Width>(packet.ray, valid, chunk);
        for (std::size_t lane = 0; lane < Width; ++lane) {
            packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
        }
        embree_intersect<Width>(valid, scene, packet);
        for (std::size_t lane = 0; lane < chunk.size(); ++lane) {
            hits[begin + lane] = hit_of(packet.ray.tfar[lane], packet.hit.u[lane], packet.hit.v[lane],
                                        packet.hit.geomID[lane], packet.hit.primID[lane], packet.hit.instID[0][lane]);
        }
    }
}

/// occluded[i] = 1 if rays[i] meets anything, else 0.
template <int Width>
void occluded_packets(RTCScene scene, std::span<const Ray> rays, std::span<std::uint8_t> occluded) noexcept {
    typename EmbreePacket<Width>::Ray packet;
    alignas(4 * Width) int valid[Width];
    for (std::size_t begin = 0; begin < rays.size(); begin += Width) {
        const auto chunk = rays.subspan(begin, std::min<std::size_t>(Width, rays.size() - begin));
        fill<Width>(packet, valid, chunk);
        embree_occluded<Width>(valid, scene, packet);
        // Embree marks an occluded ray by setting its end to minus infinity.
        for (std::size_t lane = 0; lane < chunk.size(); ++lane) occluded[begin + lane] = packet.tfar[lane] < 0.0f;
    }
}

}  // namespace emulsion
