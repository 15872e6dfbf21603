// SPDX-License-Identifier: BSD-3-Clause
// Of every frame it is known which folder holds it before the first one is read.
#include "eval/batch/stored_results.h"

#include <algorithm>

#include "datasets/support/input_error.h"

namespace epcc {

namespace {

/// The first frame that a shard has of a data set whose frames begin at the position `start`; smaller than the number
/// of shards.
std::size_t firstIndex(const Shard& shard, std::size_t start) {
  return (shard.number - 1 + shard.count - start % shard.count) % shard.count;
}

}  // namespace

StoredResults::StoredResults(const std::string& folder, const RunDescription& run) {
  run_ = run;
  run_.datasets.clear();
  add(folder, run);
}

StoredResults StoredResults::merged(const std::vector<std::string>& folders) {
  StoredResults results;
  for (const std::string& folder : folders) {
    const RunDescription run = readRunDescription(folder);
    if (results.run_.program.empty()) {
      results.run_ = run;
      results.run_.datasets.clear();
      results.run_.shard = Shard();
    }
    const std::string difference = optionDifference(results.run_, run);
    if (!difference.empty()) throw InputError(folder, "options", "another run than " + folders[0] + ": " + difference);
    results.add(folder, run);
    // A shard has drawn no more than it was asked for.
    results.run_.pictures = std::min(results.run_.pictures, run.pictures);
    for (const std::string& problem : run.unusable) {
      auto& all = results.run_.unusable;
      if (std::find(all.begin(), all.end(), problem) == all.end()) all.push_back(problem);
    }
  }
  results.requireAllShards();
  return results;
}

/// Those known already or, for a data set seen first, new ones without a folder.
StoredResults::Owners& StoredResults::ownersOf(const RunDataset& dataset, std::size_t start, const std::string& folder,
                                               std::size_t shards) {
  auto& known = run_.datasets;
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const RunDataset& d) { return d.name == dataset.name; });
  if (found == known.end()) {
    known.push_back(dataset);
    return owners_.emplace_back(Owners{start, std::vector<std::string>(shards)});
  }
  const std::string difference = datasetDifference(*found, dataset);
  if (!difference.empty()) throw InputError(folder, "frames", difference);
  Owners& owners = owners_[static_cast<std::size_t>(found - known.begin())];
  if (owners.folders.size() != shards)
    throw InputError(folder, "shard",
                     "data set " + dataset.name + " is in " + std::to_string(shards) + " shards here, in " +
                         std::to_string(owners.folders.size()) + " elsewhere");
  return owners;
}

void StoredResults::add(const std::string& folder, const RunDescription& run) {
  std::size_t start = 0;
  for (const RunDataset& dataset : run.datasets) {
    Owners& owners = ownersOf(dataset, start, folder, run.shard.count);
    std::string& owner = owners.folders[firstIndex(run.shard, start)];
    if (!owner.empty())
      throw InputError(folder, "shard",
                       "data set " + dataset.name + ", shard " + run.shard.text() + " is in " + owner + " too");
    owner = folder;
    start += dataset.frames;
  }
}

void StoredResults::requireAllShards() const {
  for (std::size_t d = 0; d < owners_.size(); ++d) {
    const std::size_t shards = owners_[d].folders.size();
    std::string missing;
    for (std::size_t number = 1; number <= shards; ++number)
      if (owners_[d].folders[firstIndex({number, shards}, owners_[d].start)].empty())
        missing += (missing.empty() ? "" : ", ") + Shard{number, shards}.text();
    if (!missing.empty()) throw InputError("data set " + run_.datasets[d].name, "shards", "missing: " + missing);
  }
}

void StoredResults::forEach(const Visit& visit) const {
  std::size_t missing = 0;
  std::string first;
  for (std::size_t d = 0; d < owners_.size(); ++d) {
    const RunDataset& dataset = run_.datasets[d];
    for (std::size_t i = 0; i < dataset.frames; ++i) {
      const std::string& folder = owners_[d].folders[i % owners_[d].folders.size()];
      if (folder.empty()) continue;
      if (const std::optional<StoredFrame> frame = loadFrame(folder, dataset.name, i, run_.methods))
        visit(*frame, folder);
      else if (missing++ == 0)
        first = storedFramePath(folder, dataset.name, i);
    }
  }
  if (missing > 0)
    throw InputError(first, "result",
                     missing == 1
                         ? "is missing; finish the run with --resume"
                         : "is missing, with " + std::to_string(missing - 1) + " more; finish the run with --resume");
}

}  // namespace epcc
