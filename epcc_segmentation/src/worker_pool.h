// SPDX-License-Identifier: BSD-3-Clause
// Threads that wait for work: a frame has a dozen short parallel steps, and to start threads for each takes longer than
// some of them.
#pragma once

#include <functional>

namespace epcc {

/// As onThreads(), on threads that are kept: calls work() on at most `threads` threads, the caller's among them. While
/// somebody else uses them, or in a process that was forked off, it starts threads of its own as onThreads() does.
void onWorkers(int threads, const std::function<void()>& work);

}  // namespace epcc
