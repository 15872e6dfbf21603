// SPDX-License-Identifier: BSD-3-Clause
// The choice keeps the best few frames of each kind as they come; the pictures are drawn once all are known.
#include "eval/batch/report_pictures.h"

#include <cstdio>
#include <filesystem>
#include <new>
#include <set>
#include <tuple>

#include "datasets/files/png_io.h"
#include "datasets/support/input_error.h"
#include "datasets/support/output_folder.h"
#include "eval/pictures/mosaic.h"
#include "eval/pictures/overlay.h"

namespace epcc {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxWidth = 200;

ColorImage thumbnail(const ColorImage& image) {
  if (image.width <= kMaxWidth) return image;
  return resize(image, kMaxWidth, std::max(1, image.height * kMaxWidth / image.width));
}

}  // namespace

void PictureChoice::add(const StoredFrame& frame, const std::string& folder) {
  bool scored = false;
  for (const FrameRecord& record : frame.records) scored = scored || record.error.empty();
  if (!scored || each_ == 0) return;
  const FrameRecord& record = frame.records[0];
  const auto [place, is_new] = place_of_.try_emplace(record.dataset, kinds_.size());
  if (is_new) kinds_.push_back({Kept(each_), Kept(each_), Kept(each_)});
  Kinds& kinds = kinds_[place->second];
  kinds.first.add({FrameScore(), frame.index}, {frame, folder, "first"});
  if (!record.error.empty()) return;
  const FrameScore score(record.measures);
  kinds.worst.add({score, frame.index}, {frame, folder, "worst"});
  kinds.best.add({score.reversed(), frame.index}, {frame, folder, "best"});
}

std::vector<PicturedFrame> PictureChoice::chosen() const {
  std::vector<PicturedFrame> all;
  for (const Kinds& kinds : kinds_) {
    std::map<std::size_t, PicturedFrame> by_index;
    for (const Kept* kept : {&kinds.worst, &kinds.best, &kinds.first})
      for (const auto& [key, pictured] : kept->kept()) {
        const auto [found, is_new] = by_index.try_emplace(key.second, pictured);
        if (!is_new) found->second.why += ", " + pictured.why;
      }
    for (const auto& [index, pictured] : by_index) all.push_back(pictured);
  }
  return all;
}

std::string picturePath(const PicturedFrame& pictured, std::size_t number) {
  const std::string name = std::to_string(pictured.frame.index) + "_" + std::to_string(number) + ".png";
  return (fs::path(pictured.folder) / "pictures" / pictured.frame.records.at(0).dataset / name).string();
}

void drawPictures(const PicturedFrame& pictured, const FrameSource& source) try {
  const std::string folder = fs::path(picturePath(pictured, 0)).parent_path().string();
  makeOutputFolder(folder);
  LabelledFrame frame;
  try {
    frame = source.read(pictured.frame.index);
  } catch (const InputError&) {
    return;
  }
  writeRgb(picturePath(pictured, 0), thumbnail(shadeDepth(frame.depth)));
  writeRgb(picturePath(pictured, 1), thumbnail(drawOverlay(frame.depth, frame.labels)));
  for (std::size_t m = 0; m < pictured.frame.records.size(); ++m) {
    const FrameRecord& record = pictured.frame.records[m];
    if (!record.error.empty()) continue;
    try {
      const std::string name = pictured.frame.file_name + "_labels.png";
      const LabelImage labels = readGray16((fs::path(pictured.folder) / "labels" / record.method / name).string());
      if (labels.data.size() == frame.depth.data.size())
        writeRgb(picturePath(pictured, 2 + m), thumbnail(drawOverlay(frame.depth, labels)));
    } catch (const InputError&) {
      continue;
    }
  }
} catch (const std::bad_alloc&) {
  return;  // there is memory to score the frame, but not to draw it
}

}  // namespace epcc
