// SPDX-License-Identifier: BSD-3-Clause
// Implementation of the PCL class: check the input, run the extractor, fill PCL's types. The library holds it compiled
// for PCL's point types.
#pragma once

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>

#include <algorithm>
#include <cstddef>
#include <new>
#include <numeric>
#include <type_traits>
#include <utility>

#include "epcc_segmentation/pcl/epcc_segmentation.h"

namespace epcc {

template <typename PointT>
void EPCCSegmentation<PointT>::setIndices(const pcl::IndicesConstPtr& indices) {
  setIndices(indices ? pcl::make_shared<pcl::Indices>(*indices) : pcl::IndicesPtr());
}

template <typename PointT>
void EPCCSegmentation<PointT>::setIndices(const pcl::PointIndices::ConstPtr& indices) {
  setIndices(indices ? pcl::make_shared<pcl::Indices>(indices->indices) : pcl::IndicesPtr());
}

template <typename PointT>
void EPCCSegmentation<PointT>::setIndices(std::size_t row_start, std::size_t col_start, std::size_t nb_rows,
                                          std::size_t nb_cols) {
  if (input_) {
    pcl::PCLBase<PointT>::setIndices(row_start, col_start, nb_rows, nb_cols);
  } else {
    report("setIndices", Status::NoInput, "a rectangle of indices needs the cloud first: call setInputCloud()");
  }
}

template <typename PointT>
void EPCCSegmentation<PointT>::setMinInliers(unsigned points) {
  const auto largest = static_cast<unsigned>(std::numeric_limits<int>::max());
  const int fewest = static_cast<int>(std::min(points, largest));
  parameters_.paper.min_points = fewest;
  parameters_.inverse_depth.min_points = std::max(1, fewest);
}

template <typename PointT>
unsigned EPCCSegmentation<PointT>::getMinInliers() const {
  const bool paper = parameters_.mode == Mode::Paper;
  return static_cast<unsigned>(paper ? parameters_.paper.min_points : parameters_.inverse_depth.min_points);
}

template <typename PointT>
bool EPCCSegmentation<PointT>::setSensorModel(const std::string& preset_name) {
  if (preset_name == "auto") {
    setSensorModelAuto();
    return true;
  }
  const std::optional<SensorModel> sensor = SensorModel::preset(preset_name);
  if (sensor) setSensorModel(*sensor);
  return sensor.has_value();
}

template <typename PointT>
void EPCCSegmentation<PointT>::warnWithoutEffect(unsigned call, const char* name, const char* why) {
  if ((warned_ >> call) & 1u) return;
  warned_ |= 1u << call;
  PCL_WARN("[epcc::%s::%s] has no effect: %s.\n", getClassName().c_str(), name, why);
}

template <typename PointT>
void EPCCSegmentation<PointT>::segment(std::vector<pcl::ModelCoefficients>& model_coefficients,
                                       std::vector<pcl::PointIndices>& inlier_indices) {
  const auto clear = [&] {
    model_coefficients.clear();
    inlier_indices.clear();
  };
  attempt("segment", clear, [&] {
    if (!compute("segment")) return false;
    copyModels(model_coefficients);
    copyInliers(inlier_indices);
    return true;
  });
}

template <typename PointT>
void EPCCSegmentation<PointT>::extract(std::vector<pcl::PointIndices>& clusters) {
  const auto clear = [&] { clusters.clear(); };
  attempt("extract", clear, [&] {
    if (!compute("extract")) return false;
    copyInliers(clusters);
    return true;
  });
}

template <typename PointT>
bool EPCCSegmentation<PointT>::compute(const char* method) {
  static_assert(std::is_same<decltype(PointT::x), float>::value, "the coordinates must be float");
  static_assert(sizeof(PointT) % sizeof(float) == 0, "points must be a whole number of floats apart");

  std::string what;
  const Status status = checkInput(what);
  if (status != Status::Ok) return report(method, status, what);

  if (parameters_.mode == Mode::Paper && inverse_depth_set_)
    warnWithoutEffect(7, "setLineKMax, setPlaneKMax, setRegionTolerance",
                      "the paper mode is set; its settings are in paper()");

  const auto width = static_cast<int>(input_->width);
  const auto height = static_cast<int>(input_->height);
  const float* points = &input_->points.front().x;
  constexpr std::size_t kStride = sizeof(PointT) / sizeof(float);
  findGeometry();
  const DepthFrame frame = DepthFrame::fromPoints(points, kStride, width, height, geometry_).masked(updateMask());
  extractor_.setParameters(parameters_);
  extractor_.extract(frame, segmentation_);
  return report(method, extractor_.status(), extractor_.error());
}

template <typename PointT>
void EPCCSegmentation<PointT>::findGeometry() {
  CloudOptions options = cloud_options_;
  const Eigen::Vector3f origin = input_->sensor_origin_.template head<3>();
  if (!origin.isZero() || !input_->sensor_orientation_.matrix().isIdentity()) {
    options.viewpoint = SensorPose();
    options.viewpoint->origin = origin.template cast<double>();
    options.viewpoint->axes = input_->sensor_orientation_.normalized().toRotationMatrix().template cast<double>();
    if (!options.viewpoint->origin.allFinite() || !options.viewpoint->axes.allFinite()) options.viewpoint.reset();
  }
  geometry_ = finder_.find(&input_->points.front().x, sizeof(PointT) / sizeof(float), static_cast<int>(input_->width),
                           static_cast<int>(input_->height), options);
  if (!geometry_.unit_is_guessed || unit_warned_) return;
  unit_warned_ = true;
  PCL_WARN("[epcc::%s::setUnit] the unit is taken as the millimetre: as metres the points would be too far away.\n",
           getClassName().c_str());
}

template <typename PointT>
Plane EPCCSegmentation<PointT>::inCloudUnits(const Plane& plane) const {
  const double unit = geometry_.unit;
  Plane own = plane;
  own.coefficients(3) /= unit;
  own.centroid /= unit;
  own.points_covariance /= unit * unit;
  own.rms /= unit;
  return own;
}

template <typename PointT>
Status EPCCSegmentation<PointT>::checkInput(std::string& what) const {
  if (!input_) {
    what = "no input cloud: call setInputCloud() first";
    return Status::NoInput;
  }
  const auto size = static_cast<std::uint64_t>(input_->points.size());
  const std::uint64_t pixels = static_cast<std::uint64_t>(input_->width) * input_->height;
  if (size != pixels) {
    what = "the cloud has " + std::to_string(size) + " points, not width * height = " + std::to_string(pixels);
    return Status::SizeMismatch;
  }
  if (size == 0) {
    what = "the cloud is empty";
    return Status::EmptyCloud;
  }
  if (input_->height <= 1) {
    what = "the cloud is not organized: it has one row";
    return Status::Unorganized;
  }
  if (size > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
    what = "the cloud has more points than an index can name";
    return Status::SizeMismatch;
  }
  if (!indices_ || fake_indices_) return Status::Ok;
  for (const auto index : *indices_) {
    if (index >= 0 && static_cast<std::uint64_t>(index) < size) continue;
    what = "index " + std::to_string(index) + " is outside the cloud of " + std::to_string(size) + " points";
    return Status::InvalidIndices;
  }
  return Status::Ok;
}

template <typename PointT>
bool EPCCSegmentation<PointT>::report(const char* method, Status status, const std::string& what) {
  status_ = status;
  error_ = status == Status::Ok ? std::string() : what;
  if (status == Status::Ok) return true;
  segmentation_ = PlaneSegmentation();
  try {
    PCL_ERROR("[epcc::%s::%s] %s.\n", getClassName().c_str(), method, what.c_str());
  } catch (const std::bad_alloc&) {
    // Printing takes memory, too: without any the status has to do.
  }
  return false;
}

template <typename PointT>
const std::uint8_t* EPCCSegmentation<PointT>::updateMask() {
  if (!indices_ || fake_indices_) return nullptr;
  mask_.assign(input_->points.size(), 0);
  for (const auto index : *indices_) mask_[static_cast<std::size_t>(index)] = 1;
  return mask_.data();
}

template <typename PointT>
void EPCCSegmentation<PointT>::copyModels(std::vector<pcl::ModelCoefficients>& model_coefficients) const {
  model_coefficients.resize(segmentation_.planes.size());
  for (std::size_t k = 0; k < model_coefficients.size(); ++k) {
    const Eigen::Vector4f coefficients = inCloudUnits(segmentation_.planes[k]).coefficients.template cast<float>();
    model_coefficients[k].header = input_->header;
    model_coefficients[k].values.assign(coefficients.data(), coefficients.data() + 4);
  }
}

template <typename PointT>
void EPCCSegmentation<PointT>::copyInliers(std::vector<pcl::PointIndices>& inlier_indices) const {
  inlier_indices.resize(segmentation_.planes.size());
  for (std::size_t k = 0; k < inlier_indices.size(); ++k) {
    inlier_indices[k].header = input_->header;
    inlier_indices[k].indices.clear();
    inlier_indices[k].indices.reserve(segmentation_.planes[k].pixel_count);
  }
  // Run by run: neighbours have mostly the same label.
  const std::int32_t* labels = segmentation_.labels.data();
  const std::size_t size = segmentation_.labels.size();
  for (std::size_t begin = 0, end = 0; begin < size; begin = end) {
    const std::int32_t label = labels[begin];
    for (end = begin + 1; end < size && labels[end] == label;) ++end;
    if (label == 0) continue;
    pcl::Indices& indices = inlier_indices[static_cast<std::size_t>(label - 1)].indices;
    const std::size_t before = indices.size();
    indices.resize(before + (end - begin));
    std::iota(indices.data() + before, indices.data() + indices.size(), static_cast<pcl::index_t>(begin));
  }
}

}  // namespace epcc

#define PCL_INSTANTIATE_EPCCSegmentation(T) template class EPCC_CORE_EXPORT epcc::EPCCSegmentation<T>;
