// SPDX-License-Identifier: BSD-3-Clause
// Expect, segment, find again, join, judge.
#include "over_time/tracker_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "inverse_depth/relabelling.h"
#include "over_time/plane_motion.h"
#include "quantile.h"
#include "symmetric_part.h"

namespace epcc {

namespace {

constexpr long kFramesToWait = 4;          // until little that is new is segmented
constexpr int kPlacesAcross = 40;          // along the longer side of a frame: those that are remembered
constexpr double kShareOfKeyframe = 0.7;   // of what is known
constexpr double kHardToBelieve = 5.0;     // sigma of the motion
constexpr double kClearlyMore = 1.2;       // of what is explained
constexpr double kSeenFromAside = 0.01;    // metres: nearer planes are seen from the side, or from behind
constexpr double kMedianOfSquares = 2.37;  // of a chi^2 of three parameters
constexpr double kScaleGain = 0.1, kLargestRatio = 3.0;
constexpr std::size_t kFewestSquares = 3;

Eigen::Matrix<double, 6, 6> poseCovariance(double angle, double offset) {
  Eigen::Matrix<double, 6, 6> c = Eigen::Matrix<double, 6, 6>::Zero();
  c.diagonal() << angle * angle, angle * angle, angle * angle, offset * offset, offset * offset, offset * offset;
  return c;
}

/// Of the samples that are measured, on whatever grid.
double explainedShare(const Continuation& continuation) {
  return static_cast<double>(continuation.from_views) /
         static_cast<double>(std::max<std::size_t>(1, continuation.samples));
}

}  // namespace

UncertainPose PlaneTracker::State::expectedPose(const std::optional<Eigen::Isometry3d>& given) const {
  UncertainPose expected;
  if (given) {
    expected.camera_to_map = *given;
    expected.covariance = poseCovariance(tracker.pose_angle_sigma, tracker.pose_offset_sigma);
  } else {  // it goes on as it did
    expected.camera_to_map = pose * motion;
    expected.covariance = poseCovariance(tracker.motion_angle_sigma, tracker.motion_offset_sigma);
  }
  return expected;
}

// The tracks of earlier frames, as they are expected in this one.
void PlaneTracker::State::expect(const std::optional<Eigen::Isometry3d>& given) {
  known.pose = expectedPose(given);
  known.planes.clear();
  known.confidence.clear();
  known.views.clear();
  known_tracks.clear();
  known.error_scale = error_scale;
  known.may_wait = frame - last_look < kFramesToWait;
  known.search = frame < tracker.confirm_frames || frame - last_search >= tracker.search_frames;
  number_of_track.assign(tracks.all().size(), 0);
  for (const Keyframe* view : {&keyframe, &last})
    if (view->labels != nullptr) known.views.push_back(knownView(*view));
}

KnownView PlaneTracker::State::knownView(const Keyframe& view) {
  KnownView result;
  result.labels = view.labels;
  result.width = view.width;
  result.height = view.height;
  result.camera_to_map = view.pose;
  result.plane_of_label.assign(view.track_of_plane.size() + 2, 0);
  result.plane_of_label.back() = kNotLookedAt;
  const Eigen::Isometry3d camera(known.pose.camera_to_map);
  for (std::size_t k = 0; k < view.track_of_plane.size(); ++k) {
    const int track = tracks.alive(view.track_of_plane[k]);
    if (track < 0) continue;
    std::int32_t& number = number_of_track[static_cast<std::size_t>(track)];
    const MapPlane& plane = tracks.at(track).plane;
    if (number == 0) {
      if (planeSeenFrom(camera, plane.coefficients)(3) < kSeenFromAside) continue;
      known.planes.push_back(plane);
      known.confidence.push_back(tracks.at(track).confidence);
      known_tracks.push_back(track);
      number = static_cast<std::int32_t>(known.planes.size());
    }
    result.plane_of_label[k + 1] = number;
  }
  return result;
}

bool PlaneTracker::State::segment(const DepthFrame& depth, const std::optional<Isometry3>& given,
                                  TrackedFrame& result) {
  std::optional<Eigen::Isometry3d> in_map;
  if (given) in_map = map_of_given * Eigen::Isometry3d(*given);
  expect(in_map);
  result.pose_jumped = false;
  if (!extractor.extract(depth, known, result.segmentation, continuation)) return false;
  if (!in_map || !isHardToBelieve(*in_map) || !goesOnInstead(depth, result.segmentation)) return true;
  result.pose_jumped = true;
  map_of_given = Eigen::Isometry3d(continuation.pose.camera_to_map) * Eigen::Isometry3d(*given).inverse();
  return true;
}

/// A camera that goes on as it did would be elsewhere.
bool PlaneTracker::State::isHardToBelieve(const Eigen::Isometry3d& given) const {
  if (!has_pose || known.views.empty()) return false;
  const Eigen::Isometry3d beyond = (pose * motion).inverse() * given;
  return beyond.translation().norm() > kHardToBelieve * tracker.motion_offset_sigma ||
         Eigen::AngleAxisd(beyond.linear()).angle() > kHardToBelieve * tracker.motion_angle_sigma;
}

/// Whether known planes explain clearly more of the frame from where the camera would be by its motion: then that is
/// what became of it.
bool PlaneTracker::State::goesOnInstead(const DepthFrame& depth, PlaneSegmentation& segmentation) {
  Continuation other;
  const UncertainPose as_given = known.pose;
  known.pose = expectedPose(std::nullopt);
  const bool done = extractor.extract(depth, known, by_motion, other);
  if (!done || explainedShare(other) <= kClearlyMore * explainedShare(continuation)) {
    known.pose = as_given;
    return false;
  }
  continuation = other;
  std::swap(segmentation, by_motion);
  return true;
}

void PlaneTracker::State::takePose(TrackedFrame& result) {
  Eigen::Isometry3d now(continuation.pose.camera_to_map);
  now.linear() = Eigen::Quaterniond(now.linear()).normalized().toRotationMatrix();  // or errors grow frame by frame
  result.pose = continuation.pose;
  result.pose.camera_to_map = now;
  result.pose_information = continuation.pose_information;
  if (has_pose) motion = pose.inverse() * now;
  pose = now;
  has_pose = true;
}

// The typical error of a plane from what was expected says how right the covariances of frames are.
void PlaneTracker::State::learnErrorScale(TrackedFrame& result) {
  result.squared_error.clear();
  for (const double square : continuation.squared_error)
    if (square >= 0.0) result.squared_error.push_back(square);
  if (result.squared_error.size() < kFewestSquares) return;
  std::vector<double> squares = result.squared_error;
  const double ratio = std::min(median(squares) / kMedianOfSquares, kLargestRatio);
  error_scale = std::max(1.0, error_scale * (1.0 + kScaleGain * (ratio - 1.0)));
}

/// What the poses of two frames may move a plane by.
Eigen::Matrix4d PlaneTracker::State::poseError(const MapPlane& plane) const {
  const Eigen::Matrix<double, 4, 6> by_pose =
      pose.matrix().inverse().transpose() * planeByMotion(planeSeenFrom(pose, plane.coefficients));
  return 2.0 * by_pose * Eigen::Matrix<double, 6, 6>(known.pose.covariance) * by_pose.transpose();
}

std::vector<SeenInMap> PlaneTracker::State::seenPlanes(const DepthFrame& depth, const TrackedFrame& result) const {
  const PlaneSegmentation& segmentation = result.segmentation;
  const Eigen::Matrix4d to_map = pose.matrix().inverse().transpose();
  std::vector<SeenInMap> seen(segmentation.planes.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const Plane& plane = segmentation.planes[k];
    const Eigen::Matrix<double, 4, 6> by_pose = planeByMotion(plane.coefficients);
    const Eigen::Matrix4d covariance =
        error_scale * Eigen::Matrix4d(plane.coefficients_covariance) +
        by_pose * Eigen::Matrix<double, 6, 6>(result.pose.covariance) * by_pose.transpose();
    seen[k].plane.coefficients = to_map * Eigen::Vector4d(plane.coefficients);
    seen[k].plane.covariance = symmetricPart(to_map * covariance * to_map.transpose());
    seen[k].again = seen[k].plane;
    seen[k].again.covariance += poseError(seen[k].plane);
    seen[k].centroid = pose * Eigen::Vector3d(plane.centroid);
    seen[k].confidence = plane.confidence;
    seen[k].pixels = static_cast<double>(plane.pixel_count);
  }
  const int step = std::max(1, std::max(depth.width(), depth.height()) / kPlacesAcross);
  for (int row = step / 2; row < depth.height(); row += step)
    for (int column = step / 2; column < depth.width(); column += step) {
      const std::int32_t label = segmentation.labels[depth.index(row, column)];
      Eigen::Vector3d point;
      if (label > 0 && depth.point(row, column, point))
        seen[static_cast<std::size_t>(label) - 1].places.push_back(pose * point);
    }
  for (SeenInMap& plane : seen)
    if (plane.places.empty()) plane.places.push_back(plane.centroid);
  return seen;
}

void PlaneTracker::State::assign(const std::vector<SeenInMap>& seen, double time) {
  const FrameTime now{frame, time};
  track_of_plane.assign(seen.size(), -1);
  const bool nothing_continues = continuation.samples == 0;  // clouds in other frames, and the paper mode
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (continuation.continues[k] >= 0)
      track_of_plane[k] = known_tracks[static_cast<std::size_t>(continuation.continues[k])];
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (track_of_plane[k] >= 0) continue;
    track_of_plane[k] = tracks.find(seen[k], nothing_continues);
    if (track_of_plane[k] < 0) track_of_plane[k] = tracks.birth(seen[k], pose.translation(), now);
  }
  for (std::size_t k = 0; k < seen.size(); ++k) tracks.see(track_of_plane[k], seen[k], now);
}

