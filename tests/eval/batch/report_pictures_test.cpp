// SPDX-License-Identifier: BSD-3-Clause
// Which frames the report shows.
#include "eval/batch/report_pictures.h"

#include <gtest/gtest.h>

#include <new>

#include "tests/support/temp_folder.h"
#include "tests/support/tiny_frames.h"

namespace {

using namespace epcc;

StoredFrame frame(const std::string& dataset, std::size_t index, long correct, const std::string& error = "") {
  FrameRecord record{dataset, "f" + std::to_string(index), "m", {}, {}, error};
  record.measures.paper.surfaces = record.measures.paper.clusters = 10;
  record.measures.segcomp.correct = correct;
  return {index, record.frame, {record}};
}

std::string texts(const std::vector<PicturedFrame>& frames) {
  std::string text;
  for (const PicturedFrame& f : frames)
    text += f.frame.records[0].dataset + std::to_string(f.frame.index) + " " + f.why + "; ";
  return text;
}

const long kCorrect[] = {5, 9, 2, 9, 2, 7, 2};

TEST(PictureChoice, FirstWorstAndBestOfEachDataSet) {
  PictureChoice choice(2);
  for (std::size_t i = 0; i < 7; ++i) choice.add(frame("a", i, kCorrect[i]), "out");
  choice.add(frame("b", 0, 0, "broken"), "out");
  choice.add(frame("b", 1, 4), "out");
  EXPECT_EQ(texts(choice.chosen()), "a0 first; a1 best, first; a2 worst; a3 best; a4 worst; b1 worst, best, first; ");
}

TEST(PictureChoice, ChoiceAmongAllIsAmongThoseOfTheParts) {
  PictureChoice all(2), parts(2);
  for (std::size_t i = 0; i < 7; ++i) all.add(frame("a", i, kCorrect[i]), "out");
  for (std::size_t part = 0; part < 3; ++part) {
    PictureChoice own(2);
    for (std::size_t i = part; i < 7; i += 3) own.add(frame("a", i, kCorrect[i]), "out");
    for (const PicturedFrame& pictured : own.chosen()) parts.add(pictured.frame, pictured.folder);
  }
  EXPECT_EQ(texts(parts.chosen()), texts(all.chosen()));
}

class TooLarge : public test::MemorySource {
 public:
  TooLarge() : MemorySource("a", {}) {}
  LabelledFrame read(std::size_t) const override { throw std::bad_alloc(); }
};

TEST(DrawPictures, AFrameTooLargeToBeDrawnCostsItsPicturesAlone) {
  const test::TempFolder out;
  EXPECT_NO_THROW(drawPictures({frame("a", 0, 1), out.path(), "first"}, TooLarge()));
}

TEST(PictureChoice, NoneIfNoneAreWanted) {
  PictureChoice choice(0);
  choice.add(frame("a", 0, 1), "out");
  EXPECT_TRUE(choice.chosen().empty());
}

}  // namespace
