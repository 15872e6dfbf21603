// SPDX-License-Identifier: BSD-3-Clause
// Marks what a shared library shows; all else is hidden.
#pragma once

/// Marks a class or function that the shared libraries export.
#if defined(__GNUC__)
#define EPCC_CORE_EXPORT __attribute__((visibility("default")))
#else
#define EPCC_CORE_EXPORT
#endif
