// SPDX-License-Identifier: BSD-3-Clause
// The PCL class on random clouds: its lists agree, and neither the order of its setters nor what is not asked for
// changes them.
#include <gtest/gtest.h>
#include <pcl/point_types.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include "epcc_segmentation/pcl/epcc_segmentation.h"
#include "tests/epcc_segmentation/properties/random_frames.h"
#include "tests/epcc_segmentation/properties/sound_result.h"

namespace epcc::test {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Segmentation = EPCCSegmentation<pcl::PointXYZ>;

const std::vector<FrameKind> kClouds{FrameKind::Cloud, FrameKind::BackwardCloud, FrameKind::Scanner};

struct Output {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices;
  Segmentation::Centroids centroids;
  Segmentation::Covariances covariances;
  pcl::PointCloud<pcl::Label> labels;
};

/// A cloud with what it is to be segmented with.
struct Task {
  explicit Task(const FrameSpec& spec) : frame(spec), way(*anyWay(spec.kind)), cloud(new Cloud) {
    const auto width = static_cast<std::uint32_t>(spec.width), height = static_cast<std::uint32_t>(spec.height);
    cloud->resize(width * height);
    cloud->width = width;
    cloud->height = height;
    cloud->is_dense = false;
    for (std::size_t i = 0; i < cloud->size(); ++i)
      (*cloud)[i] = {frame.xyz[3 * i], frame.xyz[3 * i + 1], frame.xyz[3 * i + 2]};
    if (frame.mask.empty()) return;
    indices.reset(new pcl::Indices);
    for (std::size_t i = 0; i < frame.mask.size(); ++i)
      if (frame.mask[i] != 0) indices->push_back(static_cast<int>(i));
    frame.closes_round = false;
  }

  RandomFrame frame;
  Way way;
  Cloud::Ptr cloud;
  pcl::IndicesPtr indices;  // null: all
};

/// Calls the setters in the order given.
Output segmented(const Task& task, const std::array<int, 5>& order) {
  Segmentation segmentation;
  const std::array<std::function<void()>, 5> setters = {[&] { segmentation.setInputCloud(task.cloud); },
                                                        [&] {
                                                          if (task.indices) segmentation.setIndices(task.indices);
                                                        },
                                                        [&] {
                                                          if (task.way.is_measured)
                                                            segmentation.setSensorModelAuto();
                                                          else
                                                            segmentation.setSensorModel(task.frame.sensor());
                                                        },
                                                        [&] { segmentation.setParameters(task.way.parameters()); },
                                                        [&] { segmentation.setProjection(task.frame.projection); }};
  for (const int setter : order) setters[static_cast<std::size_t>(setter)]();
  Output out;
  segmentation.segment(out.models, out.inliers, out.centroids, out.covariances, out.labels, out.label_indices);
  RC_ASSERT(segmentation.getErrorMessage() == "");
  RC_ASSERT(resultProblem(segmentation.getSegmentation(), task.frame) == "");
  return out;
}

FrameSpec organizedCloud() {
  FrameSpec spec = *anyFrame(kClouds);
  spec.height = std::max(2, spec.height);  // one row is not organized
  return spec;
}

RC_GTEST_PROP(SoundPclOutputs, ListsLabelsAndModelsAgree, ()) {
  const Task task(organizedCloud());
  const Output out = segmented(task, {0, 1, 2, 3, 4});
  const std::size_t planes = out.models.size();
  RC_ASSERT(out.inliers.size() == planes && out.label_indices.size() == planes);
  RC_ASSERT(out.centroids.size() == planes && out.covariances.size() == planes);
  RC_ASSERT(out.labels.size() == task.cloud->size());
  std::vector<std::uint32_t> labels(task.cloud->size(), Segmentation::kNoPlane);
  for (std::size_t k = 0; k < planes; ++k) {
    RC_ASSERT(!out.inliers[k].indices.empty());
    RC_ASSERT(out.inliers[k].indices == out.label_indices[k].indices);
    RC_ASSERT(std::is_sorted(out.inliers[k].indices.begin(), out.inliers[k].indices.end()));
    for (const int index : out.inliers[k].indices) {
      RC_ASSERT(labels[static_cast<std::size_t>(index)] == Segmentation::kNoPlane);  // at most one plane
      RC_ASSERT(task.frame.isValid(static_cast<std::size_t>(index)));
      labels[static_cast<std::size_t>(index)] = static_cast<std::uint32_t>(k);
    }
    const std::vector<float>& model = out.models[k].values;
    RC_ASSERT(model.size() == 4U);
    RC_ASSERT(std::abs(Eigen::Vector3f(model[0], model[1], model[2]).norm() - 1.0f) < 1e-5f);
    RC_ASSERT(model[3] >= 0.0f);
    RC_ASSERT(out.covariances[k].diagonal().minCoeff() >= 0.0f);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) RC_ASSERT(out.labels[i].label == labels[i]);
}

RC_GTEST_PROP(SoundPclOutputs, TheOrderOfTheSettersChangesNothing, ()) {
  const Task task(organizedCloud());
  std::array<int, 5> order = {0, 1, 2, 3, 4};
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    std::swap(order[i], order[static_cast<std::size_t>(*rc::gen::inRange(static_cast<int>(i), 5))]);
  const Output one = segmented(task, {0, 1, 2, 3, 4}), other = segmented(task, order);
  RC_ASSERT(one.models.size() == other.models.size());
  for (std::size_t k = 0; k < one.models.size(); ++k) {
    RC_ASSERT(one.models[k].values == other.models[k].values);
    RC_ASSERT(one.inliers[k].indices == other.inliers[k].indices);
  }
}

// Given twice and in any order they are the same points.
RC_GTEST_PROP(SoundPclOutputs, IndicesMayRepeatInAnyOrder, ()) {
  FrameSpec spec = organizedCloud();
  spec.masked = true;
  Task task(spec);
  const Output one = segmented(task, {0, 1, 2, 3, 4});
  task.indices.reset(new pcl::Indices(*task.indices));
  const std::size_t count = task.indices->size();
  for (std::size_t i = 0; i < count / 3; ++i) task.indices->push_back((*task.indices)[i]);
  std::reverse(task.indices->begin(), task.indices->end());
  const Output other = segmented(task, {0, 1, 2, 3, 4});
  RC_ASSERT(one.inliers.size() == other.inliers.size());
  for (std::size_t k = 0; k < one.inliers.size(); ++k) RC_ASSERT(one.inliers[k].indices == other.inliers[k].indices);
}

}  // namespace
}  // namespace epcc::test
