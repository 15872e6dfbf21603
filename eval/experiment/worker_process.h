// SPDX-License-Identifier: BSD-3-Clause
// A process of its own for work that may have to be ended from outside.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace epcc {

/// Does one job after the other, each a number in and a text out. It ends with the process that made it, however that
/// ends. What is written by the worker's side of a stream, and not flushed, is lost.
class WorkerProcess {
 public:
  using Work = std::function<std::string(std::uint64_t job)>;

  /// `begin` is called in the new process and gives what it does for each job. Throws std::runtime_error where the
  /// system refuses a process.
  explicit WorkerProcess(const std::function<Work()>& begin);
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;
  /// Ends the process, whatever it is doing.
  ~WorkerProcess();

  void give(std::uint64_t job);
  /// Readable, as poll() says, where receive() has something to do.
  int descriptor() const { return socket_; }

  /// Takes what has come. Rethrows what the work threw: an OutputError, std::bad_alloc, or the words of another error.
  /// Nothing as long as the answer is not whole.
  std::optional<std::string> receive();
  /// The process has ended without an answer.
  bool ended() const { return ended_; }
  /// How it ended, once it has: "signal 11, Segmentation fault".
  std::string howItEnded();

 private:
  pid_t process_ = -1;
  int socket_ = -1;
  std::string received_;
  bool ended_ = false;
};

}  // namespace epcc
