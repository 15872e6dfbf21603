// SPDX-License-Identifier: BSD-3-Clause
// Silences PCL's console while a method runs.
#pragma once

namespace epcc {

/// PCL prints nothing while one of these exists in any thread; the last one to go restores the old level.
class QuietPcl {
 public:
  QuietPcl();
  ~QuietPcl();
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;
};

}  // namespace epcc
