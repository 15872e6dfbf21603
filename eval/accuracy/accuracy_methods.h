// SPDX-License-Identifier: BSD-3-Clause
// The methods of docs/research/accuracy.md, and the parameter whose curve it shows.
#pragma once

#include <string>
#include <vector>

#include "eval/experiment/experiment.h"

namespace epcc {

/// The inverse-depth mode with the sensor measured on the frame, beside the methods of segmenterNames().
constexpr const char* kAutoMethod = "epcc-auto";

/// The forms of EPCC, which have their pictures taken: epcc-auto first, for it is what users get.
std::vector<std::string> epccMethods();
/// The rest of segmenterNames().
std::vector<std::string> otherMethods();
/// Both.
std::vector<std::string> accuracyMethods();

/// kAutoMethod or one of segmenterNames().
Method accuracyMethod(const std::string& name);
std::vector<Method> methodsOf(const std::vector<std::string>& names);

/// A parameter that trades surfaces found against clutter reported, and the values it takes; the default is among
/// them.
struct AccuracyCurve {
  const char* parameter;
  std::vector<double> values;
};
/// epccMethods() for frames in order: with the sensor measured on those so far.
std::vector<Method> sequenceMethods();

AccuracyCurve accuracyCurve();
/// The parameter's default as one of its values is written.
std::string curveDefault();
/// A value as it is written: "4", "0.5".
std::string curveText(double value);
/// kAutoMethod with each value, named after it.
std::vector<Method> curveMethods();

}  // namespace epcc
