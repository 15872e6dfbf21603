// SPDX-License-Identifier: BSD-3-Clause
// A study as tables and a picture.
#pragma once

#include <string>

#include "eval/comparison/study.h"
#include "eval/report/table.h"

namespace epcc {

/// What was run, in words.
std::string studyNote(const Study& study);
/// Mean ± standard deviation over the seeds.
Table studyTable(const Study& study, const StudyResult& result);
/// One number a cell.
Table studyNumbers(const Study& study, const StudyResult& result);
/// The grid of variants on one frame; or, by_frames, a row a set of frames: depth, truth, and every variant.
ColorImage studyPicture(const Study& study, const StudyResult& result);

/// Names of the files that writeStudy() leaves.
std::vector<std::string> studyFiles(const std::string& study);

/// Writes OUT/study_NAME.md, .csv and .png; makes the folder. Throws OutputError.
void writeStudy(const std::string& out, const Study& study, const StudyResult& result);

}  // namespace epcc
