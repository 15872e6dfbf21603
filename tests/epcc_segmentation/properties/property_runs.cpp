// SPDX-License-Identifier: BSD-3-Clause
// How often each property is tried, and from which seed: EPCC_PROPERTY_RUNS and EPCC_PROPERTY_SEED, or all of
// rapidcheck's own settings in RC_PARAMS.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>

#include "tests/epcc_segmentation/properties/property_case.h"
#include "tests/support/sanitized.h"

namespace {

constexpr int kRuns = epcc::test::repeats(400);
constexpr const char* kSeed = "17";  // the same in each run: a test that fails fails again

constexpr int kFatal[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
char last_case[1024] = "no case yet\n";
struct sigaction handlers_before[std::size(kFatal)];

/// Tells the case, then leaves the signal to whom it belonged: it comes again.
void tellCase(int signal) {
  (void)!::write(STDERR_FILENO, last_case, std::strlen(last_case));
  for (std::size_t i = 0; i < std::size(kFatal); ++i)
    if (kFatal[i] == signal) ::sigaction(signal, &handlers_before[i], nullptr);
  if (signal == SIGABRT) ::raise(signal);
}

std::string setting(const char* name, const char* otherwise) {
  const char* const value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

/// rapidcheck reads its settings when the first property is tried.
class PropertyRuns : public testing::Environment {
  void SetUp() override {
    const std::string params = "seed=" + setting("EPCC_PROPERTY_SEED", kSeed) +
                               " max_success=" + setting("EPCC_PROPERTY_RUNS", std::to_string(kRuns).c_str());
    ::setenv("RC_PARAMS", params.c_str(), 0);
    struct sigaction action = {};
    action.sa_handler = tellCase;
    for (std::size_t i = 0; i < std::size(kFatal); ++i) ::sigaction(kFatal[i], &action, &handlers_before[i]);
  }
};

const testing::Environment* const property_runs = testing::AddGlobalTestEnvironment(new PropertyRuns);

}  // namespace

namespace epcc::test {

void noteCase(const std::string& text) {
  const std::string line = "the case: " + text.substr(0, sizeof last_case - 20) + "\n";
  std::copy(line.c_str(), line.c_str() + line.size() + 1, last_case);
}

}  // namespace epcc::test
