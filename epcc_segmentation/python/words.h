// SPDX-License-Identifier: BSD-3-Clause
// The library's choices as words, as the command line writes them.
#pragma once

#include <optional>
#include <string>

#include "epcc_segmentation/cloud_geometry.h"
#include "epcc_segmentation/projection.h"

namespace epcc::python {

inline const char* projectionWord(Projection projection) {
  switch (projection) {
    case Projection::Perspective:
      return "perspective";
    case Projection::PerspectiveBackward:
      return "perspective-backward";
    default:
      return "spherical";
  }
}

inline std::optional<Projection> projectionOf(const std::string& word) {
  for (const Projection p : {Projection::Perspective, Projection::PerspectiveBackward, Projection::Spherical})
    if (word == projectionWord(p)) return p;
  return std::nullopt;
}

inline const char* sensorWord(CloudOptions::Sensor sensor) {
  switch (sensor) {
    case CloudOptions::Sensor::Camera:
      return "camera";
    case CloudOptions::Sensor::Scanner:
      return "scanner";
    default:
      return "any";
  }
}

inline std::optional<CloudOptions::Sensor> sensorKindOf(const std::string& word) {
  for (const auto s : {CloudOptions::Sensor::Any, CloudOptions::Sensor::Camera, CloudOptions::Sensor::Scanner})
    if (word == sensorWord(s)) return s;
  return std::nullopt;
}

}  // namespace epcc::python
