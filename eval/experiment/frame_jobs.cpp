// SPDX-License-Identifier: BSD-3-Clause
// A job's file name has the data set before it where two sources have frames of the same name.
#include "eval/experiment/frame_jobs.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "datasets/support/text_hash.h"

namespace epcc {

namespace {

/// Hashes in place of the names: sixteen bytes a frame, for as long as the function runs.
std::vector<std::uint64_t> sharedNames(const std::vector<const FrameSource*>& sources) {
  std::vector<std::uint64_t> shared;
  if (sources.size() < 2) return shared;
  std::vector<std::pair<std::uint64_t, std::size_t>> uses;
  for (std::size_t s = 0; s < sources.size(); ++s)
    for (std::size_t i = 0; i < sources[s]->size(); ++i) uses.emplace_back(textHash(sources[s]->name(i)), s);
  std::sort(uses.begin(), uses.end());
  for (std::size_t i = 1; i < uses.size(); ++i)
    if (uses[i].first == uses[i - 1].first && uses[i].second != uses[i - 1].second) shared.push_back(uses[i].first);
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  return shared;
}

}  // namespace

FrameJob FrameJobs::operator[](std::size_t i) const {
  return at(positions_.at(i));
}

FrameJob FrameJobs::at(std::size_t position) const {
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), position);
  const std::size_t s = static_cast<std::size_t>(next - starts_.begin()) - 1;
  const FrameSource* source = sources_[s];
  const std::size_t index = position - starts_[s];
  const std::string name = source->name(index);
  const bool shared = std::binary_search(shared_names_.begin(), shared_names_.end(), textHash(name));
  return {source, index, position, shared ? source->dataset() + "/" + name : name};
}

void FrameJobs::keepIf(const std::function<bool(const FrameJob&)>& wanted) {
  const auto unwanted = [&](std::size_t position) { return !wanted(at(position)); };
  positions_.erase(std::remove_if(positions_.begin(), positions_.end(), unwanted), positions_.end());
  positions_.shrink_to_fit();
}

void FrameJobs::keepFirst(std::size_t count) {
  positions_.resize(std::min(count, positions_.size()));
}

FrameJobs listJobs(const std::vector<std::unique_ptr<FrameSource>>& sources) {
  FrameJobs jobs;
  std::size_t frames = 0;
  for (const auto& source : sources) {
    if (source->size() == 0) continue;
    jobs.sources_.push_back(source.get());
    jobs.starts_.push_back(frames);
    frames += source->size();
  }
  jobs.shared_names_ = sharedNames(jobs.sources_);
  jobs.positions_.resize(frames);
  std::iota(jobs.positions_.begin(), jobs.positions_.end(), std::size_t{0});
  return jobs;
}

}  // namespace epcc
