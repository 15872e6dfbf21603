// SPDX-License-Identifier: BSD-3-Clause
// HDF5's C library behind one lock; sizes are checked before anything is read.
#include "datasets/mat_images.h"

#include <hdf5.h>

#include <array>
#include <cmath>
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

/// Chunks, and the filters that unpack them: deflate and shuffle are all that MATLAB writes.
void checkStorage(const std::string& path, const std::string& variable, hid_t dataset, hsize_t bytes,
                  hsize_t element_size) {
  const Handle list(H5Dget_create_plist(dataset), H5Pclose);
  if (H5Pget_external_count(list.id()) > 0) throw InputError(path, variable, "lies in another file");
  if (H5Pget_layout(list.id()) == H5D_CHUNKED) {
    std::array<hsize_t, 3> chunk{};
    if (H5Pget_chunk(list.id(), 3, chunk.data()) != 3) throw InputError(path, variable, "has damaged chunks");
    hsize_t size = element_size;
    for (const hsize_t side : chunk) {
      if (side == 0 || side > kLargestChunk / size) throw InputError(path, variable, "has too large chunks");
      size *= side;
    }
  }
  const hsize_t stored = H5Dget_storage_size(dataset);
  if (stored < bytes / kBestCompression || stored == 0)
    throw InputError(path, variable, "the file is too short for so many images");
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
  checkStorage(path, variable_, id_, sides[0] * sides[1] * sides[2] * element_size, element_size);
  count_ = static_cast<std::size_t>(sides[0]);
}

Image<float> MatImages::readFloats(std::size_t index) const try {
  std::vector<float> columns(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  {
    const Lock lock(libraryMutex());
    const hsize_t start[3] = {index, 0, 0};
    const hsize_t sides[3] = {1, static_cast<hsize_t>(width_), static_cast<hsize_t>(height_)};
    const Handle space(H5Dget_space(id_), H5Sclose);
    const Handle memory(H5Screate_simple(3, sides, nullptr), H5Sclose);
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, sides, nullptr) < 0 ||
        H5Dread(id_, H5T_NATIVE_FLOAT, memory.id(), space.id(), H5P_DEFAULT, columns.data()) < 0)
      throw InputError(file_.path(), variable_, "image " + std::to_string(index + 1) + " cannot be read");
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
