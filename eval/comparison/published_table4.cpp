// SPDX-License-Identifier: BSD-3-Clause
// Table 4 as printed; the columns headed N_r and N_p in some copies are N_o and N_u.
#include "eval/comparison/published_table4.h"

#include <cstddef>

namespace epcc {
namespace {

// By scene a to d.
constexpr std::array<PublishedScores, 4> kRegionGrowing = {
    {{6, 5, 1.00, 0.00, 0.20}, {16, 11, 1.00, 0.09, 0.18}, {15, 8, 0.89, 0.22, 0.33}, {11, 5, 0.56, 0.00, 0.22}}};
constexpr std::array<PublishedScores, 4> kRansac = {
    {{11, 5, 1.00, 0.40, 0.00}, {32, 9, 0.82, 0.27, 0.09}, {25, 9, 1.00, 0.66, 0.00}, {53, 8, 0.89, 0.56, 0.11}}};
constexpr std::array<PublishedScores, 4> kEpcc = {
    {{7, 5, 1.00, 0.40, 0.00}, {15, 11, 1.00, 0.09, 0.00}, {10, 9, 1.00, 0.10, 0.00}, {14, 8, 0.89, 0.22, 0.00}}};

PublishedScores meanOf(const std::array<PublishedScores, 4>& scenes) {
  PublishedScores mean{};
  for (const PublishedScores& scene : scenes)
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += scene[i] / static_cast<double>(scenes.size());
  return mean;
}

}  // namespace

std::optional<PublishedScores> publishedTable4(const std::string& scene, const std::string& method) {
  const std::array<PublishedScores, 4>* table = nullptr;
  if (method == "region-growing") table = &kRegionGrowing;
  if (method == "ransac") table = &kRansac;
  if (method == "epcc-paper") table = &kEpcc;
  if (table == nullptr) return std::nullopt;
  if (scene == "mean") return meanOf(*table);
  if (scene.size() != 1 || scene[0] < 'a' || scene[0] > 'd') return std::nullopt;
  return (*table)[static_cast<std::size_t>(scene[0] - 'a')];
}

}  // namespace epcc
