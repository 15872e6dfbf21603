// SPDX-License-Identifier: BSD-3-Clause
// Moments of the labelled pixels, planes with their covariance, labels in order of size.
#include "epcc_segmentation/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "metric/recursive_statistics.h"

namespace epcc {

namespace {

/// Weighted sums of points.
struct PointSums {
  double one = 0.0, x = 0.0, y = 0.0, z = 0.0;
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  void add(double px, double py, double pz, double weight) {
    const double wx = weight * px;
    const double wy = weight * py;
    const double wz = weight * pz;
    one += weight;
    x += wx;
    y += wy;
    z += wz;
    xx += wx * px;
    xy += wx * py;
    xz += wx * pz;
    yy += wy * py;
    yz += wy * pz;
    zz += wz * pz;
  }
  Eigen::Vector3d first() const { return {x, y, z}; }
  Eigen::Matrix3d second() const {
    Eigen::Matrix3d m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }
};

/// Sums over a plane's points about its first point, where double precision loses nothing.
struct PointMoments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  PointSums plain;
  PointSums weighted;

  void add(const Eigen::Vector3d& p, double weight) {
    if (plain.one == 0.0) origin = p;
    const Eigen::Vector3d r = p - origin;
    plain.add(r.x(), r.y(), r.z(), 1.0);
    weighted.add(r.x(), r.y(), r.z(), weight);
  }
};

/// Sums along a run of an image row. Its rays share v = y/z, so that y - y0 = v (z - z0) + c there, and the sums with y
/// follow from the others.
struct RowSums {
  double one = 0.0, x = 0.0, z = 0.0, xx = 0.0, xz = 0.0, zz = 0.0;

  void add(double px, double pz, double weight) {
    const double wx = weight * px;
    const double wz = weight * pz;
    one += weight;
    x += wx;
    z += wz;
    xx += wx * px;
    xz += wx * pz;
    zz += wz * pz;
  }
  void addTo(PointSums& sums, double v, double c) const {
    sums.one += one;
    sums.x += x;
    sums.y += v * z + c * one;
    sums.z += z;
    sums.xx += xx;
    sums.xy += v * xz + c * x;
    sums.xz += xz;
    sums.yy += v * (v * zz + 2.0 * c * z) + c * c * one;
    sums.yz += v * zz + c * z;
    sums.zz += zz;
  }
};

/// Covariance of (normal, d) of the weighted orthogonal fit through `centre`: the normal tilts about the two
/// in-plane axes, the offset moves along it. `unit_variance` is the residual variance of a point of unit weight.
Eigen::Matrix4d coefficientsCovariance(const Eigen::Matrix3d& axes, const Eigen::Vector3d& scatter, double weight,
                                       const Eigen::Vector3d& centre, double unit_variance) {
  Eigen::Matrix3d normal_covariance = Eigen::Matrix3d::Zero();
  for (int k = 1; k < 3; ++k)
    if (scatter(k) > 0.0) normal_covariance += (unit_variance / scatter(k)) * axes.col(k) * axes.col(k).transpose();
  Eigen::Matrix4d covariance;
  covariance.topLeftCorner<3, 3>() = normal_covariance;
  covariance.topRightCorner<3, 1>() = -normal_covariance * centre;
  covariance.bottomLeftCorner<1, 3>() = covariance.topRightCorner<3, 1>().transpose();
  covariance(3, 3) = centre.dot(normal_covariance * centre) + unit_variance / weight;
  return covariance;
}

Plane planeOf(const PointMoments& moments, const SensorModel& sensor) {
  Plane plane;
  const double n = moments.plain.one;
  const double weight = moments.weighted.one;
  const Eigen::Vector3d mean = moments.plain.first() / n;
  plane.pixel_count = static_cast<std::size_t>(n);
  plane.centroid = moments.origin + mean;
  plane.points_covariance = moments.plain.second() / n - mean * mean.transpose();

  const Eigen::Vector3d weighted_mean = moments.weighted.first() / weight;
  const Eigen::Matrix3d scatter = moments.weighted.second() - weight * weighted_mean * weighted_mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const Eigen::Vector3d centre = moments.origin + weighted_mean;
  if (normal.dot(centre) > 0.0) normal = -normal;  // towards the sensor
  plane.coefficients << normal, -normal.dot(centre);

  const double mean_distance = plane.signedDistance(plane.centroid);
  const double spread = varianceAlong(plane.points_covariance, normal);
  plane.rms = std::sqrt(spread + mean_distance * mean_distance);
  // Neighbouring errors are alike: N pixels are worth N / pixelsPerSample independent ones.
  const double residual = std::max(0.0, solver.eigenvalues()(0)) / std::max(1.0, n - 3.0);
  plane.coefficients_covariance = coefficientsCovariance(solver.eigenvectors(), solver.eigenvalues(), weight, centre,
                                                         residual * sensor.pixelsPerSample());
  return plane;
}

/// Calls visit(moments, row, first column, end) for every run of one of the labels 1..plane_count along a row.
template <typename Visit>
std::vector<PointMoments> forEachRun(const DepthFrame& frame, int plane_count, const std::vector<std::int32_t>& labels,
                                     const Visit& visit) {
  std::vector<PointMoments> moments(static_cast<std::size_t>(plane_count));
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0, end = 0; column < frame.width(); column = end) {
      const std::int32_t label = labels[frame.index(row, column)];
      for (end = column + 1; end < frame.width() && labels[frame.index(row, end)] == label;) ++end;
      if (label > 0 && label <= plane_count) visit(moments[static_cast<std::size_t>(label - 1)], row, column, end);
    }
  return moments;
}

