// SPDX-License-Identifier: BSD-3-Clause
// A little memory for the time when there is no more.
#pragma once

namespace epcc {

/// Sets memory aside, unless some is. It is given back where an allocation finds none, before std::bad_alloc is thrown:
/// what is unwound then may need a little itself and must not throw, as the destructor of a JSON value, and so does
/// saying what was wrong. To be called again once that is done. Never throws.
void reserveMemory() noexcept;

}  // namespace epcc
