// SPDX-License-Identifier: BSD-3-Clause
// A frame counts once, however many methods doubt it.
#include "eval/experiment/doubtful_frames.h"

#include <algorithm>

#include "eval/program/frame_sensor.h"

namespace epcc {

void DoubtfulFrames::add(const std::vector<FrameRecord>& records) {
  const auto doubted =
      std::find_if(records.begin(), records.end(), [](const FrameRecord& record) { return !record.doubt.empty(); });
  if (doubted == records.end()) return;
  auto of = std::find_if(all_.begin(), all_.end(), [&](const OfDataset& d) { return d.dataset == doubted->dataset; });
  if (of == all_.end()) of = all_.insert(all_.end(), {doubted->dataset, 0, doubted->frame, doubted->doubt});
  ++of->frames;
}

std::vector<std::string> DoubtfulFrames::lines() const {
  std::vector<std::string> lines;
  for (const OfDataset& of : all_) lines.push_back(of.dataset + ": " + doubtfulText(of.frames, of.first, of.doubt));
  return lines;
}

}  // namespace epcc
