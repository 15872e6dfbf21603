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
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/export.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/plane_extractor.h"
#include "epcc_segmentation/plane_segmentation.h"
#include "epcc_segmentation/sensor_model.h"
#include "epcc_segmentation/status.h"

namespace epcc {

/// Former name.
using SegmentationStatus = Status;

/// Segments an organized cloud into planes by evolving principal component clustering.
///
/// Its calls are those of pcl::OrganizedMultiPlaneSegmentation, so that it replaces that class by
/// changing the type; it needs no normals. Clouds of a depth camera (x right, y down, z forward) and
/// of a spinning lidar (x forward, y left, z up; column = azimuth) are distinguished automatically.
///
/// - What an output held is replaced, and every output is empty after bad input: then one PCL_ERROR line tells what
///   is wrong, and getStatus() and getErrorMessage() tell a program. Nothing is thrown.
/// - Points outside setIndices() and points without a finite coordinate or with a depth <= 0 count as
///   not measured, whatever is_dense says. Indices may repeat; with no indices in the vector nothing
///   is measured and there are no planes.
/// - Planes come largest first. Coefficients are (a, b, c, d) of a x + b y + c z + d = 0 in the cloud's frame and unit,
///   unit normal towards the sensor: where that is at the cloud's origin, d >= 0 is the distance from it. Labels are
///   0..K-1 and kNoPlane; indices are ascending.
/// - The object keeps a frame's memory for the next call, whatever is changed in between: it can be moved but not
///   copied, and serves one thread at a time.
/// - The sensor is measured on the clouds unless a model is set; the mode is Mode::InverseDepth unless it is changed.
///   Setters act in that mode; the paper mode's are in paper().
/// - A program may be built with other compiler flags (-mavx, -march=native) than the library.
template <typename PointT>
class EPCC_CORE_EXPORT EPCCSegmentation : public pcl::PCLBase<PointT> {
 public:
  /// Shared pointer, as PCL's classes have it.
  using Ptr = pcl::shared_ptr<EPCCSegmentation<PointT>>;
  /// Shared pointer to a constant object.
  using ConstPtr = pcl::shared_ptr<const EPCCSegmentation<PointT>>;
  /// How a call ended.
  using Status = epcc::Status;
  /// The input.
  using PointCloud = pcl::PointCloud<PointT>;
  /// A label image.
  using PointCloudL = pcl::PointCloud<pcl::Label>;
  /// Shared pointer to a label image.
  using PointCloudLPtr = PointCloudL::Ptr;
  /// Planes with their outlines.
  using PlanarRegions = std::vector<pcl::PlanarRegion<PointT>, Eigen::aligned_allocator<pcl::PlanarRegion<PointT>>>;
  /// (x, y, z, 1) of each plane, in the unit of the cloud.
  using Centroids = std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>>;
  /// Covariance of each plane's points, in the square of the cloud's unit.
  using Covariances = std::vector<Eigen::Matrix3f, Eigen::aligned_allocator<Eigen::Matrix3f>>;

  /// Label of a point that belongs to no plane.
  static constexpr std::uint32_t kNoPlane = std::numeric_limits<std::uint32_t>::max();

  using pcl::PCLBase<PointT>::setIndices;
  /// The points to look at, as in PCL; all others count as not measured. A null pointer means all points.
  void setIndices(const pcl::IndicesConstPtr& indices) override;
  /// The same with PCL's header around the indices.
  void setIndices(const pcl::PointIndices::ConstPtr& indices) override;
  /// The points of a rectangle of nb_rows x nb_cols pixels. Without a cloud it is an error (Status::NoInput), not a
  /// crash.
  void setIndices(std::size_t row_start, std::size_t col_start, std::size_t nb_rows, std::size_t nb_cols) override;

