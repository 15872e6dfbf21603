// SPDX-License-Identifier: BSD-3-Clause
// Counts the labels of an image and gives them other numbers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epcc {

/// Adds the labels 1 .. label_count to pixels[0 .. label_count). True if there was another one but 0.
bool countLabels(const std::int32_t* labels, std::size_t count, std::int32_t label_count, long* pixels);

/// Each label 0 .. label_count becomes new_label[label], any other one 0.
void changeLabels(std::int32_t* labels, std::size_t count, std::int32_t label_count, const std::int32_t* new_label);

}  // namespace epcc
