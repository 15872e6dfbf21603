// SPDX-License-Identifier: BSD-3-Clause
// The PCL class: organized cloud in, planes out in PCL's types.
#pragma once

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/memory.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/planar_region.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_estimation.h"
#include "epcc_segmentation/sensor_model.h"

namespace epcc {

/// How a segmentation ended.
enum class SegmentationStatus {
  Ok,                 ///< Done; there may be no planes.
  NoInput,            ///< setInputCloud() was not called, or with a null pointer.
  EmptyCloud,         ///< The cloud has no points.
  SizeMismatch,       ///< The cloud's points are not width * height, or are more than an index can name.
  Unorganized,        ///< The cloud has one row.
  InvalidIndices,     ///< An index is negative or beyond the cloud.
  InvalidParameters,  ///< A parameter or the sensor model is out of its range.
  UnsupportedScan,    ///< Row scan of a spherical scan, whose rows are cones.
  Failed              ///< Refused by the extractor for another reason.
};

/// Segments an organized cloud into planes by evolving principal component clustering.
///
/// Its calls are those of pcl::OrganizedMultiPlaneSegmentation, so that it replaces that class by
/// changing the type; it needs no normals. Clouds of a depth camera (x right, y down, z forward) and
/// of a spinning lidar (x forward, y left, z up; column = azimuth) are told apart by themselves.
///
/// - Every output is cleared first, and is empty after bad input: then one PCL_ERROR line tells what
///   is wrong, and getStatus() and getErrorMessage() tell a program. Nothing is thrown.
/// - Points outside setIndices() and points without a finite coordinate or with a depth <= 0 count as
///   not measured, whatever is_dense says. Indices may repeat; with no indices in the vector nothing
///   is measured and there are no planes.
/// - Planes come largest first. Coefficients are (a, b, c, d) of a x + b y + c z + d = 0 in metres,
///   unit normal towards the sensor (d >= 0). Labels are 0..K-1 and kNoPlane; indices are ascending.
/// - The object keeps a frame's memory for the next call: it can be moved but not copied, and serves
///   one thread at a time.
template <typename PointT>
class EPCCSegmentation : public pcl::PCLBase<PointT> {
 public:
  using Ptr = pcl::shared_ptr<EPCCSegmentation<PointT>>;
  using ConstPtr = pcl::shared_ptr<const EPCCSegmentation<PointT>>;
  using Status = SegmentationStatus;
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudL = pcl::PointCloud<pcl::Label>;
  using PointCloudLPtr = PointCloudL::Ptr;
  using PlanarRegions = std::vector<pcl::PlanarRegion<PointT>, Eigen::aligned_allocator<pcl::PlanarRegion<PointT>>>;
  using Centroids = std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>>;
  using Covariances = std::vector<Eigen::Matrix3f, Eigen::aligned_allocator<Eigen::Matrix3f>>;

  /// Label of a point that belongs to no plane.
  static constexpr std::uint32_t kNoPlane = std::numeric_limits<std::uint32_t>::max();

  /// As in PCL, but a null pointer means all points, and a rectangle without a cloud is an error, not a crash.
  using pcl::PCLBase<PointT>::setIndices;
  void setIndices(const pcl::IndicesConstPtr& indices) override;
  void setIndices(const pcl::PointIndices::ConstPtr& indices) override;
  void setIndices(std::size_t row_start, std::size_t col_start, std::size_t nb_rows, std::size_t nb_cols) override;

  /// Mode::Paper: Algorithms 1 and 2 as published. Mode::Default: inverse depth, made for the correlated error of
  /// real sensors (the default). Paper mode scans columns where both directions were asked for before. Where a setter
  /// says so, it matters in one mode only.
  void setMode(Mode mode) {
    change(parameters_.mode, mode);
    if (mode == Mode::Paper && parameters_.scan == ScanDirection::Both)
      change(parameters_.scan, ScanDirection::Columns);
  }
  Mode getMode() const { return parameters_.mode; }

  /// Scan lines along the image's columns or rows (Sec. 7.2), or both (Mode::Default only, and its default). A
  /// spherical scan has only columns: rows are an error, both means columns.
  void setScanDirection(ScanDirection direction) { change(parameters_.scan, direction); }
  ScanDirection getScanDirection() const { return parameters_.scan; }