  /// The depth sensor's noise: sigma_z(z) and correlation length. Default: measured on the clouds, see
  /// setSensorModelAuto().
  void setSensorModel(const SensorModel& sensor) { extractor_.setSensor(sensor); }
  /// By name, see SensorModel::presetNames(), or "auto". False, and nothing is changed, for an unknown name.
  bool setSensorModel(const std::string& preset_name);
  /// The model is measured on the clouds and settles over a stream of them; then each measures a quarter of the blocks
  /// (SensorEstimator).
  void setSensorModelAuto() { extractor_.setSensorAuto(); }
  /// The model that was set, or that the last call measured.
  const SensorModel& getSensorModel() const { return extractor_.sensor(); }

  /// Fewest points of a plane, in both modes. [1, 1e9], default 60 (paper mode: 0, its segments decide alone). Raise it
  /// if small pieces of clutter are reported; lower it if small faces are missing.
  void setMinInliers(unsigned points);
  /// What counts in the mode in use.
  unsigned getMinInliers() const;

  /// Gate of a line segment, in standard deviations of the sensor model (InverseDepthParameters::line_k_max). (0, 100],
  /// default 1.5. Raise it if surfaces break into pieces; lower it if shallow creases are run over.
  void setLineKMax(double k_max) {
    parameters_.inverse_depth.line_k_max = k_max;
    inverse_depth_set_ = true;
  }
  /// What setLineKMax() set, standard deviations.
  double getLineKMax() const { return parameters_.inverse_depth.line_k_max; }

  /// Gate of a plane, in standard deviations (InverseDepthParameters::plane_k_max). (0, 100], default 2. Raise it if
  /// planes break along the scan direction; lower it if neighbouring faces join.
  void setPlaneKMax(double k_max) {
    parameters_.inverse_depth.plane_k_max = k_max;
    inverse_depth_set_ = true;
  }
  /// What setPlaneKMax() set, standard deviations.
  double getPlaneKMax() const { return parameters_.inverse_depth.plane_k_max; }

  /// Offset, in standard deviations, within which two large regions are one surface
  /// (InverseDepthParameters::region_tolerance). [0, 100], default 1.5. Raise it if walls stay in pieces
  /// (over-segmentation); lower it if doors and steps join the wall behind them (under-segmentation).
  void setRegionTolerance(double sigmas) {
    parameters_.inverse_depth.region_tolerance = sigmas;
    inverse_depth_set_ = true;
  }
  /// What setRegionTolerance() set, standard deviations.
  double getRegionTolerance() const { return parameters_.inverse_depth.region_tolerance; }

  /// Threads; the result does not depend on them. [1, 256], default 1.
  void setThreads(int threads) { parameters_.threads = threads; }
  /// What setThreads() set.
  int getThreads() const { return parameters_.threads; }

  /// Scan lines along the image's columns or rows (Sec. 7.2), or all that mode and cloud allow (the default). Rows of a
  /// spherical scan are an error.
  void setScanDirection(ScanDirection direction) { parameters_.scan = direction; }
  /// What setScanDirection() set.
  ScanDirection getScanDirection() const { return parameters_.scan; }

  /// Mode::InverseDepth (the default): made for the correlated error of real sensors. Mode::Paper: Algorithms 1 and 2
  /// as published. Each mode has its own settings; switching there and back changes nothing.
  void setMode(Mode mode) { parameters_.mode = mode; }
  /// What setMode() set.
  Mode getMode() const { return parameters_.mode; }

  /// Settings of Mode::Paper: `segmentation.paper().max_gap = 0.2`.
  PaperParameters& paper() { return parameters_.paper; }
  /// The same for reading.
  const PaperParameters& paper() const { return parameters_.paper; }

  /// All parameters of the algorithm at once.
  void setParameters(const Parameters& parameters) { parameters_ = parameters; }
  /// All parameters, as the setters left them.
  const Parameters& getParameters() const { return parameters_; }