void PlaneTracker::State::judge() {
  const auto vote = [this](const std::pair<std::int32_t, std::int32_t>& pair, bool is_one) {
    tracks.vote(known_tracks[static_cast<std::size_t>(pair.first)], known_tracks[static_cast<std::size_t>(pair.second)],
                is_one);
  };
  for (const auto& pair : continuation.alike) vote(pair, true);
  for (const auto& pair : continuation.apart) vote(pair, false);
  tracks.mergePairs([this](const MapPlane& plane) { return poseError(plane); });
  tracks.endTracks(frame, extractor.parameters().inverse_depth.min_confidence);
}

void PlaneTracker::State::label(TrackedFrame& result) const {
  const std::size_t count = result.segmentation.planes.size();
  std::vector<std::int32_t> lasting(count + 1, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const int track = tracks.alive(track_of_plane[k]);
    if (track >= 0) lasting[k + 1] = tracks.at(track).label;
  }
  result.label_of_plane.assign(lasting.begin() + 1, lasting.end());
  result.track_of_plane = track_of_plane;
  const std::vector<std::int32_t>& labels = result.segmentation.labels;
  result.labels.resize(labels.size());
  relabelPixels(labels.data(), labels.size(), lasting.data(), result.labels.data());
}

// The frame becomes the last one, and the keyframe if that shows too little of what is known.
void PlaneTracker::State::remember(const PlaneSegmentation& segmentation) {
  if (known.search) last_search = frame;
  known.views.clear();  // or what they show would have to stay
  if (continuation.waiting.empty()) last_look = frame;
  last.take(segmentation, track_of_plane, pose, continuation);
  const auto from_keyframe = static_cast<double>(continuation.from_first_view);
  const bool shows_enough =
      keyframe.labels != nullptr && from_keyframe > kShareOfKeyframe * static_cast<double>(continuation.from_views);
  if (frame + 1 >= tracker.confirm_frames && !shows_enough) keyframe = last;
}

void PlaneTracker::State::forget() {
  tracks = MapTracks(tracker);
  last = keyframe = Keyframe();
  frame = last_search = 0;
  error_scale = 1.0;
  has_pose = false;
  pose = motion = map_of_given = Eigen::Isometry3d::Identity();
  known.views.clear();
}

}  // namespace epcc
