// SPDX-License-Identifier: BSD-3-Clause
// Presets, checks and the command-line form of the sensor model.
#include "epcc_segmentation/sensor_model.h"

#include <array>
#include <cstdio>
#include <string_view>

#include "typed_number.h"

namespace epcc {

namespace {

constexpr double kMaxCoefficient = 1000.0;

struct Preset {
  const char* name;
  SensorModel model;
};

// What each is for: docs/tutorial.md, "Which sensor model".
const std::array<Preset, 7>& presets() {
  static const std::array<Preset, 7> table = {{
      {"d435i", SensorModel::polynomial(0.006954, -0.003713, 0.001153, 2.0)},
      {"kinect-v1", SensorModel::axial(0.0015, 0.003, 4.0)},
      {"realsense", SensorModel::axial(0.0035, 0.0055, 6.0)},
      {"realsense-registered", SensorModel::axial(0.0035, 0.0055, 9.5)},
      {"rendered", SensorModel::axial(0.001, 0.0, 1.0)},
      {"structure-sensor", SensorModel::axial(0.0015, 0.003, 4.0)},
      {"structured-light", SensorModel::axial(0.001, 0.0, 1.0)},
  }};
  return table;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Exactly three finite comma-separated numbers, or nothing.
std::optional<std::array<double, 3>> threeNumbers(std::string_view text) {
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? text.find(',') : text.size();
    if (end == std::string_view::npos) return std::nullopt;
    values[i] = typedNumber(text.substr(0, end));
    if (!std::isfinite(values[i])) return std::nullopt;
    text.remove_prefix(i < 2 ? end + 1 : end);
  }
  return values;
}

}  // namespace

SensorModel SensorModel::polynomial(double k1, double k2, double k3, double correlation_length) {
  return SensorModel(true, k1, k2, k3, correlation_length);
}

SensorModel SensorModel::axial(double a, double b, double correlation_length) {
  return SensorModel(false, a, b, 0.0, correlation_length);
}

std::optional<SensorModel> SensorModel::preset(const std::string& name) {
  for (const auto& entry : presets())
    if (name == entry.name) return entry.model;
  return std::nullopt;
}

std::vector<std::string> SensorModel::presetNames() {
  std::vector<std::string> names;
  for (const auto& entry : presets()) names.emplace_back(entry.name);
  return names;
}

std::optional<SensorModel> SensorModel::parse(const std::string& text, std::string* why) {
  const auto fail = [why](const std::string& reason) {
    if (why != nullptr) *why = reason;
    return std::optional<SensorModel>();
  };
  if (auto named = preset(text)) return named;
  const bool is_polynomial = text.rfind("poly:", 0) == 0;
  const auto values = threeNumbers(is_polynomial ? text.substr(5) : text);
  if (!values)
    return fail("'" + text + "' is neither a preset (" + joined(presetNames()) +
                ") nor A,B,L nor poly:K1,K2,K3 with three finite numbers");
  const auto& v = *values;
  const SensorModel model = is_polynomial ? polynomial(v[0], v[1], v[2]) : axial(v[0], v[1], v[2]);
  const std::string problem = model.validate();
  if (!problem.empty()) return fail("'" + text + "': " + problem);
  return model;
}

std::string SensorModel::validate() const {
  for (const double k : k_)
    if (!std::isfinite(k)) return "the coefficients of sigma_z must be finite";
  if (!std::isfinite(correlation_length_) || correlation_length_ < 0.0 || correlation_length_ > 1000.0)
    return "the correlation length must be in [0, 1000] pixels";
  if (!polynomial_ && (k_[0] < 0.0 || k_[1] < 0.0)) return "a and b of sigma_z must not be negative";
  for (const double k : k_)
    if (std::abs(k) > kMaxCoefficient) return "the coefficients of sigma_z must be at most 1000: they are in metres";
  if (!polynomial_ && k_[0] == 0.0 && k_[1] == 0.0) return "a and b of sigma_z must not both be zero";
  if (polynomial_ && (k_[0] < 0.0 || (k_[0] == 0.0 && k_[1] < 0.0)))
    return "the polynomial sigma_z(z) becomes negative at large z";
  if (polynomial_ && sigmaZ(1.0) <= kMinSigma) return "the polynomial sigma_z(z) is not positive at z = 1 m";
  return {};
}

std::string SensorModel::description() const {
  char text[160];
  if (polynomial_)
    std::snprintf(text, sizeof text, "polynomial k1=%g 1/m k2=%g k3=%g m l=%g px", k_[0], k_[1], k_[2],
                  correlation_length_);
  else
    std::snprintf(text, sizeof text, "axial a=%g m b=%g 1/m l=%g px", k_[0], k_[1], correlation_length_);
  return text;
}

}  // namespace epcc
