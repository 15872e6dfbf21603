// SPDX-License-Identifier: BSD-3-Clause
// The pieces of report.html, and what it does with a great many rows.
#include "eval/batch/html_report.h"

#include <gtest/gtest.h>

#include "eval/report/html_page.h"

namespace {

using namespace epcc;

TEST(HtmlPage, Base64OfTheStandard) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(HtmlPage, TablesEscapeWhatWouldBeMarkup) {
  Table table;
  table.columns = {{"a<b", false}, {"median_ms", true}, {"N", true}};
  table.rows = {{"<script>&\"", "1.5"}};
  const std::string text = htmlTable(table);
  EXPECT_NE(text.find("<th>a&lt;b</th>"), std::string::npos) << text;
  EXPECT_NE(text.find("<td>&lt;script&gt;&amp;&quot;</td><td class=\"r time\">1.5</td><td class=\"r\"></td>"),
            std::string::npos)
      << text;
}

TEST(HtmlPage, NoPictureWithoutAFile) {
  EXPECT_EQ(htmlPicture("/nowhere/x.png", "x"), "");
}

FrameRecord record(long frame, long correct, const std::string& error = "") {
  FrameRecord result{"rooms", "f" + std::to_string(frame), "m", {}, {}, error};
  result.measures.paper.surfaces = result.measures.paper.clusters = 10;
  result.measures.segcomp.correct = correct;
  return result;
}

TEST(WorstRows, FewAreAllThereInTheirOrder) {
  WorstRows rows;
  for (const long correct : {5, 1, 9}) rows.add(record(correct, correct));
  const Table table = rows.table();
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0][1] + table.rows[1][1] + table.rows[2][1], "f5f1f9");
  EXPECT_EQ(table.rows[0].size(), table.columns.size());
}

TEST(WorstRows, OfManyTheErrorsAndTheWorstStay) {
  WorstRows rows;
  for (long i = 0; i < 10000; ++i) rows.add(record(i, i % 10));
  rows.add(record(10000, 0, "broken"));
  const Table table = rows.table();
  EXPECT_EQ(rows.count(), 10001U);
  EXPECT_EQ(table.rows.size(), 2000U);
  EXPECT_EQ(table.rows.back()[1], "f10000");
  EXPECT_EQ(table.rows[0][1], "f0");
  EXPECT_EQ(table.rows[1][1], "f1");
  EXPECT_EQ(table.rows[2][1], "f10") << "1000 rows of score 0, then the first 999 of the next";
  const std::string page = htmlReport({}, {}, rows, {}, {"a & b: broken"});
  EXPECT_NE(page.find("The 2000 worst of 10001 rows"), std::string::npos);
  EXPECT_NE(page.find("<li>a &amp; b: broken</li>"), std::string::npos);
}

}  // namespace