  /// k_max of Eq. 20, standard deviations: how far a point may lie from its line segment. (0, 100], default 2.
  /// Paper mode; the default mode's are in setParameters().
  void setLineKMax(double k_max) { change(parameters_.line.k_max, k_max); }
  double getLineKMax() const { return parameters_.line.k_max; }

  /// k_max of Eq. 23, standard deviations: how far a segment may lie from its plane. (0, 100], default 3.
  /// Paper mode; the default mode's are in setParameters().
  void setPlaneKMax(double k_max) { change(parameters_.plane.k_max, k_max); }
  double getPlaneKMax() const { return parameters_.plane.k_max; }

  /// d_1 of Eq. 27, metres: gap between neighbouring segments of a plane. [0, 100], default 0.15. Paper mode.
  void setMaxGap(double metres) { change(parameters_.plane.max_gap, metres); }
  double getMaxGap() const { return parameters_.plane.max_gap; }

  /// Fewest points of a plane, in both modes. [0, 1e9]; initially 0 in paper mode, where setMinSegments() then
  /// decides alone, and 150 in the default mode.
  void setMinInliers(unsigned points);
  unsigned getMinInliers() const;

  /// Fewest line segments of a plane (15 are the 30 endpoints of Sec. 7.1). [1, 1e6], default 15. Paper mode.
  void setMinSegments(int segments) { change(parameters_.plane.min_segments, segments); }
  int getMinSegments() const { return parameters_.plane.min_segments; }

  /// Variances of the acceptance criterion of Algorithm 2 (Table 2). Default (a), all of them. Paper mode.
  void setPlaneCriterion(PlaneCriterion criterion) { change(parameters_.plane.criterion, criterion); }
  PlaneCriterion getPlaneCriterion() const { return parameters_.plane.criterion; }

  /// The depth sensor's noise: sigma_z(z) and correlation length. Default: measured on the clouds, see
  /// setSensorModelAuto().
  void setSensorModel(const SensorModel& sensor) {
    estimator_.reset();
    change(sensor_, sensor);
  }
  /// By name, see SensorModel::presetNames(), or "auto". False, and nothing is changed, for an unknown name.
  bool setSensorModel(const std::string& preset_name);
  /// The model is measured on the clouds and settles over a stream of them; then every fourth is measured
  /// (SensorEstimator).
  void setSensorModelAuto();
  /// The model that was set, or that the last call measured.
  const SensorModel& getSensorModel() const { return sensor_; }

  /// Threads for the scan lines; the result does not depend on it. [1, 256], default 1.
  void setThreads(int threads) { change(parameters_.threads, threads); }
  int getThreads() const { return parameters_.threads; }

  /// How the cloud was measured. Default, and for std::nullopt: found out from each cloud (detectProjection()).
  void setProjection(std::optional<Projection> projection) { projection_ = projection; }
  std::optional<Projection> getProjection() const { return projection_; }
  /// The projection the last call worked with.
  Projection getUsedProjection() const { return used_projection_; }

  /// All parameters of the algorithm at once.
  void setParameters(const Parameters& parameters) { change(parameters_, parameters); }
  const Parameters& getParameters() const { return parameters_; }

  /// True moves the contour points of planar regions orthogonally onto their plane (Eq. 28). Default false:
  /// they stay where they were measured.
  void setProjectPoints(bool project) { project_points_ = project; }
  bool getProjectPoints() const { return project_points_; }

  /// Radians: largest angle between the two segments that start a plane (Algorithm 2). (0, pi/2], default 20 degrees.
  /// Paper mode. Not the angle between neighbouring normals, which EPCC does not use.
  void setAngularThreshold(double radians) { change(parameters_.plane.max_start_angle, radians * (180.0 / M_PI)); }
  double getAngularThreshold() const { return parameters_.plane.max_start_angle * (M_PI / 180.0); }

