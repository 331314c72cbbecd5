// Owners for Embree's reference-counted handles.
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <type_traits>

namespace idap::render {

struct EmbreeRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using DeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, EmbreeRelease>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease>;
using GeometryHandle = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, EmbreeRelease>;

}  // namespace idap::render
