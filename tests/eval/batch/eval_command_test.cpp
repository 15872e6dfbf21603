// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval from files to files.
#include <cstdlib>

#include "datasets/files/labelled_frame.h"
#include "datasets/files/png_io.h"
#include "tests/eval/batch/eval_runner.h"

namespace {

namespace fs = std::filesystem;
using epcc::LabelImage;
using epcc::test::EvalToolTest;

class EvalCommand : public EvalToolTest {
 protected:
  /// Copies the truth with label k as 100 k: ids with gaps.
  void predictPerfectly(const std::string& dataset, const std::string& name, const std::string& target) const {
    LabelImage labels = epcc::readGray16(path(dataset + "/" + name + "_labels.png"));
    for (std::uint16_t& label : labels.data) label = static_cast<std::uint16_t>(100 * label);
    fs::create_directories(fs::path(path(target)).parent_path());
    epcc::writeGray16(path(target), labels);
  }
};

TEST_F(EvalCommand, LeavesTheFilesOfTheContract) {
  writeFrame("rooms", "f1", 1);
  writeFrame("rooms", "f2", 2);
  const auto result = run({"rooms", "--out", "deep/out", "--overlays"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "") << "quiet where there is no terminal";
  for (const std::string method : {"epcc", "epcc-paper", "region-growing", "ransac", "omps"}) {
    const auto entry = row("deep/out", "rooms", method);
    EXPECT_EQ(entry.at("frames"), 2) << method;
    EXPECT_EQ(entry.at("errors"), 0) << method;
    EXPECT_EQ(entry.at("N"), 6) << method;
    EXPECT_GT(entry.at("median_ms"), 0.0) << method;
    EXPECT_NE(result.out.find(method), std::string::npos) << method;
    EXPECT_EQ(epcc::readGray16(path("deep/out/labels/" + method + "/f2_labels.png")).width, 80);
  }
  EXPECT_EQ(row("deep/out", "rooms", "epcc-paper").at("D"), 6);
  EXPECT_TRUE(exists("deep/out/overlays/f1.png"));
  EXPECT_NE(read("deep/out/summary.md").find("| rooms | epcc |"), std::string::npos);
  EXPECT_EQ(frames("deep/out").size(), 11U);
  EXPECT_NE(read("deep/out/summary.tex").find("rooms & epcc & 2 & 0 & 6"), std::string::npos);
  const std::string page = read("deep/out/report.html");
  std::size_t pictures = 0;
  for (std::size_t at = page.find("data:image/png;base64,iVBOR"); at != std::string::npos; ++pictures)
    at = page.find("data:image/png;base64,iVBOR", at + 1);
  EXPECT_EQ(pictures, 2U * 7U) << "depth, truth and five methods of two frames";
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(page.find("<link"), std::string::npos);
}

TEST_F(EvalCommand, WithoutOutItWritesNothing) {
  writeFrame("rooms", "f1");
  const auto result = run({"rooms", "--methods", "omps"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.rfind("dataset  method  frames  errors  N  IC", 0), 0U) << result.out;
  EXPECT_EQ(names(), std::vector<std::string>{"rooms"});
}

TEST_F(EvalCommand, FramesAddUpToTheSummary) {
  for (unsigned i = 0; i < 3; ++i) writeFrame("rooms", "f" + std::to_string(i), i);
  writeFrame("halls", "g");
  write("rooms/f1_labels.png", "broken");
  ASSERT_EQ(run({"rooms", "halls", "--out", "o", "--methods", "epcc-paper,omps"}).exit_code, 0);
  const auto rows = frames("o");
  ASSERT_EQ(rows.size(), 9U);
  for (const std::string dataset : {"rooms", "halls"})
    for (const std::string method : {"epcc-paper", "omps"}) {
      const auto summary = row("o", dataset, method);
      for (std::size_t column = 3; column < 15; ++column) {
        long sum = 0;
        for (const auto& cells : rows)
          if (cells[0] == dataset && cells[2] == method) sum += std::atol(cells[column].c_str());
        EXPECT_EQ(summary.at(rows[0][column]), sum) << dataset << ' ' << method << ' ' << rows[0][column];
      }
    }
  EXPECT_EQ(row("o", "rooms", "omps").at("frames"), 3);
  EXPECT_EQ(row("o", "rooms", "omps").at("errors"), 1);
}

TEST_F(EvalCommand, PerfectPredictionsScoreEverySurface) {
  writeFrame("rooms", "f1", 1);
  writeFrame("rooms", "f2", 2);
  for (const std::string name : {"f1", "f2"}) predictPerfectly("rooms", name, "theirs/" + name + "_labels.png");
  const auto result = run({"rooms", "--methods", "none", "--predictions", "theirs=theirs", "--out", "o"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto entry = row("o", "rooms", "theirs");
  for (const char* key : {"N", "IC", "D", "correct"}) EXPECT_EQ(entry.at(key), 6) << key;
  for (const char* key : {"No", "Nu", "over", "under", "missed", "noise", "errors"}) EXPECT_EQ(entry.at(key), 0) << key;
  EXPECT_TRUE(entry.at("median_ms").is_null()) << "the time of another program is not known";
}

TEST_F(EvalCommand, OwnLabelsImportedAgainScoreTheSame) {
  writeFrame("rooms", "f1", 1);
  writeFrame("halls", "f1", 2);  // the same name in two data sets
  ASSERT_EQ(run({"rooms", "halls", "--methods", "omps", "--out", "first"}).exit_code, 0);
  EXPECT_TRUE(exists("first/labels/omps/rooms/f1_labels.png"));
  const auto result =
      run({"rooms", "halls", "--methods", "omps", "--predictions", "again=first/labels/omps", "--out", "second"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const std::string dataset : {"rooms", "halls"}) {
    auto own = row("second", dataset, "omps"), again = row("second", dataset, "again");
    for (auto* entry : {&own, &again}) {
      entry->erase("method");
      entry->erase("median_ms");
    }
    EXPECT_EQ(own, again);
    EXPECT_EQ(again.at("errors"), 0);
  }
}

TEST_F(EvalCommand, PicturesAreChosenByNumber) {
  for (unsigned i = 0; i < 4; ++i) writeFrame("rooms", "f" + std::to_string(i), i);
  const std::vector<std::string> arguments = {"rooms", "--methods", "epcc-paper", "--out", "o", "--resume"};
  const auto with = [&](const std::string& number) {
    auto all = arguments;
    all.insert(all.end(), {"--pictures", number});
    return run(all).exit_code;
  };
  ASSERT_EQ(with("0"), 0);
  EXPECT_EQ(read("o/report.html").find("<figure>"), std::string::npos);
  EXPECT_FALSE(exists("o/pictures"));
  ASSERT_EQ(with("1"), 0) << "the number changes no result";
  EXPECT_NE(read("o/report.html").find("rooms / f0 ("), std::string::npos);
  EXPECT_EQ(read("o/report.html").find("<div class=\"none\">"), std::string::npos) << "every picture is there";
  expectFailure({"rooms", "--pictures", "-1"}, 2, "--pictures");
}

TEST_F(EvalCommand, SeveralDataSetsHaveTotals) {
  writeFrame("rooms", "f");
  ASSERT_EQ(run({"rooms", "--methods", "epcc-paper,omps", "--out", "one"}).exit_code, 0);
  EXPECT_FALSE(nlohmann::json::parse(read("one/summary.json")).contains("totals"));
  writeFrame("halls", "g");
  ASSERT_EQ(run({"rooms", "halls", "--methods", "epcc-paper,omps", "--out", "two"}).exit_code, 0);
  const auto totals = nlohmann::json::parse(read("two/summary.json")).at("totals");
  ASSERT_EQ(totals.size(), 2U);
  EXPECT_EQ(totals[1].at("method"), "omps");
  EXPECT_EQ(totals[1].at("dataset"), "all");
  EXPECT_EQ(totals[1].at("N"), 6);
}

TEST_F(EvalCommand, SeedsAreMethodsOfTheirOwnWhereThereIsChance) {
  writeFrame("rooms", "f1", 1);
  const auto run_with = [&](const std::string& seeds, const std::string& out) {
    return run({"rooms", "--methods", "ransac,omps", "--seeds", seeds, "--out", out}).exit_code;
  };
  ASSERT_EQ(run_with("1", "one"), 0);
  ASSERT_EQ(run_with("4", "four"), 0);
  EXPECT_EQ(frames("four").size(), 6U) << "ransac and its seeds 1 to 3, omps, the heading";
  const auto labels = [&](const std::string& out, const std::string& method) {
    return read(out + "/labels/" + method + "/f1_labels.png");
  };
  EXPECT_EQ(labels("four", "ransac"), labels("one", "ransac"));
  int others = 0;
  for (const std::string seed : {"1", "2", "3"}) {
    EXPECT_EQ(row("four", "rooms", "ransac-seed" + seed).at("errors"), 0);
    if (labels("four", "ransac-seed" + seed) != labels("four", "ransac")) ++others;
  }
  EXPECT_GE(others, 1);
  ASSERT_EQ(run_with("4", "again"), 0);
  EXPECT_EQ(report("again"), report("four"));
  expectFailure({"rooms", "--seeds", "0"}, 2, "--seeds");
  expectFailure({"rooms", "--seeds", "2", "--predictions", "ransac-seed1=x"}, 2, "there are two methods");
}

TEST_F(EvalCommand, NoiseReachesTheMethod) {
  writeFrame("rooms", "f1", 1);
  ASSERT_EQ(run({"rooms", "--methods", "epcc-paper", "--out", "fine"}).exit_code, 0);
  ASSERT_EQ(run({"rooms", "--methods", "epcc-paper", "--out", "coarse", "--noise", "0.2,0.2,1"}).exit_code, 0);
  EXPECT_NE(read("fine/labels/epcc-paper/f1_labels.png"), read("coarse/labels/epcc-paper/f1_labels.png"));
}

}  // namespace
