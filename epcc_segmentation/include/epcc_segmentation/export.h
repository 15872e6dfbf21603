// SPDX-License-Identifier: BSD-3-Clause
// Marks what a shared library shows; all else is hidden.
#pragma once

#if defined(__GNUC__)
#define EPCC_CORE_EXPORT __attribute__((visibility("default")))
#else
#define EPCC_CORE_EXPORT
#endif
