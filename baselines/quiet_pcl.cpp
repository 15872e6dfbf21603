// SPDX-License-Identifier: BSD-3-Clause
// PCL's verbosity is one variable of the whole program: a counter guards it.
#include "baselines/quiet_pcl.h"

#include <pcl/console/print.h>

#include <mutex>

namespace epcc {

namespace {

std::mutex mutex;
int holders = 0;
pcl::console::VERBOSITY_LEVEL level_before = pcl::console::L_INFO;

}  // namespace

QuietPcl::QuietPcl() {
  const std::lock_guard<std::mutex> lock(mutex);
  if (holders++ > 0) return;
  level_before = pcl::console::getVerbosityLevel();
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
}

QuietPcl::~QuietPcl() {
  const std::lock_guard<std::mutex> lock(mutex);
  if (--holders == 0) pcl::console::setVerbosityLevel(level_before);
}

}  // namespace epcc
