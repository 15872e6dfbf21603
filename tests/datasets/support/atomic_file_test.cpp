// SPDX-License-Identifier: BSD-3-Clause
// What processes that were killed while writing have left is removed, and nothing else.
#include "datasets/support/atomic_file.h"

#include "tests/support/temp_folder.h"

namespace epcc::test {
namespace {

class Temporaries : public TempFolderTest {
 protected:
  void SetUp() override {
    TempFolderTest::SetUp();
    for (const char* file : {".epcc-1-2.tmp", "report.tmp", ".epcc-lock", "below/.epcc-3.tmp", "below/result.json"})
      write(file, "x");
  }
};

TEST_F(Temporaries, AreRemovedInTheFolder) {
  removeTemporaries(folder(), false);
  EXPECT_EQ(names(), (std::vector<std::string>{".epcc-lock", "below", "report.tmp"}));
  EXPECT_EQ(names("below"), (std::vector<std::string>{".epcc-3.tmp", "result.json"}));
}

TEST_F(Temporaries, AreRemovedBelowTooIfAsked) {
  removeTemporaries(folder(), true);
  EXPECT_EQ(names("below"), std::vector<std::string>{"result.json"});
}

TEST_F(Temporaries, NoFolderIsNoError) {
  removeTemporaries(path("nowhere"), true);
  EXPECT_EQ(names().size(), 4U);
}

}  // namespace
}  // namespace epcc::test