  /// How the cloud was measured, if it is in the frame that the projection has. Default, and for std::nullopt: found
  /// out from each cloud (GeometryFinder), whatever its frame is; the cloud's sensor_origin_ and sensor_orientation_
  /// are tried, too. A cloud that neither a camera nor a scanner sees so gives Status::UnknownGeometry.
  void setProjection(std::optional<Projection> projection) { cloud_options_.projection = projection; }
  /// What setProjection() set; nothing: it is found out.
  std::optional<Projection> getProjection() const { return cloud_options_.projection; }
  /// The projection the last call worked with.
  Projection getUsedProjection() const { return geometry_.projection; }
  /// What was found out about the last cloud: the sensor's pose, the unit, ...
  const CloudGeometry& getGeometry() const { return geometry_; }

  /// Only a camera, or only a scanner, is looked for. Default: any.
  void setSensorKind(CloudOptions::Sensor kind) { cloud_options_.sensor = kind; }
  /// What setSensorKind() set.
  CloudOptions::Sensor getSensorKind() const { return cloud_options_.sensor; }

  /// Metres per unit of the coordinates. Default 0: the metre, or the millimetre where metres are impossible, as
  /// PCL_WARN then says once. Models, centroids, covariances and regions are in units of the cloud, getSegmentation()
  /// in metres.
  void setUnit(double metres) { cloud_options_.unit = metres; }
  /// What setUnit() set, metres; 0: it is found out.
  double getUnit() const { return cloud_options_.unit; }

  /// Points nearer or farther are invalid: depth of a camera, range of a scanner, metres. Default: all are valid.
  void setDepthRange(double nearest, double farthest) {
    cloud_options_.min_depth = nearest;
    cloud_options_.max_depth = farthest;
  }
  /// The nearest valid depth, metres.
  double getMinDepth() const { return cloud_options_.min_depth; }
  /// The farthest valid depth, metres.
  double getMaxDepth() const { return cloud_options_.max_depth; }

  /// Points all of whose coordinates are this are invalid, too. Points that many pixels have in common need not be
  /// named.
  void setInvalidValue(std::optional<float> value) { cloud_options_.invalid = value; }
  /// What setInvalidValue() set.
  std::optional<float> getInvalidValue() const { return cloud_options_.invalid; }

  /// True moves the contour points of planar regions orthogonally onto their plane (Eq. 28). Default false:
  /// they stay where they were measured.
  void setProjectPoints(bool project) { project_points_ = project; }
  /// What setProjectPoints() set.
  bool getProjectPoints() const { return project_points_; }

  /// \name Without effect
  /// Accepted so that programs for pcl::OrganizedMultiPlaneSegmentation compile, as the first call of each says with
  /// PCL_WARN. The sensor model takes the place of these thresholds, and there are no normals and no comparators.
  /// \{

  /// Kept for getAngularThreshold() alone, radians.
  void setAngularThreshold(double radians) {
    warnWithoutEffect(0, "setAngularThreshold", "the sensor model takes its place");
    angular_threshold_ = radians;
  }
  /// What setAngularThreshold() set, radians; default 3 degrees.
  double getAngularThreshold() const { return angular_threshold_; }
  /// Kept for getDistanceThreshold() alone, metres.
  void setDistanceThreshold(double metres) {
    warnWithoutEffect(1, "setDistanceThreshold", "the sensor model takes its place");
    distance_threshold_ = metres;
  }
  /// What setDistanceThreshold() set, metres; default 0.02.
  double getDistanceThreshold() const { return distance_threshold_; }
  /// Kept for getMaximumCurvature() alone.
  void setMaximumCurvature(double curvature) {
    warnWithoutEffect(2, "setMaximumCurvature", "the sensor model takes its place");
    maximum_curvature_ = curvature;
  }
  /// What setMaximumCurvature() set; default 0.001.
  double getMaximumCurvature() const { return maximum_curvature_; }
  /// A pointer to any normal cloud, null too; it is not kept.
  template <typename NormalCloud>
  void setInputNormals(const pcl::shared_ptr<NormalCloud>&) {
    warnWithoutEffect(3, "setInputNormals", "no normals are used");
  }
  /// Any comparator; it is not kept.
  template <typename Comparator>
  void setComparator(const pcl::shared_ptr<Comparator>&) {
    warnWithoutEffect(4, "setComparator", "there are no comparators");
  }
  /// Any comparator; it is not kept.
  template <typename Comparator>
  void setRefinementComparator(const pcl::shared_ptr<Comparator>&) {
    warnWithoutEffect(5, "setRefinementComparator", "there are no comparators");
  }
  /// Leaves its arguments as they are: planes are complete after segment().
  void refine(std::vector<pcl::ModelCoefficients>&, std::vector<pcl::PointIndices>&, PointCloudLPtr&,
              std::vector<pcl::PointIndices>&) {
    warnWithoutEffect(6, "refine", "planes are complete after segment()");
  }
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