  /// \name Accepted so that programs for pcl::OrganizedMultiPlaneSegmentation compile; without effect.
  /// The sensor model takes the place of these thresholds, and there are no normals and no comparators.
  /// \{
  void setDistanceThreshold(double metres) { distance_threshold_ = metres; }
  double getDistanceThreshold() const { return distance_threshold_; }
  void setMaximumCurvature(double curvature) { maximum_curvature_ = curvature; }
  double getMaximumCurvature() const { return maximum_curvature_; }
  /// A pointer to any normal cloud, null too; it is not kept.
  template <typename NormalCloud>
  void setInputNormals(const pcl::shared_ptr<NormalCloud>&) {}
  template <typename Comparator>
  void setComparator(const pcl::shared_ptr<Comparator>&) {}
  template <typename Comparator>
  void setRefinementComparator(const pcl::shared_ptr<Comparator>&) {}
  /// Leaves its arguments as they are: planes are complete after segment().
  void refine(std::vector<pcl::ModelCoefficients>&, std::vector<pcl::PointIndices>&, PointCloudLPtr&,
              std::vector<pcl::PointIndices>&) {}
  /// \}

  /// Finds the planes: coefficients and points of each.
  void segment(std::vector<pcl::ModelCoefficients>& model_coefficients, std::vector<pcl::PointIndices>& inlier_indices);

  /// Also the points' centroid (x, y, z, 1), their covariance (normalised by N), the label image, and the
  /// indices of each label, which are the inliers.
  void segment(std::vector<pcl::ModelCoefficients>& model_coefficients, std::vector<pcl::PointIndices>& inlier_indices,
               Centroids& centroids, Covariances& covariances, PointCloudL& labels,
               std::vector<pcl::PointIndices>& label_indices);

  /// Planes with their outline: the outer border of the largest piece (contours.h), a closed walk.
  void segment(PlanarRegions& regions);

  /// The same as segment(regions): EPCC has no separate refinement.
  void segmentAndRefine(PlanarRegions& regions);

  /// Everything; boundary_indices are the points of the regions' contours in the order of the walk.
  /// `labels` may be null and then becomes a new cloud.
  void segmentAndRefine(PlanarRegions& regions, std::vector<pcl::ModelCoefficients>& model_coefficients,
                        std::vector<pcl::PointIndices>& inlier_indices, PointCloudLPtr& labels,
                        std::vector<pcl::PointIndices>& label_indices,
                        std::vector<pcl::PointIndices>& boundary_indices);

  /// The points of each plane, the call of PCL's clustering classes.
  void extract(std::vector<pcl::PointIndices>& clusters);

  /// How the last call ended, and what was wrong in words (empty if nothing).
  Status getStatus() const { return status_; }
  const std::string& getErrorMessage() const { return error_; }

  /// Labels and planes of the last call in the core's types, in double and with covariances.
  const PlaneSegmentation& getSegmentation() const { return segmentation_; }

 protected:
  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;
  using pcl::PCLBase<PointT>::fake_indices_;
  using pcl::PCLBase<PointT>::initCompute;
  using pcl::PCLBase<PointT>::deinitCompute;

  virtual std::string getClassName() const { return "EPCCSegmentation"; }

 private:
  template <typename Value>
  void change(Value& member, const Value& value) {
    member = value;
    extractor_.reset();
  }

  /// Checks the input and segments it into segmentation_; on bad input reports it as found by `method`.
  bool compute(const char* method);
  Status checkInput(std::string& what) const;
  Status checkSettings(std::string& what);
  bool report(const char* method, Status status, const std::string& what);

  /// The points given by setIndices() as a mask, or nullptr if it was not called.
  const std::uint8_t* updateMask();

  void copyModels(std::vector<pcl::ModelCoefficients>& model_coefficients) const;
  void copyInliers(std::vector<pcl::PointIndices>& inlier_indices) const;
  void copyLabels(PointCloudL& labels) const;
  void copyRegions(PlanarRegions& regions, std::vector<pcl::PointIndices>* boundary_indices) const;

  Parameters parameters_;
  SensorModel sensor_;
  std::optional<SensorEstimator> estimator_ = SensorEstimator();  // absent if the model was set
  std::optional<Projection> projection_;
  bool project_points_ = false;
  double distance_threshold_ = 0.02;
  double maximum_curvature_ = 0.001;

  std::optional<PlaneExtractor> extractor_;  // absent after a change of the parameters
  std::vector<std::uint8_t> mask_;
  PlaneSegmentation segmentation_;
  Projection used_projection_ = Projection::Perspective;
  Status status_ = Status::NoInput;
  std::string error_;
};

}  // namespace epcc

#ifdef PCL_NO_PRECOMPILE
#include "epcc_segmentation/pcl/impl/epcc_segmentation.hpp"
#endif
