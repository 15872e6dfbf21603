// SPDX-License-Identifier: BSD-3-Clause
// Keys of the window: each has one meaning, and all are in the help and on the page.
#include "eval/view/view_keys.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/temp_folder.h"

namespace epcc {
namespace {

TEST(ViewKeys, NoKeyHasTwoMeanings) {
  std::map<std::string, int> count;
  for (const ViewKey& key : viewKeys())
    for (const char* name : key.names) EXPECT_EQ(++count[name], 1) << name;
}

TEST(ViewKeys, EveryCommandHasAKey) {
  std::map<ViewCommand, int> count;
  for (const ViewKey& key : viewKeys()) EXPECT_EQ(++count[key.command], 1) << key.shown;
  EXPECT_EQ(count.size(), static_cast<std::size_t>(ViewCommand::Quit) + 1);
}

TEST(ViewKeys, CapitalsAreSmallLettersUnlessTheyMeanSomethingElse) {
  EXPECT_EQ(commandOf("n"), ViewCommand::NextInput);
  EXPECT_EQ(commandOf("N"), ViewCommand::NextInput);
  EXPECT_EQ(commandOf("Right"), ViewCommand::NextInput);
  EXPECT_EQ(commandOf("s"), ViewCommand::NextSensor);
  EXPECT_EQ(commandOf("S"), ViewCommand::PreviousSensor);
  EXPECT_EQ(commandOf("z"), std::nullopt);
  EXPECT_EQ(commandOf("Shift_L"), std::nullopt);
  EXPECT_EQ(commandOf(""), std::nullopt);
}

TEST(ViewKeys, ListsOfKeysAreRead) {
  std::string unknown;
  const auto keys = keysFrom("n,Tab,plus,+", unknown);
  ASSERT_TRUE(keys);
  EXPECT_EQ(*keys, (std::vector<std::string>{"n", "Tab", "plus", "+"}));
  EXPECT_TRUE(keysFrom("", unknown)->empty());
  EXPECT_FALSE(keysFrom("n,zz", unknown));
  EXPECT_EQ(unknown, "zz");
  EXPECT_FALSE(keysFrom("n,,n", unknown));
  EXPECT_EQ(unknown, "");
}

TEST(ViewKeys, HelpAndPageNameAllKeys) {
  const std::string help = keyHelp();
  const std::string page = test::bytesOf(EPCC_DOCS_DIR "/reference/epcc_view.md");
  for (const ViewKey& key : viewKeys()) {
    EXPECT_NE(help.find(std::string(key.shown) + " "), std::string::npos) << key.shown;
    EXPECT_NE(help.find(key.effect), std::string::npos) << key.effect;
    EXPECT_NE(page.find(std::string("| ") + key.shown + " | `" + key.names[0] + "` | " + key.effect + " |"),
              std::string::npos)
        << "| " << key.shown << " | `" << key.names[0] << "` | " << key.effect << " |";
  }
}

}  // namespace
}  // namespace epcc