  /// How the last call ended; Status::NoInput before the first.
  Status getStatus() const noexcept { return status_; }
  /// What was wrong, in words; empty if nothing was.
  const std::string& getErrorMessage() const noexcept { return error_; }

  /// Labels and planes of the last call in the core's types, in double and with covariances.
  const PlaneSegmentation& getSegmentation() const noexcept { return segmentation_; }

 protected:
  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;
  using pcl::PCLBase<PointT>::fake_indices_;
  using pcl::PCLBase<PointT>::initCompute;
  using pcl::PCLBase<PointT>::deinitCompute;

  /// The name in messages.
  virtual std::string getClassName() const { return "EPCCSegmentation"; }

 private:
  /// Says once for each of the calls, numbered from 0, that it does nothing.
  void warnWithoutEffect(unsigned call, const char* name, const char* why);

  /// Fills the outputs by the action, which replaces what they held and keeps their memory; they are cleared if it
  /// fails, and it is reported if memory runs out.
  template <typename Clear, typename Action>
  void attempt(const char* method, const Clear& clear, const Action& action) {
    bool done = false;
    try {
      done = action();
    } catch (const std::bad_alloc&) {
      report(method, Status::OutOfMemory, "out of memory");  // short enough to need none
    }
    if (!done) clear();
  }
  /// Checks the input and segments it into segmentation_; on bad input reports it as found by `method`.
  bool compute(const char* method);
  Status checkInput(std::string& what) const;
  bool report(const char* method, Status status, const std::string& what);

  /// How the cloud was measured; says so where the unit is a guess.
  void findGeometry();
  /// In units of the cloud.
  Plane inCloudUnits(const Plane& plane) const;

  /// The points given by setIndices() as a mask, or nullptr if it was not called.
  const std::uint8_t* updateMask();

  void copyModels(std::vector<pcl::ModelCoefficients>& model_coefficients) const;
  void copyInliers(std::vector<pcl::PointIndices>& inlier_indices) const;
  void copyLabels(PointCloudL& labels) const;
  void copyRegions(PlanarRegions& regions, std::vector<pcl::PointIndices>* boundary_indices) const;

  Parameters parameters_;
  PlaneExtractor extractor_;  // with the sensor model
  CloudOptions cloud_options_;
  GeometryFinder finder_;
  bool project_points_ = false;
  double angular_threshold_ = 0.05235987755982989;  // 3 degrees, PCL's default, like those below
  double distance_threshold_ = 0.02;
  double maximum_curvature_ = 0.001;
  bool inverse_depth_set_ = false;  // by a setter that the paper mode does not read
  bool unit_warned_ = false;
  unsigned warned_ = 0;  // a bit for each call without effect

  std::vector<std::uint8_t> mask_;
  PlaneSegmentation segmentation_;
  CloudGeometry geometry_;
  Status status_ = Status::NoInput;
  std::string error_;
};

}  // namespace epcc

#include "epcc_segmentation/pcl/impl/aligned_output.hpp"

#ifdef PCL_NO_PRECOMPILE
#include "epcc_segmentation/pcl/impl/epcc_segmentation.hpp"
#endif
