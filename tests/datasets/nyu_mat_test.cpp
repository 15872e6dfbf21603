// SPDX-License-Identifier: BSD-3-Clause
// NYU Depth V2's .mat as MATLAB stores it: HDF5 behind 512 bytes of text, images transposed.
#include <gtest/gtest.h>

#include "datasets/dataset_registry.h"
#include "datasets/expect_errors.h"
#include "datasets/nyu_mat.h"
#include "datasets/png_io.h"

#ifdef EPCC_HAVE_HDF5
#include <hdf5.h>

#include <random>
#include <thread>
#endif

namespace epcc::test {
namespace {

class NyuMat : public TempFolderTest {};

TEST_F(NyuMat, FilesAreKnownByTheirNames) {
  std::filesystem::create_directory(path("folder"));
  EXPECT_FALSE(isNyuMat(path("folder")));
  write("folder/nyu_depth_v2_labeled.mat", "x");
  EXPECT_TRUE(isNyuMat(path("folder")));
  EXPECT_TRUE(isNyuMat(path("folder/nyu_depth_v2_labeled.mat")));
  EXPECT_FALSE(isNyuMat(path("folder/none.mat")));
}

#ifndef EPCC_HAVE_HDF5

TEST_F(NyuMat, BuildsWithoutHdf5SaySo) {
  const std::string file = write("a.mat", "x");
  expectInputError([&] { openDataset(file); }, file, "format", "this build has no HDF5");
}

#else

constexpr hsize_t kImages = 3, kWidth = 640, kHeight = 480;

/// A .mat file being written.
class MatWriter {
 public:
  explicit MatWriter(const std::string& path) {
    const hid_t list = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(list, 512);
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, list, H5P_DEFAULT);
    H5Pclose(list);
  }
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;
  ~MatWriter() { H5Fclose(file_); }

