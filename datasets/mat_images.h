// SPDX-License-Identifier: BSD-3-Clause
// Stacks of images in a MATLAB 7.3 file, which is HDF5; only built where there is HDF5.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "datasets/image.h"

namespace epcc {

/// An open file. HDF5's C library serves one thread at a time: all that touches it here takes one lock.
class MatFile {
 public:
  /// Throws InputError.
  explicit MatFile(const std::string& path);
  MatFile(const MatFile&) = delete;
  MatFile& operator=(const MatFile&) = delete;
  ~MatFile();
  bool has(const std::string& variable) const;
  const std::string& path() const { return path_; }
  std::int64_t id() const { return id_; }

 private:
  std::string path_;
  std::int64_t id_ = -1;
};

/// How a variable lies in the file.
struct MatLayout {
  std::array<unsigned long long, 3> chunk{};  ///< numbers a side, 0 if the variable lies there whole
  unsigned long long element_size = 0;        ///< bytes
  int shuffle = -1, deflate = -1;             ///< place in the order of filters, -1 for none
};

/// A variable height x width x count of numbers. MATLAB's first index runs fastest, so that HDF5 sees count x width x
/// height: every image is stored transposed.
class MatImages {
 public:
  /// The file must outlive the images. InputError if the variable is missing, not of this size, or promises more than
  /// the file can hold.
  MatImages(const MatFile& file, const std::string& variable, int width, int height);
  MatImages(const MatImages&) = delete;
  MatImages& operator=(const MatImages&) = delete;
  ~MatImages();
  std::size_t count() const { return count_; }
  Image<float> readFloats(std::size_t index) const;
  /// InputError for values that are no whole numbers from 0 to 65535.
  LabelImage readLabels(std::size_t index) const;

 private:
  void open(int width, int height);
  void close();
  using Offset = std::array<unsigned long long, 3>;
  // All of these run under the lock; `columns` is the image column after column.
  void readWhole(std::size_t index, std::vector<float>& columns) const;
  void readChunk(std::size_t index, const Offset& offset, std::vector<float>& columns) const;
  std::vector<unsigned char> unpackedChunk(std::size_t index, const Offset& offset) const;
  [[noreturn]] void fail(std::size_t index, const std::string& what) const;

  const MatFile& file_;
  std::string variable_;
  std::int64_t id_ = -1;
  std::size_t count_ = 0;
  int width_, height_;
  MatLayout layout_;
};

}  // namespace epcc