std::vector<PointMoments> momentsOfPoints(const DepthFrame& frame, const SensorModel& sensor, int plane_count,
                                          const std::vector<std::int32_t>& labels) {
  const bool perspective = isPerspective(frame.projection());
  return forEachRun(frame, plane_count, labels, [&](PointMoments& moments, int row, int begin, int end) {
    Eigen::Vector3d p;
    PointMoments run = moments;  // summed in registers
    for (int column = begin; column < end; ++column)
      if (frame.point(row, column, p)) run.add(p, 1.0 / sensor.varianceZ(perspective ? std::abs(p.z()) : p.norm()));
    moments = run;
  });
}

/// The same of a depth image, with fewer operations.
std::vector<PointMoments> momentsOfDepths(const DepthFrame& frame, const SensorModel& sensor, int plane_count,
                                          const std::vector<std::int32_t>& labels) {
  std::vector<double> across;
  for (int column = 0; column < frame.width(); ++column) across.push_back(frame.pinholeAcross(column));
  std::vector<float> depth(static_cast<std::size_t>(frame.width()));
  std::vector<double> weight(depth.size());
  const SensorModel own = sensor;  // a local copy cannot alias the weights
  int depth_row = -1;
  return forEachRun(frame, plane_count, labels, [&](PointMoments& moments, int row, int begin, int end) {
    if (row != depth_row) {
      frame.depthRow(row, depth.data());
      for (std::size_t i = 0; i < depth.size(); ++i) weight[i] = 1.0 / own.varianceZ(static_cast<double>(depth[i]));
      depth_row = row;
    }
    auto column = static_cast<std::size_t>(begin);
    while (column < static_cast<std::size_t>(end) && !(depth[column] > 0.0f)) ++column;
    if (column == static_cast<std::size_t>(end)) return;
    const double v = frame.pinholeAlong(row);
    const auto first = static_cast<double>(depth[column]);
    if (moments.plain.one == 0.0) moments.origin = first * Eigen::Vector3d(across[column], v, 1.0);
    const Eigen::Vector3d origin = moments.origin;
    RowSums plain, weighted;
    for (; column < static_cast<std::size_t>(end); ++column) {
      const auto z = static_cast<double>(depth[column]);
      if (!(z > 0.0)) continue;
      const double px = z * across[column] - origin.x();
      const double pz = z - origin.z();
      plain.add(px, pz, 1.0);
      weighted.add(px, pz, weight[column]);
    }
    const double c = v * origin.z() - origin.y();
    plain.addTo(moments.plain, v, c);
    weighted.addTo(moments.weighted, v, c);
  });
}

}  // namespace

bool fitPlanes(const DepthFrame& frame, const SensorModel& sensor, int plane_count, PlaneSegmentation& segmentation) {
  segmentation.planes.clear();
  const auto pixels = static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height());
  if (plane_count < 0 || segmentation.labels.size() != pixels) return false;
  const auto momentsOf = frame.isPinhole() && !frame.isTransposed() ? momentsOfDepths : momentsOfPoints;
  const std::vector<PointMoments> moments = momentsOf(frame, sensor, plane_count, segmentation.labels);
  std::vector<std::size_t> order(moments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return moments[i].plain.one > moments[j].plain.one; });
  std::vector<std::int32_t> new_label(moments.size() + 1, 0);
  for (const std::size_t i : order) {
    if (moments[i].plain.one == 0.0) break;
    segmentation.planes.push_back(planeOf(moments[i], sensor));
    new_label[i + 1] = static_cast<std::int32_t>(segmentation.planes.size());
  }
  for (auto& label : segmentation.labels)
    label = label > 0 && label <= plane_count ? new_label[static_cast<std::size_t>(label)] : 0;
  return true;
}

}  // namespace epcc
