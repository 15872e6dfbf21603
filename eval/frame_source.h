// SPDX-License-Identifier: BSD-3-Clause
// Where the frames of an experiment come from: the data sets.
#pragma once

#include "datasets/dataset_registry.h"
#include "datasets/frame_source.h"
#include "datasets/labelled_cloud.h"
#include "datasets/native_folder.h"
