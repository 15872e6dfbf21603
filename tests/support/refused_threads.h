// SPDX-License-Identifier: BSD-3-Clause
// Runs code where the system refuses to start threads.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <system_error>
#include <thread>

namespace epcc::test {

inline bool threadsAreRefused() {
  try {
    std::thread([] {}).join();
    return false;
  } catch (const std::system_error&) {
    return true;
  }
}

/// True if action() is in a child process that may start no thread. The child gives up the superuser's rights, whom the
/// limit does not bind. To call before this process starts threads of its own: one that is still starting can hold a
/// lock of AddressSanitizer's allocator at the fork, and the child would wait for it for ever. It waits for a minute.
inline bool holdsWithoutThreads(const std::function<bool()>& action) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(60);
    const rlimit none{0, 0};
    const bool limited = ::setrlimit(RLIMIT_NPROC, &none) == 0 && (::geteuid() != 0 || ::setuid(65534) == 0);
    std::_Exit(limited && threadsAreRefused() && action() ? 0 : 1);
  }
  int status = -1;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace epcc::test
