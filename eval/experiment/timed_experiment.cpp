// SPDX-License-Identifier: BSD-3-Clause
// One thread waits for all processes: no thread runs while a process is made.
#include "eval/experiment/timed_experiment.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "eval/experiment/in_order.h"
#include "eval/experiment/record_json.h"
#include "eval/experiment/worker_process.h"

namespace epcc {

namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

std::string packed(const std::vector<FrameRecord>& records) {
  Json json = Json::array();
  for (const FrameRecord& record : records) json.push_back(toJson(record));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string tooLong(double seconds) {
  char text[64];
  std::snprintf(text, sizeof text, "takes longer than %g s (--frame-timeout)", seconds);
  return text;
}

class TimedRun {
 public:
  TimedRun(const FrameJobs& jobs, const std::vector<Method>& methods, const ExperimentOptions& options,
           const FrameDone& done, const FrameInOrder& in_order)
      : jobs_(jobs), methods_(methods), options_(options), done_(done), sorter_(in_order) {}
  void run();

 private:
  /// A process and the frame it is at, if any.
  struct Place {
    std::unique_ptr<WorkerProcess> process;
    bool busy = false;
    std::size_t job = 0;
    Clock::time_point deadline;
  };

  WorkerProcess::Work work() const;
  void give(Place& place);
  void wait() const;
  void look(Place& place, Clock::time_point now);
  void unpack(const Place& place, const std::string& answer);
  void lose(Place& place, const std::string& why);

  const FrameJobs& jobs_;
  const std::vector<Method>& methods_;
  const ExperimentOptions& options_;
  const FrameDone& done_;
  InOrder sorter_;
  std::vector<Place> places_;
  std::size_t next_ = 0;
};

/// What a process does: called there.
WorkerProcess::Work TimedRun::work() const {
  const auto segmenters = std::make_shared<Segmenters>(makeSegmenters(methods_));
  return [this, segmenters](std::uint64_t job) {
    const FrameJob frame = jobs_[static_cast<std::size_t>(job)];
    return packed(finishFrame(frame, methods_, *segmenters, options_, done_).records);
  };
}

void TimedRun::give(Place& place) {
  if (place.busy || next_ == jobs_.size()) return;
  if (!place.process) place.process = std::make_unique<WorkerProcess>([this] { return work(); });
  place.busy = true;
  place.job = next_++;
  place.deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.frame_timeout));
  place.process->give(place.job);
}

/// Until a process says something or the first deadline is over.
void TimedRun::wait() const {
  std::vector<pollfd> sockets;
  Clock::time_point first = Clock::time_point::max();
  for (const Place& place : places_) {
    if (!place.busy) continue;
    sockets.push_back({place.process->descriptor(), POLLIN, 0});
    first = std::min(first, place.deadline);
  }
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count();
  constexpr long kMaxMilliseconds = 60000;
  ::poll(sockets.data(), sockets.size(), static_cast<int>(std::clamp<long>(left + 1, 0, kMaxMilliseconds)));
}

void TimedRun::look(Place& place, Clock::time_point now) {
  if (!place.busy) return;
  if (const std::optional<std::string> answer = place.process->receive()) {
    place.busy = false;
    unpack(place, *answer);
  } else if (place.process->ended()) {
    lose(place, "its process ended: " + place.process->howItEnded());
  } else if (now >= place.deadline) {
    lose(place, tooLong(options_.frame_timeout));
  }
}

void TimedRun::unpack(const Place& place, const std::string& answer) {
  const FrameJob job = jobs_[place.job];
  std::vector<FrameRecord> records;
  for (const nlohmann::json& json : nlohmann::json::parse(answer))
    records.push_back(recordFromJson(json, job.source->dataset(), job.source->name(job.index)));
  sorter_.add(place.job, std::move(records));
}

void TimedRun::lose(Place& place, const std::string& why) {
  place.process.reset();
  place.busy = false;
  FrameResult result = failedFrame(jobs_[place.job], methods_, why);
  result.lost = true;
  if (done_) done_(result);
  sorter_.add(place.job, std::move(result.records));
}

void TimedRun::run() {
  places_.resize(std::min<std::size_t>(static_cast<std::size_t>(std::max(options_.jobs, 1)), jobs_.size()));
  const auto any_busy = [&] {
    return std::any_of(places_.begin(), places_.end(), [](const Place& p) { return p.busy; });
  };
  do {
    for (Place& place : places_) give(place);
    if (!any_busy()) return;
    wait();
    const Clock::time_point now = Clock::now();
    for (Place& place : places_) look(place, now);
  } while (true);
}

}  // namespace

void runTimedExperiment(const FrameJobs& jobs, const std::vector<Method>& methods, const ExperimentOptions& options,
                        const FrameDone& done, const FrameInOrder& in_order) {
  TimedRun(jobs, methods, options, done, in_order).run();
}

}  // namespace epcc
