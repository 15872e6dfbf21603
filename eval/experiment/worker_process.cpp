// SPDX-License-Identifier: BSD-3-Clause
// Jobs and answers go through a pair of sockets; an answer is its length, a letter for its kind, and a text.
#include "eval/experiment/worker_process.h"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>

#include "datasets/support/input_error.h"

namespace epcc {

namespace {

constexpr std::size_t kHeadBytes = sizeof(std::uint64_t) + 1;

enum AnswerKind : char { kDone = 'd', kNotWritten = 'w', kNoMemory = 'm', kOtherError = 'e' };

bool sendAll(int socket, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = ::send(socket, bytes, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool sendAnswer(int socket, AnswerKind kind, const std::string& text) {
  const std::uint64_t length = text.size();
  std::string bytes(kHeadBytes, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  bytes.back() = kind;
  bytes += text;
  return sendAll(socket, bytes.data(), bytes.size());
}

/// Until the other side is closed.
void answerJobs(int socket, const WorkerProcess::Work& work) {
  std::uint64_t job = 0;
  while (::recv(socket, &job, sizeof job, MSG_WAITALL) == static_cast<ssize_t>(sizeof job))
    if (!sendAnswer(socket, kDone, work(job))) return;
}

/// The new process's whole life. It leaves without the other's destructors and buffers.
[[noreturn]] void live(int socket, pid_t parent, const std::function<WorkerProcess::Work()>& begin) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) std::_Exit(1);
  try {
    answerJobs(socket, begin());
  } catch (const OutputError& error) {
    sendAnswer(socket, kNotWritten, error.what());
  } catch (const std::bad_alloc&) {
    sendAnswer(socket, kNoMemory, "");
  } catch (const std::exception& error) {
    sendAnswer(socket, kOtherError, error.what());
  }
  std::_Exit(0);
}

}  // namespace

WorkerProcess::WorkerProcess(const std::function<Work()>& begin) {
  int sockets[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
    throw std::runtime_error(std::string("a process cannot be started: ") + std::strerror(errno));
  const pid_t parent = ::getpid();
  process_ = ::fork();
  const int error = errno;
  if (process_ == 0) {
    ::close(sockets[0]);
    live(sockets[1], parent, begin);
  }
  ::close(sockets[1]);
  socket_ = sockets[0];
  if (process_ > 0) return;
  ::close(socket_);
  throw std::runtime_error(std::string("a process cannot be started: ") + std::strerror(error));
}

WorkerProcess::~WorkerProcess() {
  ::close(socket_);
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void WorkerProcess::give(std::uint64_t job) {
  if (!sendAll(socket_, reinterpret_cast<const char*>(&job), sizeof job)) ended_ = true;
}

std::optional<std::string> WorkerProcess::receive() {
  char bytes[4096];
  const ssize_t count = ::recv(socket_, bytes, sizeof bytes, MSG_DONTWAIT);
  if (count > 0) received_.append(bytes, static_cast<std::size_t>(count));
  ended_ = count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR);
  std::uint64_t length = 0;
  if (received_.size() < kHeadBytes) return std::nullopt;
  std::memcpy(&length, received_.data(), sizeof length);
  if (received_.size() - kHeadBytes < length) return std::nullopt;
  const char kind = received_[kHeadBytes - 1];
  const std::string text = received_.substr(kHeadBytes);
  received_.clear();
  if (kind == kNotWritten) throw OutputError(text);
  if (kind == kNoMemory) throw std::bad_alloc();
  if (kind == kOtherError) throw std::runtime_error(text);
  return text;
}

std::string WorkerProcess::howItEnded() {
  int status = 0;
  if (process_ < 0 || ::waitpid(process_, &status, 0) != process_) return "it is not known how";
  process_ = -1;
  if (!WIFSIGNALED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
  return "signal " + std::to_string(WTERMSIG(status)) + ", " + ::strsignal(WTERMSIG(status));
}

}  // namespace epcc
