// SPDX-License-Identifier: BSD-3-Clause
// HDF5's C library behind one lock; sizes are checked before anything is read.
#include "datasets/mat_images.h"

#include <hdf5.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <new>
#include <vector>

#include "datasets/input_error.h"

namespace epcc {

namespace {

constexpr hsize_t kMostImages = 10 * 1000 * 1000;
constexpr hsize_t kLargestChunk = 256u << 20;  // bytes; HDF5 unpacks whole chunks
constexpr hsize_t kBestCompression = 1040;     // of deflate

std::mutex& libraryMutex() {
  static std::mutex mutex;
  return mutex;
}

using Layout = MatLayout;
using Lock = std::lock_guard<std::mutex>;

/// Closes what it holds.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t id() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void checkType(const std::string& path, const std::string& variable, hid_t dataset) {
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.id());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw InputError(path, variable, "does not hold numbers");
}

void checkSize(const std::string& path, const std::string& variable, hid_t dataset, hsize_t bytes) {
  const hsize_t stored = H5Dget_storage_size(dataset);
  if (stored < bytes / kBestCompression || stored == 0)
    throw InputError(path, variable, "the file is too short for so many images");
}

/// How the numbers lie in the file: whole, or in chunks that may be shuffled and then deflated, as MATLAB writes them.
Layout layoutOf(const std::string& path, const std::string& variable, hid_t dataset, hsize_t element_size) {
  const Handle list(H5Dget_create_plist(dataset), H5Pclose);
  if (H5Pget_external_count(list.id()) > 0) throw InputError(path, variable, "lies in another file");
  Layout layout;
  layout.element_size = element_size;
  if (H5Pget_layout(list.id()) != H5D_CHUNKED) return layout;
  if (H5Pget_chunk(list.id(), 3, layout.chunk.data()) != 3) throw InputError(path, variable, "has damaged chunks");
  hsize_t size = element_size;
  for (const hsize_t side : layout.chunk) {
    if (side == 0 || side > kLargestChunk / size) throw InputError(path, variable, "has too large chunks");
    size *= side;
  }
  const int filters = H5Pget_nfilters(list.id());
  for (int i = 0; i < filters; ++i) {
    std::size_t values = 0;
    unsigned flags = 0, config = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(list.id(), static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &config);
    if (filter == H5Z_FILTER_SHUFFLE && layout.shuffle < 0 && layout.deflate < 0)
      layout.shuffle = i;
    else if (filter == H5Z_FILTER_DEFLATE && layout.deflate < 0)
      layout.deflate = i;
    else
      throw InputError(path, variable, "is packed in a way that MATLAB does not use");
  }
  return layout;
}

}  // namespace

MatFile::MatFile(const std::string& path) : path_(path) {
  inputFileSize(path);
  const Lock lock(libraryMutex());
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are told by what is thrown
  id_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id_ < 0) throw InputError(path, "file", "is not a MATLAB 7.3 (HDF5) file or is damaged");
}

MatFile::~MatFile() {
  const Lock lock(libraryMutex());
  if (id_ >= 0) H5Fclose(id_);
}

bool MatFile::has(const std::string& variable) const {
  const Lock lock(libraryMutex());
  return H5Lexists(id_, variable.c_str(), H5P_DEFAULT) > 0;
}

MatImages::MatImages(const MatFile& file, const std::string& variable, int width, int height)
    : file_(file), variable_(variable), width_(width), height_(height) {
  const Lock lock(libraryMutex());
  try {
    open(width, height);
  } catch (...) {
    close();
    throw;
  }
}

MatImages::~MatImages() {
  const Lock lock(libraryMutex());
  close();
}

void MatImages::close() {
  if (id_ >= 0) H5Dclose(id_);
  id_ = -1;
}

void MatImages::open(int width, int height) {
  const std::string& path = file_.path();
  if (H5Lexists(file_.id(), variable_.c_str(), H5P_DEFAULT) <= 0) throw InputError(path, variable_, "is missing");
  id_ = H5Dopen2(file_.id(), variable_.c_str(), H5P_DEFAULT);
  if (id_ < 0) throw InputError(path, variable_, "is not an array");
  checkType(path, variable_, id_);
  const Handle space(H5Dget_space(id_), H5Sclose);
  std::array<hsize_t, 3> sides{};
  if (H5Sget_simple_extent_ndims(space.id()) != 3 || H5Sget_simple_extent_dims(space.id(), sides.data(), nullptr) != 3)
    throw InputError(path, variable_, "is not a stack of images");
  if (sides[1] != static_cast<hsize_t>(width) || sides[2] != static_cast<hsize_t>(height))
    throw InputError(path, variable_, "is not " + std::to_string(height) + " x " + std::to_string(width) + " x N");
  if (sides[0] < 1 || sides[0] > kMostImages)
    throw InputError(path, variable_, "has not from 1 to " + std::to_string(kMostImages) + " images");
  const Handle type(H5Dget_type(id_), H5Tclose);
  const hsize_t element_size = H5Tget_size(type.id());
  if (element_size < 1 || element_size > 8) throw InputError(path, variable_, "does not hold plain numbers");
  checkSize(path, variable_, id_, sides[0] * sides[1] * sides[2] * element_size);
  layout_ = layoutOf(path, variable_, id_, element_size);
  count_ = static_cast<std::size_t>(sides[0]);
}

