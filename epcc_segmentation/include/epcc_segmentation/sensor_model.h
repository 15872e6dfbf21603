// SPDX-License-Identifier: BSD-3-Clause
// What is known of a depth sensor's error: its size sigma_z(z) and its correlation length.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/export.h"

namespace epcc {

/// Noise model of a depth sensor. There is no default one: where none is given, it is measured on the frames
/// (sensor_estimation.h).
///
/// The error of a depth z (metres along the optical axis; for a spherical scan the range) has the
/// standard deviation sigma_z(z), in one of two forms:
///  - polynomial, Eq. 22 of the paper: sigma_z = k1 z^2 + k2 z + k3;
///  - axial: sigma_z^2 = a^2 + (b z^2)^2, a floor plus the growth of a triangulating sensor.
///
/// Real depth error comes in blotches: correlationLength() is their Gaussian radius in pixels.
class EPCC_CORE_EXPORT SensorModel {
 public:
  /// Eq. 22: sigma_z = k1 z^2 + k2 z + k3, metres (k1 in 1/m, k2 unitless, k3 in m).
  static SensorModel polynomial(double k1, double k2, double k3, double correlation_length = 1.0);
  /// sigma_z^2 = a^2 + (b z^2)^2 with a in metres, b in 1/m.
  static SensorModel axial(double a, double b, double correlation_length = 1.0);

  /// Named preset, or nothing if the name is unknown. Names: presetNames().
  static std::optional<SensorModel> preset(const std::string& name);
  /// d435i, kinect-v1, realsense, realsense-registered, rendered, structure-sensor, structured-light.
  static std::vector<std::string> presetNames();
  /// Reads the command-line form `PRESET | A,B,L[,C] | poly:K1,K2,K3` (metres, 1/m, pixels, correlated share).
  /// On failure returns nothing and, if `why` is given, says what is wrong.
  static std::optional<SensorModel> parse(const std::string& text, std::string* why = nullptr);

  /// Standard deviation in metres of a depth of z metres; never below one micrometre.
  double sigmaZ(double z) const { return std::sqrt(varianceZ(z)); }
  /// sigma_z^2, without a square root.
  double varianceZ(double z) const {
    const double polynomial = (k_[0] * z + k_[1]) * z + k_[2];
    const double spread = polynomial_ ? (polynomial > 0.0 ? polynomial : 0.0) : k_[1] * z * z;
    const double variance = spread * spread + (polynomial_ ? 0.0 : k_[0] * k_[0]);
    return variance > kMinSigma * kMinSigma ? variance : kMinSigma * kMinSigma;
  }
  /// Standard deviation of the inverse depth, sigma_z / z^2, in 1/m.
  double sigmaInverseDepth(double z) const { return sigmaZ(z) / (z * z); }

  /// True for the form of Eq. 22.
  bool isPolynomial() const { return polynomial_; }
  /// (k1, k2, k3) of the polynomial or (a, b, 0) of the axial form.
  std::array<double, 3> coefficients() const { return {k_[0], k_[1], k_[2]}; }

  /// Radius l of the error's autocorrelation exp(-r^2 / (2 l^2)), in pixels of the given grid.
  double correlationLength() const { return correlation_length_; }
  /// The same error with another correlation length, pixels.
  SensorModel withCorrelationLength(double length) const {
    SensorModel model = *this;
    model.correlation_length_ = length;
    return model;
  }
  /// Share of sigma_z^2 in which whole surfaces err together, by blotches and by bending: 0 (white error on perfect
  /// optics) to 1, the default, also where nothing is known. Two regions may lie off each other by that part and be one
  /// surface (S4; half of the tolerance stays). Lower it for simulated sensors with white noise, so that faces a
  /// fraction of sigma apart stay two; SensorEstimate::model() says what was measured.
  double correlatedShare() const { return correlated_share_; }
  /// The same error with another correlated share, 0 to 1.
  SensorModel withCorrelatedShare(double share) const {
    SensorModel model = *this;
    model.correlated_share_ = share;
    return model;
  }
  /// The error `factor` times as large, with the same correlation length.
  SensorModel scaled(double factor) const {
    SensorModel model = *this;
    for (double& k : model.k_) k *= factor;
    return model;
  }
  /// Pixels per independent sample over an area: max(1, 2 pi l^2).
  double pixelsPerSample() const { return std::fmax(1.0, 2.0 * kPi * correlation_length_ * correlation_length_); }
  /// Pixels per independent sample along a line: max(1, 2.5 l).
  double pixelsPerLineSample() const { return std::fmax(1.0, 2.5 * correlation_length_); }

  /// Empty if the model can be used, else what is wrong in words.
  std::string validate() const;
  /// One line for reports, for example "axial a=0.0035 m b=0.0055 1/m l=9.5 px".
  std::string description() const;

 private:
  static constexpr double kMinSigma = 1e-6;
  static constexpr double kPi = 3.14159265358979323846;
  SensorModel(bool is_polynomial, double k0, double k1, double k2, double correlation_length)
      : polynomial_(is_polynomial), k_{k0, k1, k2}, correlation_length_(correlation_length) {}

  bool polynomial_;
  double k_[3];
  double correlation_length_;
  double correlated_share_ = 1.0;
};

}  // namespace epcc
