// SPDX-License-Identifier: BSD-3-Clause
// An X display without a screen, for as long as a test lasts.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <string>

namespace epcc::test {

/// In a process that was forked off: it ends when the test's does, whatever becomes of that, and is silent.
inline void becomeHelper() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
}

/// Starts Xvfb on a display that is free. xvfb-run would do the same, but now and then fails to clean up, and returns
/// its own exit code then.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    int ends[2];
    if (::pipe(ends) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
      const std::string writing_end = std::to_string(ends[1]);
      ::close(ends[0]);
      becomeHelper();
      ::execlp("Xvfb", "Xvfb", "-displayfd", writing_end.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
               nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    char digit = 0;  // it writes its number and a new line once it is ready
    while (process_ > 0 && ::read(ends[0], &digit, 1) == 1 && std::isdigit(static_cast<unsigned char>(digit)) != 0)
      number_ += digit;
    ::close(ends[0]);
  }
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  ~VirtualDisplay() {
    if (process_ <= 0) return;
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
  }
  bool exists() const { return !number_.empty(); }
  std::string name() const { return ":" + number_; }
  /// What to put before a command of the shell.
  std::string command() const { return "env DISPLAY=" + name() + " "; }

 private:
  pid_t process_ = -1;
  std::string number_;
};

}  // namespace epcc::test
