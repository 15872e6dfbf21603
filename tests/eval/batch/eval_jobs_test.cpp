// SPDX-License-Identifier: BSD-3-Clause
// epcc_eval with several frames at a time.
#include "tests/eval/batch/eval_runner.h"

namespace {

namespace fs = std::filesystem;
using EvalJobs = epcc::test::EvalToolTest;

TEST_F(EvalJobs, DoNotChangeTheResults) {
  for (unsigned i = 0; i < 5; ++i) writeFrame("rooms", "f" + std::to_string(i), i);
  write("rooms/f2_depth.png", "broken");
  ASSERT_EQ(run({"rooms", "--out", "one", "--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(run({"rooms", "--out", "two", "--jobs", "2"}).exit_code, 0);
  EXPECT_EQ(report("one"), report("two"));
  std::size_t images = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path("one/labels"))) {
    if (!entry.is_regular_file()) continue;
    const std::string relative = fs::relative(entry.path(), path("one")).string();
    EXPECT_EQ(read("one/" + relative), read("two/" + relative)) << relative;
    ++images;
  }
  EXPECT_EQ(images, 20U);
}

}  // namespace
