// SPDX-License-Identifier: BSD-3-Clause
// An experiment whose frames have a time limit each.
#pragma once

#include "eval/experiment/experiment.h"

namespace epcc {

/// Does all jobs as runExperiment() does, `options.jobs` at a time, each in a process of its own that is ended when its
/// frame takes longer than `options.frame_timeout`: a thread cannot be. Such a frame, and one that ends its process,
/// has an error; the others go on. `done` is called there, for a lost frame here.
void runTimedExperiment(const FrameJobs& jobs, const std::vector<Method>& methods, const ExperimentOptions& options,
                        const FrameDone& done, const FrameInOrder& in_order);

}  // namespace epcc