  /// Image n is value(n, row, column), stored column after column in deflated chunks.
  template <typename Value>
  void stack(const char* name, hid_t type, const Value& value, hsize_t width = kWidth, bool chunked = true) const {
    const hsize_t sides[3] = {kImages, width, kHeight}, chunk[3] = {2, 50, 70};
    const hid_t space = H5Screate_simple(3, sides, nullptr), list = H5Pcreate(H5P_DATASET_CREATE);
    if (chunked) {
      H5Pset_chunk(list, 3, chunk);
      if (type == H5T_STD_U16LE) H5Pset_shuffle(list);
      H5Pset_deflate(list, 6);
    }
    std::vector<float> values;
    for (hsize_t n = 0; n < kImages; ++n)
      for (hsize_t column = 0; column < width; ++column)
        for (hsize_t row = 0; row < kHeight; ++row)
          values.push_back(
              static_cast<float>(value(static_cast<int>(n), static_cast<int>(row), static_cast<int>(column))));
    const hid_t dataset = H5Dcreate2(file_, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(dataset);
    H5Pclose(list);
    H5Sclose(space);
  }
  /// Promises numbers that were never written.
  void promise(const char* name, hsize_t images) const {
    const hsize_t sides[3] = {images, kWidth, kHeight}, chunk[3] = {1, kWidth, kHeight};
    const hid_t space = H5Screate_simple(3, sides, nullptr), list = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(list, 3, chunk);
    H5Dclose(H5Dcreate2(file_, name, H5T_IEEE_F32LE, space, H5P_DEFAULT, list, H5P_DEFAULT));
    H5Pclose(list);
    H5Sclose(space);
  }

 private:
  hid_t file_;
};

double depthAt(int n, int row, int column) {
  return 1.0 + n + 0.001 * row + 0.0001 * column;
}
int planeAt(int n, int row, int column) {
  return column < 10 + n ? 0 : row < 5 ? 1 : 300;
}

TEST_F(NyuMat, DepthAndPlanesAreTurnedUpright) {
  const std::string file = path("nyu_depth_v2_labeled.mat");
  {
    const MatWriter writer(file);
    writer.stack("depths", H5T_IEEE_F32LE, depthAt);
    writer.stack("planes", H5T_STD_U16LE, planeAt);
  }
  const auto frames = openDataset(folder());
  ASSERT_EQ(frames->size(), kImages);
  EXPECT_EQ(frames->name(2), "nyu_0003");
  const LabelledFrame frame = frames->read(2);
  EXPECT_EQ(frame.depth.width, 640);
  EXPECT_EQ(frame.depth.height, 480);
  EXPECT_FLOAT_EQ(frame.depth.at(100, 200), static_cast<float>(depthAt(2, 100, 200)));
  EXPECT_EQ(frame.labels.at(4, 11), 0);
  EXPECT_EQ(frame.labels.at(4, 12), 1);
  EXPECT_EQ(frame.labels.at(5, 639), 300);
  EXPECT_NEAR(frame.camera.camera.fx, 518.858, 1e-3);
  EXPECT_EQ(frame.camera.noise, "kinect-v1");
  EXPECT_EQ(openDataset("nyu:" + file)->dataset(), "nyu_depth_v2_labeled.mat");
}

TEST_F(NyuMat, WhatWasMeasuredGoesBeforeWhatWasFilledIn) {
  {
    const MatWriter writer(path("nyu_depth_v2_labeled.mat"));
    writer.stack("depths", H5T_IEEE_F32LE, depthAt);
    writer.stack("rawDepths", H5T_IEEE_F32LE, [](int, int row, int) { return row == 0 ? 0.0 : row == 1 ? 10.0 : 2.0; });
  }
  const LabelledFrame frame = openDataset(folder())->read(0);
  EXPECT_EQ(frame.depth.at(0, 3), 0.0F);
  EXPECT_EQ(frame.depth.at(1, 3), 0.0F) << "clamped";
  EXPECT_EQ(frame.depth.at(2, 3), 2.0F);
  EXPECT_TRUE(frame.labels.empty());
}

TEST_F(NyuMat, PlanesBesideTheFileAreNumberedFromOne) {
  {
    const MatWriter writer(path("nyu_depth_v2_labeled.mat"));
    writer.stack("depths", H5T_IEEE_F32LE, depthAt, kWidth, false);
  }
  std::filesystem::create_directory(path("planes"));
  expectInputError([&] { openDataset(folder()); }, path("planes"), "folder", "numbered from 0001");
  writeGray16(path("planes/0002.png"), LabelImage(640, 480, 9));
  const auto frames = openDataset(folder());
  ASSERT_EQ(frames->size(), 1U);
  EXPECT_EQ(frames->name(0), "nyu_0002");
  EXPECT_EQ(frames->read(0).labels.at(0, 0), 9);
  EXPECT_FLOAT_EQ(frames->read(0).depth.at(0, 0), 2.0F);
}

TEST_F(NyuMat, SeveralThreadsMayReadAtOnce) {
  {
    const MatWriter writer(path("nyu_depth_v2_labeled.mat"));
    writer.stack("depths", H5T_IEEE_F32LE, depthAt);
  }
  const auto frames = openDataset(folder());
  std::vector<std::thread> threads;
  std::vector<float> seen(12);
  for (std::size_t t = 0; t < seen.size(); ++t)
    threads.emplace_back([&frames, &seen, t] { seen[t] = frames->read(t % kImages).depth.at(9, 9); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t t = 0; t < seen.size(); ++t)
    EXPECT_FLOAT_EQ(seen[t], static_cast<float>(depthAt(static_cast<int>(t % kImages), 9, 9)));
}

TEST_F(NyuMat, BadFilesAreErrors) {
  const std::string file = write("a.mat", "MATLAB 5.0 MAT-file");
  const auto open = [&] { openDataset(file); };
  expectInputError(open, file, "file", "is not a MATLAB 7.3");
  { const MatWriter writer(file); }
  expectInputError(open, file, "depths", "is missing");
  { MatWriter(file).promise("depths", 3); }
  expectInputError(open, file, "depths", "too short");
  { MatWriter(file).promise("depths", hsize_t{1} << 40); }
  expectInputError(open, file, "depths", "has not from 1 to");
  { MatWriter(file).stack("depths", H5T_IEEE_F32LE, depthAt, 64); }
  expectInputError(open, file, "depths", "is not 480 x 640");
  {
    const MatWriter writer(file);
    writer.stack("depths", H5T_IEEE_F32LE, depthAt);
    writer.stack("planes", H5T_IEEE_F32LE, [](int, int, int) { return 0.5; });
  }
  expectInputError([&] { openDataset(file)->read(0); }, file, "planes", "no whole number");
}

TEST_F(NyuMat, CutFilesAreErrors) {
  const std::string file = path("a.mat");
  {
    const MatWriter writer(file);
    writer.stack("depths", H5T_IEEE_F32LE, depthAt);
  }
  const std::string good = bytesOf(file);
  for (const double share : {0.1, 0.5, 0.9, 0.999}) {
    write("a.mat", good.substr(0, static_cast<std::size_t>(share * static_cast<double>(good.size()))));
    EXPECT_THROW(openDataset(file)->read(2), InputError) << share;
  }
}

// HDF5 1.10 itself reads past the end of chunks that turn out too short.
TEST_F(NyuMat, DamagedFilesAreReadOrRefused) {
  const std::string file = path("a.mat");
  {
    const MatWriter writer(file);
    writer.stack("depths", H5T_IEEE_F32LE, [](int, int, int) { return 2.0; });
  }
  const std::string good = bytesOf(file);
  long refused = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::string bytes = good;
    for (int i = 0; i < 3; ++i) bytes[2500 + random() % (bytes.size() - 2500)] = static_cast<char>(random());
    write("a.mat", bytes);
    try {
      openDataset(file)->read(0);
    } catch (const InputError& error) {
      expectOneLine(error.what());
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

#endif

}  // namespace
}  // namespace epcc::test
