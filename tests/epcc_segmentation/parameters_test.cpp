// SPDX-License-Identifier: BSD-3-Clause
// The parameter table: defaults are valid, each field out of range is named, texts are those of the headers.
#include "epcc_segmentation/parameters.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <locale>
#include <regex>
#include <set>
#include <sstream>

#include "epcc_segmentation/parameter_table.h"

namespace epcc {
namespace {

TEST(Parameters, DefaultsAreValidAndThePapers) {
  const Parameters p;
  EXPECT_EQ(p.validate(), "");
  EXPECT_EQ(Parameters::forPaper().validate(), "");
  EXPECT_EQ(p.paper.expert.lines.minSamples(), 8);
  EXPECT_EQ(p.paper.expert.lines.buffer_samples, 2 * p.paper.expert.lines.minSamples());
  EXPECT_EQ(p.paper.max_gap, 0.15);
  EXPECT_EQ(p.paper.endpoint_weight, EndpointWeight::Printed);
}

TEST(Parameters, EveryFieldOutOfRangeIsNamed) {
  std::set<std::string> names;
  for (const ParameterField& field : parameterFields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name << " twice";
    for (const double value : {field.low - 1.0, field.high + 1.0}) {
      if (!field.choices.empty() && field.high == 1.0) continue;  // a bool holds nothing else
      Parameters p;
      field.set(p, value);
      EXPECT_EQ(field.get(p), value) << field.name;
      EXPECT_EQ(p.validate().rfind(field.name, 0), 0u) << field.name << ": " << p.validate();
    }
    if (field.whole) continue;
    Parameters p;
    field.set(p, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(p.validate().rfind(field.name, 0), 0u) << field.name << ": " << p.validate();
  }
}

// Found by fuzzing: twice the largest min_points, twice, is no whole number that the field can hold.
TEST(Parameters, NumbersThatAFieldCannotHoldAreOutOfRange) {
  for (const ParameterField& field : parameterFields()) {
    if (!field.whole || (!field.choices.empty() && field.high == 1.0)) continue;
    for (const double value : {4e9, -4e9, 1e300, -1e300, std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
      Parameters p;
      field.set(p, value);
      EXPECT_EQ(p.validate().rfind(field.name, 0), 0u) << field.name << '=' << value << ": " << p.validate();
    }
  }
}

TEST(Parameters, RelationsBetweenFieldsAreChecked) {
  Parameters buffer;
  buffer.paper.expert.lines.buffer_samples = 7;
  EXPECT_NE(
      buffer.validate().find("buffer_samples (n_buf) must be at least fit_samples + validation_samples = 8, not 7"),
      std::string::npos);
  Parameters look_back;
  look_back.paper.expert.planes.pair_look_back = 5;
  EXPECT_NE(look_back.validate().find("pair_look_back must be at most look_back = 4, not 5"), std::string::npos);
}

TEST(Parameters, AreSetByName) {
  Parameters p;
  EXPECT_EQ(setParameter("inverse_depth.line_k_max=1.75", p), "");
  EXPECT_EQ(p.inverse_depth.line_k_max, 1.75);
  EXPECT_EQ(setParameter("paper.criterion=c", p), "");
  EXPECT_EQ(p.paper.criterion, PlaneCriterion::PrototypeSegment);
  EXPECT_EQ(setParameter("paper.expert.lines.use_sensor_noise=off", p), "");
  EXPECT_FALSE(p.paper.expert.lines.use_sensor_noise);
  EXPECT_EQ(setParameter("mode=paper", p), "");
  EXPECT_EQ(p.mode, Mode::Paper);
  EXPECT_EQ(p.validate(), "");
}

TEST(Parameters, WrongAssignmentsAreToldAndChangeNothing) {
  const std::pair<const char*, const char*> cases[] = {
      {"line_k_max", "is not NAME=VALUE"},
      {"line_k_max=1", "there is no parameter 'line_k_max'"},
      {"threads=1.5", "threads must be a whole number in [1, 256] threads, not '1.5'"},
      {"threads=0", "threads must be in [1, 256] threads, not 0"},
      {"inverse_depth.line_k_max=wide", "must be a number in (0, 100] sigma_w, not 'wide'"},
      {"inverse_depth.line_k_max=", "must be a number in (0, 100] sigma_w, not ''"},
      {"inverse_depth.line_k_max=nan", "must be a number"},
      {"paper.criterion=e", "must be a | b | c | d, not 'e'"},
      {"paper.criterion=1", "must be a | b | c | d, not '1'"},
  };
  for (const auto& [assignment, problem] : cases) {
    Parameters p;
    EXPECT_NE(setParameter(assignment, p).find(problem), std::string::npos) << setParameter(assignment, p);
    for (const ParameterField& field : parameterFields())
      EXPECT_EQ(field.get(p), field.get(Parameters())) << field.name;
  }
}

TEST(Parameters, AValueIsReadToItsEnd) {
  Parameters p;
  EXPECT_NE(setParameter(std::string("inverse_depth.line_k_max=1\0 and more", 37), p), "");
  EXPECT_NE(setParameter(std::string("threads=2\0", 10), p), "");
  EXPECT_EQ(p.threads, 1);
  EXPECT_EQ(setParameter("inverse_depth.line_k_max= +1.5", p), "");
  EXPECT_EQ(p.inverse_depth.line_k_max, 1.5);
}

class CommaInNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Parameters, AreTheSameInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaInNumbers));
  Parameters p;
  EXPECT_EQ(setParameter("inverse_depth.line_k_max=1.5", p), "");
  EXPECT_EQ(setParameter("inverse_depth.min_points=12345", p), "");
  for (const ParameterField& field : parameterFields()) {
    const std::string text = valueText(field, field.get(p));
    EXPECT_EQ(text.find(','), std::string::npos) << field.name << "=" << text;
    Parameters copy = p;
    EXPECT_EQ(setParameter(std::string(field.name) + "=" + text, copy), "");
    EXPECT_EQ(field.get(copy), field.get(p)) << field.name;
  }
  std::locale::global(before);
}

/// The comment before the last member called `name` that follows `after`, in one line.
std::string commentOf(const std::string& header, const std::string& after, const std::string& name) {
  const std::size_t start = after.empty() ? 0 : header.find("struct " + after + " {");
  if (start == std::string::npos) return "no struct " + after;
  std::smatch member;
  const std::string rest = header.substr(start);
  if (!std::regex_search(rest, member, std::regex("((?: *///[^\n]*\n)+) *[A-Za-z]+ " + name + " = ")))
    return "no member " + name;
  std::string comment = std::regex_replace(member[1].str(), std::regex("\\s*\n?\\s*///\\s*"), " ");
  return std::regex_replace(comment, std::regex("^\\s+|\\s+$"), "");
}

/// What the header must say of a field.
std::string expectedComment(const ParameterField& field) {
  const std::string start =
      std::string(field.meaning) + ". " + rangeText(field) + ", default " + valueText(field, field.get(Parameters()));
  if (!field.choices.empty()) return start + ". " + field.advice + ".";
  return start + ". Raise it if " + field.raise + "; lower it if " + field.lower + ".";
}

std::string contentsOf(const std::string& header) {
  std::ifstream in(std::string(EPCC_INCLUDE_DIR) + "/epcc_segmentation/" + header);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Parameters, HeadersSayWhatTheTableSays) {
  const std::string general = contentsOf("parameters.h");
  const std::string inverse_depth = contentsOf("inverse_depth_parameters.h");
  const std::string paper = contentsOf("paper_parameters.h");
  for (const ParameterField& field : parameterFields()) {
    std::vector<std::string> path;
    std::istringstream words(field.name);
    for (std::string word; std::getline(words, word, '.');) path.push_back(word);
    const std::string& header = path.size() == 1 ? general : path[0] == "paper" ? paper : inverse_depth;
    std::string group = path.size() == 4 ? path[2] : "";
    if (!group.empty()) group[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(group[0])));
    EXPECT_EQ(commentOf(header, group, path.back()), expectedComment(field)) << field.name;
  }
}

}  // namespace
}  // namespace epcc
