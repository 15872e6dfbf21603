// SPDX-License-Identifier: BSD-3-Clause
// A study's rows become a table, its frames a picture.
#include "eval/comparison/study_report.h"

#include <filesystem>

#include "datasets/files/png_io.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/output_folder.h"
#include "eval/comparison/comparison_figure.h"
#include "eval/pictures/mosaic.h"
#include "eval/pictures/overlay.h"

namespace epcc {
namespace {

/// Heading and name cells common to both tables.
Table namedRows(const Study& study, const StudyResult& result) {
  Table table;
  if (study.by_frames) table.columns.push_back({study.frames_title, false});
  table.columns.push_back({study.row_title, false});
  if (!study.column_title.empty()) table.columns.push_back({study.column_title});
  for (const StudyRow& row : result.rows) {
    std::vector<std::string> cells;
    if (study.by_frames) cells.push_back(row.frames);
    cells.push_back(study.variants[row.variant].row);
    if (!study.column_title.empty()) cells.push_back(study.variants[row.variant].column);
    table.rows.push_back(cells);
  }
  return table;
}

template <typename Cell>
void addColumn(const std::string& title, const StudyResult& result, const Cell& cell, Table& table) {
  table.columns.push_back({title});
  for (std::size_t i = 0; i < result.rows.size(); ++i) table.rows[i].push_back(cell(result.rows[i]));
}

void addLineColumns(const StudyResult& result, Table& table) {
  const auto lines = [](const StudyRow& row) { return numberCell(row.lines, 2); };
  const auto share = [](const StudyRow& row) { return numberCell(row.line_share, 3); };
  addColumn("segments a line", result, lines, table);
  addColumn("pixels in segments", result, share, table);
}

ColorImage pictureByFrames(const Study& study, const StudyResult& result) {
  Mosaic mosaic;
  mosaic.column_captions = {"Depth (rendered)", "Ground truth"};
  for (const StudyVariant& variant : study.variants) mosaic.column_captions.push_back(variant.row);
  for (const StudyPicture& picture : result.pictures) {
    mosaic.row_captions.push_back(picture.frames);
    mosaic.rows.push_back({shadeDepth(picture.frame.depth), drawOverlay(picture.frame.depth, picture.frame.labels)});
    for (const PlaneSegmentation& segmentation : picture.segmentations)
      mosaic.rows.back().push_back(drawAsInTruth(picture.frame, segmentation));
  }
  return drawMosaic(mosaic);
}

ColorImage pictureOfGrid(const Study& study, const StudyPicture& picture) {
  Mosaic mosaic;
  for (std::size_t v = 0; v < study.variants.size(); ++v) {
    const StudyVariant& variant = study.variants[v];
    if (mosaic.row_captions.empty() || study.variants[v - 1].row != variant.row) {
      mosaic.row_captions.push_back(study.row_title + " " + variant.row);
      mosaic.rows.emplace_back();
    }
    if (mosaic.rows.size() == 1) mosaic.column_captions.push_back(study.column_title + " " + variant.column);
    mosaic.rows.back().push_back(drawAsInTruth(picture.frame, picture.segmentations[v]));
  }
  return drawMosaic(mosaic);
}

}  // namespace

std::string studyNote(const Study& study) {
  return study.title + ". EPCC in the paper's mode, Table 3 elsewhere, noise model " + study.sensor +
         "; rendered frames (the authors' scenes are not public), noise: " + study.noise_text +
         ". Mean ± standard deviation over " + std::to_string(study.seeds) + " seeds" +
         (study.by_frames ? "." : " of the mean over the scenes.");
}

Table studyTable(const Study& study, const StudyResult& result) {
  Table table = namedRows(study, result);
  constexpr const char* kTitles[kScoreCount] = {"IC", "D", "D/N", "N_o/N", "N_u/N", "coverage"};
  for (std::size_t score = 0; score < kScoreCount; ++score) {
    const int decimals = score <= kDetected ? 1 : 2;
    const auto cell = [score, decimals](const StudyRow& row) {
      return numberCell(row.mean[score], decimals) + " ± " + numberCell(row.deviation[score], decimals);
    };
    addColumn(kTitles[score], result, cell, table);
  }
  if (study.count_lines) addLineColumns(result, table);
  return table;
}

Table studyNumbers(const Study& study, const StudyResult& result) {
  Table table = namedRows(study, result);
  for (std::size_t score = 0; score < kScoreCount; ++score) {
    const std::string name = kScoreNames[score];
    addColumn(
        name + "_mean", result, [score](const StudyRow& row) { return numberCell(row.mean[score], 4); }, table);
    addColumn(
        name + "_std", result, [score](const StudyRow& row) { return numberCell(row.deviation[score], 4); }, table);
  }
  if (study.count_lines) addLineColumns(result, table);
  return table;
}

ColorImage studyPicture(const Study& study, const StudyResult& result) {
  if (study.by_frames) return pictureByFrames(study, result);
  for (const StudyPicture& picture : result.pictures)
    if (picture.frames == study.pictured) return pictureOfGrid(study, picture);
  return pictureOfGrid(study, result.pictures.front());
}

std::vector<std::string> studyFiles(const std::string& study) {
  return {"study_" + study + ".md", "study_" + study + ".csv", "study_" + study + ".png"};
}

void writeStudy(const std::string& out, const Study& study, const StudyResult& result) {
  makeOutputFolder(out);
  const std::string base = (std::filesystem::path(out) / ("study_" + study.name)).string();
  writeTextFile(base + ".md", studyNote(study) + "\n\n" + markdownTable(studyTable(study, result)));
  writeTextFile(base + ".csv", csvTable(studyNumbers(study, result)));
  writeRgb(base + ".png", studyPicture(study, result));
}

}  // namespace epcc
