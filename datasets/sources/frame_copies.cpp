// SPDX-License-Identifier: BSD-3-Clause
// A copy takes each of its pixels from one of the original's; camera and sensor model change accordingly.
#include "datasets/sources/frame_copies.h"

#include <cstdio>
#include <random>
#include <stdexcept>
#include <utility>

#include "epcc_segmentation/sensor_model.h"

namespace epcc {

namespace {

/// The image whose pixel (row, column) is the original's pixel at(row, column).
template <typename Pixel, typename Source>
Image<Pixel> gathered(const Image<Pixel>& original, int width, int height, const Source& source) {
  Image<Pixel> image(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const auto [from_row, from_column] = source(row, column);
      image.at(row, column) = original.at(from_row, from_column);
    }
  return image;
}

template <typename Source>
void gather(LabelledFrame& frame, const Source& source) {
  const PinholeCamera& camera = frame.camera.camera;
  frame.depth = gathered(frame.depth, camera.width, camera.height, source);
  if (!frame.labels.empty()) frame.labels = gathered(frame.labels, camera.width, camera.height, source);
}

/// The command-line form has a correlation length for axial models only.
std::string halvedLength(const std::string& noise) {
  const auto model = SensorModel::parse(noise);
  if (!model || model->isPolynomial()) return noise;
  char text[128];
  std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g,%.17g", model->coefficients()[0], model->coefficients()[1],
                0.5 * model->correlationLength(), model->correlatedShare());
  return text;
}

void mirror(LabelledFrame& frame) {
  PinholeCamera& camera = frame.camera.camera;
  const int last = camera.width - 1;
  camera.cx = last - camera.cx;
  gather(frame, [last](int row, int column) { return std::pair(row, last - column); });
}

void flip(LabelledFrame& frame) {
  PinholeCamera& camera = frame.camera.camera;
  const int last = camera.height - 1;
  camera.cy = last - camera.cy;
  gather(frame, [last](int row, int column) { return std::pair(last - row, column); });
}

void transpose(LabelledFrame& frame) {
  PinholeCamera& camera = frame.camera.camera;
  std::swap(camera.width, camera.height);
  std::swap(camera.fx, camera.fy);
  std::swap(camera.cx, camera.cy);
  gather(frame, [](int row, int column) { return std::pair(column, row); });
}

void halve(LabelledFrame& frame) {
  PinholeCamera& camera = frame.camera.camera;
  camera.width = (camera.width + 1) / 2;
  camera.height = (camera.height + 1) / 2;
  for (double* value : {&camera.fx, &camera.fy, &camera.cx, &camera.cy}) *value *= 0.5;
  if (frame.camera.noise) frame.camera.noise = halvedLength(*frame.camera.noise);
  gather(frame, [](int row, int column) { return std::pair(2 * row, 2 * column); });
}

void removePixels(LabelledFrame& frame) {
  std::mt19937 random(1);
  for (float& depth : frame.depth.data)
    if (random() % 4 == 0) depth = 0.0F;
}

}  // namespace

std::vector<FrameCopy> frameCopies() {
  return {FrameCopy::Mirrored,   FrameCopy::Flipped,        FrameCopy::Turned,
          FrameCopy::Transposed, FrameCopy::HalfResolution, FrameCopy::Holes};
}

bool hasSamePixels(FrameCopy copy) {
  return copy != FrameCopy::HalfResolution && copy != FrameCopy::Holes;
}

std::string copyName(FrameCopy copy) {
  switch (copy) {
    case FrameCopy::Mirrored:
      return "mirrored";
    case FrameCopy::Flipped:
      return "flipped";
    case FrameCopy::Turned:
      return "turned";
    case FrameCopy::Transposed:
      return "transposed";
    case FrameCopy::HalfResolution:
      return "half";
    case FrameCopy::Holes:
      break;
  }
  return "holes";
}

LabelledFrame copiedFrame(const LabelledFrame& frame, FrameCopy copy) {
  if (!frame.scan.empty()) throw std::invalid_argument("only a camera's frame can be copied onto another grid");
  LabelledFrame result = frame;
  if (result.camera.extra.is_object())
    for (const char* key : {"planes", "pose"}) result.camera.extra.erase(key);
  if (copy == FrameCopy::Mirrored || copy == FrameCopy::Turned) mirror(result);
  if (copy == FrameCopy::Flipped || copy == FrameCopy::Turned) flip(result);
  if (copy == FrameCopy::Transposed) transpose(result);
  if (copy == FrameCopy::HalfResolution) halve(result);
  if (copy == FrameCopy::Holes) removePixels(result);
  return result;
}

}  // namespace epcc
