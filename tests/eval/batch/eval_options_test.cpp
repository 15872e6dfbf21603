// SPDX-License-Identifier: BSD-3-Clause
// The command line of epcc_eval: what is understood, and what is refused in one line with exit code 2.
#include "eval/batch/eval_options.h"

#include <sstream>

#include "tests/eval/batch/eval_runner.h"

namespace {

using epcc::EvalOptions;
using epcc::test::EvalToolTest;

EvalOptions parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "epcc_eval");
  EvalOptions options;
  std::ostringstream out, err;
  EXPECT_FALSE(epcc::parseEvalOptions(static_cast<int>(arguments.size()), arguments.data(), options, out, err))
      << err.str();
  return options;
}

using Words = std::vector<std::string>;

TEST(EvalOptions, Defaults) {
  const EvalOptions options = parse({"frames", "more/"});
  EXPECT_EQ(options.datasets, (Words{"frames", "more/"}));
  EXPECT_EQ(options.methods, (Words{"epcc", "epcc-paper", "region-growing", "ransac", "omps"}));
  EXPECT_TRUE(options.predictions.empty());
  EXPECT_EQ(options.noise, "");
  EXPECT_EQ(options.jobs, 1);
  EXPECT_EQ(options.shard.text(), "1/1");
  EXPECT_EQ(options.seeds, 1);
  EXPECT_EQ(options.pictures, 2);
  EXPECT_FALSE(options.strict || options.overlays || options.resume);
}

TEST(EvalOptions, MethodsInTheOrderGiven) {
  EXPECT_EQ(parse({"frames", "--methods", "omps,epcc"}).methods, (Words{"omps", "epcc"}));
  EXPECT_TRUE(parse({"frames", "--methods", "none", "--predictions", "a=b"}).methods.empty());
}

TEST(EvalOptions, PredictionsOneOrSeveralAtOnce) {
  for (const auto& arguments : {std::vector<const char*>{"frames", "--predictions", "a=x/y", "b=c=d"},
                                {"--predictions", "a=x/y", "b=c=d", "frames"},
                                {"--predictions", "a=x/y", "--predictions", "b=c=d", "--jobs", "2", "frames"}}) {
    const EvalOptions options = parse(arguments);
    EXPECT_EQ(options.datasets, (Words{"frames"}));
    ASSERT_EQ(options.predictions.size(), 2U);
    EXPECT_EQ(options.predictions[0].name + " " + options.predictions[0].folder, "a x/y");
    EXPECT_EQ(options.predictions[1].name + " " + options.predictions[1].folder, "b c=d");
  }
}

TEST(EvalOptions, NoiseAndJobs) {
  const EvalOptions options = parse({"frames", "--noise", "0.001,0.002,3", "--jobs", "0"});
  EXPECT_EQ(options.noise, "0.001,0.002,3");
  EXPECT_EQ(parse({"frames", "--noise", "auto"}).noise, "auto");
  EXPECT_GE(options.jobs, 1);
}

TEST(EvalOptions, Input) {
  EXPECT_TRUE(parse({"frames"}).reading.areDefault());
  const auto reading = parse({"frames", "--unit", "mm", "--min-depth", "0.5", "--max-depth", "4", "--invalid", "2047",
                              "--projection", "camera", "--distance"})
                           .reading;
  EXPECT_EQ(reading.unit, 0.001);
  EXPECT_EQ(reading.min_depth, 0.5);
  EXPECT_EQ(reading.max_depth, 4.0);
  EXPECT_EQ(reading.invalid, 2047.0);
  EXPECT_EQ(reading.sensor, epcc::CloudOptions::Sensor::Camera);
  EXPECT_TRUE(reading.is_distance);
}

class EvalUsage : public EvalToolTest {};

TEST_F(EvalUsage, HelpAndVersion) {
  const auto help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word :
       {"--methods", "--predictions", "--noise", "--out", "--jobs", "--strict", "--overlays", "--shard", "--resume",
        "--seeds", "--pictures", "merge", "--unit", "--projection", "--distance"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
  EXPECT_EQ(run({"--version"}).out.rfind("epcc_eval ", 0), 0U);
}

TEST_F(EvalUsage, Refusals) {
  writeFrame("frames", "f");
  expectFailure({}, 2, "name at least one DATASET");
  expectFailure({"frames", "--nonsense"}, 2, "--nonsense");
  expectFailure({"frames", "--methods", "epcc,magic"}, 2, "there is no method 'magic'");
  expectFailure({"frames", "--methods", "epcc,epcc"}, 2, "named twice");
  expectFailure({"frames", "--methods", "none"}, 2, "there is no method to score");
  expectFailure({"frames", "--predictions", "epcc=x"}, 2, "there are two methods 'epcc'");
  expectFailure({"frames", "--predictions", "=x"}, 2, "is not NAME=DIR");
  expectFailure({"frames", "--predictions", "..=x"}, 2, "is not NAME=DIR");
  expectFailure({"frames", "--predictions", "mine="}, 2, "is not NAME=DIR");
  expectFailure({"frames", "--noise", "nothing-known"}, 2, "--noise: ");
  expectFailure({"frames", "--noise", ""}, 2, "--noise: ");
  expectFailure({"frames", "--out", ""}, 2, "--out: the name is empty");
  expectFailure({""}, 2, "the name is empty");
  expectFailure({"native:"}, 3, "native:: folder: has no name");
  expectFailure({"frames", "--noise", "no.json"}, 3, "no.json: file: does not exist");
  expectFailure({"frames", "--jobs", "-1"}, 2, "--jobs");
  expectFailure({"frames", "--jobs", "two"}, 2, "--jobs");
  expectFailure({"frames", "--overlays"}, 2, "--overlays needs --out");
  expectFailure({"frames", "./frames/"}, 2, "two folders called 'frames'");
  EXPECT_FALSE(exists("o"));
}

TEST_F(EvalUsage, OutputsInThePlaceOfInputsAreRefused) {
  writeFrame("frames", "f");
  const auto refused = [this](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> arguments = {"frames", "--methods", "omps", "--out", "o"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectFailure(arguments, 2, words + " would be overwritten");
  };
  refused({"--predictions", "mine=o/labels/../labels/mine"}, "o/labels/../labels/mine");
  refused({"--predictions", "mine=o/labels/omps"}, "o/labels/omps");
  refused({"--predictions", "mine=o/labels/omps/frames"}, "o/labels/omps/frames");
  refused({"--predictions", "mine=p", "yours=./o/labels/mine"}, "./o/labels/mine");
  std::filesystem::create_directories(path("o/labels"));
  std::filesystem::create_directory_symlink(path("frames"), path("o/labels/omps"));
  refused({}, "DATASET: frames");
  expectFailure({"native:frames/.", "--methods", "omps", "--out", "o"}, 2, "native:frames/. would be overwritten");
  std::filesystem::remove(path("o/labels/omps"));
  for (const char* file : {"o/summary.json", "o/run.json", "o/results/frames/000000/000.json"}) {
    write(file, R"({"noise": "0.01,0,1"})");
    refused({"--noise", file}, std::string("--noise: ") + file);
    std::filesystem::remove_all(path("o"));
  }
  write("o/sensor.json", R"({"noise": "0.01,0,1"})");
  EXPECT_EQ(run({"frames", "--methods", "omps", "--out", "o", "--noise", "o/sensor.json"}).exit_code, 0);
}

}  // namespace
