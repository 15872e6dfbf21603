// SPDX-License-Identifier: BSD-3-Clause
// Presets, checks and the command-line form of the sensor model.
#include "epcc_segmentation/sensor_model.h"

#include <algorithm>
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

/// Finite numbers with commas between them; none if the text is anything else, or there are more than four.
std::vector<double> numbersIn(std::string_view text) {
  constexpr std::size_t kMost = 4;
  std::vector<double> values;
  while (values.size() < kMost) {
    const std::size_t end = std::min(text.find(','), text.size());
    values.push_back(typedNumber(text.substr(0, end)));
    if (!std::isfinite(values.back())) return {};
    if (end == text.size()) return values;
    text.remove_prefix(end + 1);
  }
  return {};
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
  const std::vector<double> v = numbersIn(is_polynomial ? text.substr(5) : text);
  const bool has_share = v.size() == 4 && !is_polynomial;
  if (v.size() != 3 && !has_share)
    return fail("'" + text + "' is neither a preset (" + joined(presetNames()) +
                ") nor A,B,L[,C] nor poly:K1,K2,K3, of finite numbers");
  const SensorModel model = is_polynomial ? polynomial(v[0], v[1], v[2])
                                          : axial(v[0], v[1], v[2]).withCorrelatedShare(has_share ? v[3] : 1.0);
  const std::string problem = model.validate();
  if (!problem.empty()) return fail("'" + text + "': " + problem);
  return model;
}

std::string SensorModel::validate() const {
  for (const double k : k_)
    if (!std::isfinite(k)) return "the coefficients of sigma_z must be finite";
  if (!std::isfinite(correlation_length_) || correlation_length_ < 0.0 || correlation_length_ > 1000.0)
    return "the correlation length must be in [0, 1000] pixels";
  if (!(correlated_share_ >= 0.0 && correlated_share_ <= 1.0)) return "the correlated share must be in [0, 1]";
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
  char text[160], share[32] = "";
  if (correlated_share_ < 1.0) std::snprintf(share, sizeof share, " c=%.2g", correlated_share_);
  if (polynomial_)
    std::snprintf(text, sizeof text, "polynomial k1=%g 1/m k2=%g k3=%g m l=%g px%s", k_[0], k_[1], k_[2],
                  correlation_length_, share);
  else
    std::snprintf(text, sizeof text, "axial a=%g m b=%g 1/m l=%g px%s", k_[0], k_[1], correlation_length_, share);
  return text;
}

}  // namespace epcc