void MatImages::fail(std::size_t index, const std::string& what) const {
  throw InputError(file_.path(), variable_, "image " + std::to_string(index + 1) + " " + what);
}

void MatImages::readWhole(std::size_t index, std::vector<float>& columns) const {
  const hsize_t start[3] = {index, 0, 0};
  const hsize_t sides[3] = {1, static_cast<hsize_t>(width_), static_cast<hsize_t>(height_)};
  const Handle space(H5Dget_space(id_), H5Sclose);
  const Handle memory(H5Screate_simple(3, sides, nullptr), H5Sclose);
  if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, sides, nullptr) < 0 ||
      H5Dread(id_, H5T_NATIVE_FLOAT, memory.id(), space.id(), H5P_DEFAULT, columns.data()) < 0)
    fail(index, "cannot be read");
}

/// Unpacked here: HDF5 1.10 reads past the end of a chunk that turns out shorter than it should be.
std::vector<unsigned char> MatImages::unpackedChunk(std::size_t index, const Offset& offset) const {
  const std::size_t size = layout_.chunk[0] * layout_.chunk[1] * layout_.chunk[2] * layout_.element_size;
  hsize_t stored = 0;
  if (H5Dget_chunk_storage_size(id_, offset.data(), &stored) < 0 || stored == 0 || stored > kLargestChunk)
    fail(index, "has a part that is missing or damaged");
  std::vector<unsigned char> bytes(stored), unpacked(size);
  std::uint32_t left_out = 0;
  if (H5Dread_chunk(id_, H5P_DEFAULT, offset.data(), &left_out, bytes.data()) < 0) fail(index, "cannot be read");
  const auto applied = [&](int filter) { return filter >= 0 && (left_out >> filter & 1U) == 0; };
  if (applied(layout_.deflate)) {
    uLongf length = size;
    if (::uncompress(unpacked.data(), &length, bytes.data(), stored) != Z_OK || length != size)
      fail(index, "has a damaged part");
    bytes.swap(unpacked);
  }
  if (bytes.size() != size) fail(index, "has a part of the wrong length");
  if (!applied(layout_.shuffle)) return bytes;
  // First bytes of all numbers, then the second ones, and so on.
  const std::size_t count = size / layout_.element_size;
  unpacked.resize(size);
  for (std::size_t i = 0; i < size; ++i) unpacked[i % count * layout_.element_size + i / count] = bytes[i];
  return unpacked;
}

/// The part of the image that lies in the chunk at `offset`.
void MatImages::readChunk(std::size_t index, const Offset& offset, std::vector<float>& columns) const {
  std::vector<unsigned char> bytes = unpackedChunk(index, offset);
  const auto& chunk = layout_.chunk;
  const std::size_t count = chunk[0] * chunk[1] * chunk[2];
  bytes.resize(count * std::max<std::size_t>(layout_.element_size, sizeof(float)));
  const Handle type(H5Dget_type(id_), H5Tclose);
  if (H5Tconvert(type.id(), H5T_NATIVE_FLOAT, count, bytes.data(), nullptr, H5P_DEFAULT) < 0)
    fail(index, "cannot be converted");
  const auto width = static_cast<hsize_t>(width_), height = static_cast<hsize_t>(height_);
  const hsize_t rows = std::min(chunk[2], height - offset[2]);
  for (hsize_t column = 0; column < std::min(chunk[1], width - offset[1]); ++column)
    std::memcpy(&columns[(offset[1] + column) * height + offset[2]],
                &bytes[sizeof(float) * (((index - offset[0]) * chunk[1] + column) * chunk[2])], sizeof(float) * rows);
}

Image<float> MatImages::readFloats(std::size_t index) const try {
  std::vector<float> columns(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  {
    const Lock lock(libraryMutex());
    const auto& chunk = layout_.chunk;
    if (chunk[0] == 0) {
      readWhole(index, columns);
    } else {
      for (hsize_t x = 0; x < static_cast<hsize_t>(width_); x += chunk[1])
        for (hsize_t y = 0; y < static_cast<hsize_t>(height_); y += chunk[2])
          readChunk(index, {index / chunk[0] * chunk[0], x, y}, columns);
    }
  }
  Image<float> image(width_, height_);
  for (int column = 0; column < width_; ++column)
    for (int row = 0; row < height_; ++row)
      image.at(row, column) =
          columns[static_cast<std::size_t>(column) * static_cast<std::size_t>(height_) + static_cast<std::size_t>(row)];
  return image;
} catch (const std::bad_alloc&) {
  throw InputError(file_.path(), variable_, "needs more memory than there is");
}

// Single precision holds every label.
LabelImage MatImages::readLabels(std::size_t index) const {
  const Image<float> values = readFloats(index);
  LabelImage labels(values.width, values.height);
  for (std::size_t i = 0; i < labels.data.size(); ++i) {
    const float value = values.data[i];
    if (!(value >= 0.0F && value <= static_cast<float>(kIgnoreLabel)) || value != std::floor(value))
      throw InputError(file_.path(), variable_,
                       "image " + std::to_string(index + 1) + " has a value that is no whole number from 0 to 65535");
    labels.data[i] = static_cast<std::uint16_t>(value);
  }
  return labels;
}

}  // namespace epcc
