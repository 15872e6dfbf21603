// SPDX-License-Identifier: BSD-3-Clause
// Implementation of the PCL class: check the input, run the extractor, fill PCL's types.
#pragma once

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "epcc_segmentation/contours.h"
#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "epcc_segmentation/pcl/impl/planar_region_builder.hpp"

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
  change(parameters_.plane.min_points, fewest);
  change(parameters_.evidence.min_points, std::max(1, fewest));
}

template <typename PointT>
unsigned EPCCSegmentation<PointT>::getMinInliers() const {
  const bool paper = parameters_.mode == Mode::Paper;
  return static_cast<unsigned>(paper ? parameters_.plane.min_points : parameters_.evidence.min_points);
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
void EPCCSegmentation<PointT>::setSensorModelAuto() {
  estimator_.emplace();
  extractor_.reset();
}

template <typename PointT>
void EPCCSegmentation<PointT>::segment(std::vector<pcl::ModelCoefficients>& model_coefficients,
                                       std::vector<pcl::PointIndices>& inlier_indices) {
  model_coefficients.clear();
  inlier_indices.clear();
  if (!compute("segment")) return;
  copyModels(model_coefficients);
  copyInliers(inlier_indices);
}

template <typename PointT>
void EPCCSegmentation<PointT>::segment(std::vector<pcl::ModelCoefficients>& model_coefficients,
                                       std::vector<pcl::PointIndices>& inlier_indices, Centroids& centroids,
                                       Covariances& covariances, PointCloudL& labels,
                                       std::vector<pcl::PointIndices>& label_indices) {
  model_coefficients.clear();
  inlier_indices.clear();
  centroids.clear();
  covariances.clear();
  labels.clear();
  label_indices.clear();
  if (!compute("segment")) return;
  copyModels(model_coefficients);
  copyInliers(inlier_indices);
  for (const Plane& plane : segmentation_.planes) {
    centroids.push_back(plane.centroid.homogeneous().template cast<float>());
    covariances.push_back(plane.points_covariance.template cast<float>());
  }
  copyLabels(labels);
  label_indices = inlier_indices;
}

template <typename PointT>
void EPCCSegmentation<PointT>::segment(PlanarRegions& regions) {
  regions.clear();
  if (compute("segment")) copyRegions(regions, nullptr);
}

template <typename PointT>
void EPCCSegmentation<PointT>::segmentAndRefine(PlanarRegions& regions) {
  regions.clear();
  if (compute("segmentAndRefine")) copyRegions(regions, nullptr);
}

template <typename PointT>
void EPCCSegmentation<PointT>::segmentAndRefine(PlanarRegions& regions,
                                                std::vector<pcl::ModelCoefficients>& model_coefficients,
                                                std::vector<pcl::PointIndices>& inlier_indices, PointCloudLPtr& labels,
                                                std::vector<pcl::PointIndices>& label_indices,
                                                std::vector<pcl::PointIndices>& boundary_indices) {
  regions.clear();
  model_coefficients.clear();
  inlier_indices.clear();
  if (!labels) labels = pcl::make_shared<PointCloudL>();
  labels->clear();
  label_indices.clear();
  boundary_indices.clear();
  if (!compute("segmentAndRefine")) return;
  copyRegions(regions, &boundary_indices);
  copyModels(model_coefficients);
  copyInliers(inlier_indices);
  copyLabels(*labels);
  label_indices = inlier_indices;
}

template <typename PointT>
void EPCCSegmentation<PointT>::extract(std::vector<pcl::PointIndices>& clusters) {
  clusters.clear();
  if (compute("extract")) copyInliers(clusters);
}

template <typename PointT>
bool EPCCSegmentation<PointT>::compute(const char* method) {
  static_assert(std::is_same<decltype(PointT::x), float>::value, "the coordinates must be float");
  static_assert(sizeof(PointT) % sizeof(float) == 0, "points must be a whole number of floats apart");

  std::string what;
  status_ = checkInput(what);
  if (status_ == Status::Ok) status_ = checkSettings(what);
  if (status_ != Status::Ok) return report(method, status_, what);

  initCompute();
  const DepthFrame frame =
      DepthFrame::fromPoints(&input_->points.front().x, sizeof(PointT) / sizeof(float), static_cast<int>(input_->width),
                             static_cast<int>(input_->height), used_projection_)
          .masked(updateMask());
  if (estimator_) {
    sensor_ = estimator_->update(frame).model();
    extractor_.reset();
  }
  if (!extractor_) extractor_.emplace(parameters_, sensor_);
  const bool done = extractor_->extract(frame, segmentation_);
  deinitCompute();
  return report(method, done ? Status::Ok : Status::Failed, extractor_->error());
}

template <typename PointT>
typename EPCCSegmentation<PointT>::Status EPCCSegmentation<PointT>::checkInput(std::string& what) const {
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
typename EPCCSegmentation<PointT>::Status EPCCSegmentation<PointT>::checkSettings(std::string& what) {
  what = parameters_.validate();
  if (what.empty()) what = sensor_.validate();
  if (!what.empty()) return Status::InvalidParameters;

  used_projection_ = projection_ ? *projection_
                                 : detectProjection(&input_->points.front().x, sizeof(PointT) / sizeof(float),
                                                    static_cast<int>(input_->width), static_cast<int>(input_->height));
  if (used_projection_ == Projection::Spherical && parameters_.scan == ScanDirection::Rows) {
    what = "the rows of a spherical scan are cones: scan it by columns";
    return Status::UnsupportedScan;
  }
  return Status::Ok;
}

template <typename PointT>
bool EPCCSegmentation<PointT>::report(const char* method, Status status, const std::string& what) {
  status_ = status;
  error_ = status == Status::Ok ? std::string() : what;
  if (status == Status::Ok) return true;
  segmentation_ = PlaneSegmentation();
  PCL_ERROR("[epcc::%s::%s] %s.\n", getClassName().c_str(), method, what.c_str());
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
    const Eigen::Vector4f coefficients = segmentation_.planes[k].coefficients.template cast<float>();
    model_coefficients[k].header = input_->header;
    model_coefficients[k].values.assign(coefficients.data(), coefficients.data() + 4);
  }
}

template <typename PointT>
void EPCCSegmentation<PointT>::copyInliers(std::vector<pcl::PointIndices>& inlier_indices) const {
  inlier_indices.resize(segmentation_.planes.size());
  for (std::size_t k = 0; k < inlier_indices.size(); ++k) {
    inlier_indices[k].header = input_->header;
    inlier_indices[k].indices.reserve(segmentation_.planes[k].pixel_count);
  }
  for (std::size_t i = 0; i < segmentation_.labels.size(); ++i) {
    const std::int32_t label = segmentation_.labels[i];
    if (label > 0) inlier_indices[static_cast<std::size_t>(label - 1)].indices.push_back(static_cast<pcl::index_t>(i));
  }
}

template <typename PointT>
void EPCCSegmentation<PointT>::copyLabels(PointCloudL& labels) const {
  labels.header = input_->header;
  labels.sensor_origin_ = input_->sensor_origin_;
  labels.sensor_orientation_ = input_->sensor_orientation_;
  labels.is_dense = true;
  labels.resize(segmentation_.labels.size());
  labels.width = input_->width;
  labels.height = input_->height;
  for (std::size_t i = 0; i < segmentation_.labels.size(); ++i) {
    const std::int32_t label = segmentation_.labels[i];
    labels.points[i].label = label > 0 ? static_cast<std::uint32_t>(label - 1) : kNoPlane;
  }
}

template <typename PointT>
void EPCCSegmentation<PointT>::copyRegions(PlanarRegions& regions,
                                           std::vector<pcl::PointIndices>* boundary_indices) const {
  const auto contours = traceAllContours(segmentation_.labels, segmentation_.width, segmentation_.height,
                                         static_cast<int>(segmentation_.planes.size()));
  regions.reserve(contours.size());
  for (std::size_t k = 0; k < contours.size(); ++k) {
    const PixelContour outline = contours[k].empty() ? PixelContour() : contours[k].front();
    regions.push_back(buildPlanarRegion(segmentation_.planes[k], outline, *input_, project_points_));
    if (boundary_indices == nullptr) continue;
    pcl::PointIndices boundary;
    boundary.header = input_->header;
    for (const Eigen::Vector2i& pixel : outline.points)
      boundary.indices.push_back(pixel.y() * segmentation_.width + pixel.x());
    boundary_indices->push_back(std::move(boundary));
  }
}

}  // namespace epcc

#define PCL_INSTANTIATE_EPCCSegmentation(T) template class PCL_EXPORTS epcc::EPCCSegmentation<T>;
