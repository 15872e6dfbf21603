// SPDX-License-Identifier: BSD-3-Clause
// Ten million columns: no allocation once the stream is warm, however long it goes on.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <random>

#include "epcc_segmentation/scan_line_stream.h"
#include "tests/support/failing_allocations.h"
#include "tests/support/spinning_scanner.h"

namespace epcc {
namespace {

/// Resident memory of this process, bytes.
std::size_t residentSize() {
  std::ifstream statm("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// What came out of a stream.
struct Count {
  std::int64_t lines = 0, labelled = 0, planes = 0, last_id = 0;
};

void countInto(Count& count, ScanLineStream& stream) {
  stream.onLine([&count](const LabelledLine& line) {
    ++count.lines;
    for (const LabelRun& run : line) count.labelled += run.last - run.first + 1;
  });
  stream.onPlane([&count](const StreamPlane& plane) {
    ++count.planes;
    count.last_id = std::max(count.last_id, plane.id);
  });
}

/// Some turns of a scanner, over and over, each column with the next index. Behind it the room is open.
class EndlessScanner {
 public:
  EndlessScanner() {
    std::mt19937 random(1);
    scanner_.rings = 16;
    scanner_.noise = 0.003;
    for (std::int64_t c = 0; c < 4 * scanner_.columns; ++c) {
      columns_.push_back(scanner_.ranges(c, random));
      if (std::abs(scanner_.azimuth(c)) > 0.5 * M_PI) columns_.back().assign(columns_.back().size(), NAN);
    }
  }
  const test::SpinningScanner& scanner() const { return scanner_; }
  bool add(std::int64_t index, ScanLineStream& stream) const {
    const auto at = static_cast<std::size_t>(index) % columns_.size();
    return stream.addColumn(index, scanner_.azimuth(index), columns_[at].data());
  }

 private:
  test::SpinningScanner scanner_;
  std::vector<std::vector<float>> columns_;
};

TEST(StreamMemory, StaysTheSameOverTenMillionColumns) {
  constexpr std::int64_t kFirst = (std::int64_t{1} << 40);  // far beyond what 32 bits count
  constexpr std::int64_t kWarm = 100000, kColumns = 10000000;
  const EndlessScanner endless;
  StreamOptions options;
  options.sensor = SensorModel::axial(0.003, 0.0);
  ScanLineStream stream(endless.scanner().geometry(), options);
  Count count;
  countInto(count, stream);
  for (std::int64_t i = 0; i < kWarm; ++i) ASSERT_TRUE(endless.add(kFirst + i, stream)) << stream.error();
  const std::size_t resident = residentSize();
  test::forgetAllocations();
  bool all_taken = true;
  for (std::int64_t i = kWarm; i < kColumns; ++i) all_taken = endless.add(kFirst + i, stream) && all_taken;
  EXPECT_EQ(test::largestAllocation(), 0u);
  EXPECT_LT(residentSize(), resident + 1000000);
  EXPECT_TRUE(all_taken);
  ASSERT_TRUE(stream.finish());
  EXPECT_EQ(count.lines, kColumns);
  const std::int64_t turns = kColumns / endless.scanner().columns;
  EXPECT_GE(count.planes, 3 * turns) << "three walls";
  EXPECT_LE(count.planes, 5 * turns);
  EXPECT_EQ(count.last_id, count.planes);
  EXPECT_GT(count.labelled, kColumns * 16 / 3) << "the rest is sky";
}

// Staggered rings wait for their scan lines; whole numbers are turned into metres.
TEST(StreamMemory, StaysTheSameWithStaggeredRingsOfWholeNumbers) {
  std::mt19937 random(1);
  test::SpinningScanner scanner;
  scanner.noise = 0.003;
  for (int ring = 0; ring < scanner.rings; ++ring)
    scanner.ring_azimuths.push_back((ring % 4 * 5 - 7) * scanner.azimuthStep());
  constexpr std::ptrdiff_t kStride = 2;  // every other value of the columns
  std::vector<std::vector<std::uint16_t>> columns;
  for (int c = 0; c < scanner.columns; ++c) {
    columns.emplace_back();
    for (const float range : scanner.ranges(c, random))
      for (int i = 0; i < kStride; ++i)
        columns.back().push_back(std::isnan(range) ? 0 : static_cast<std::uint16_t>(std::lround(range / 0.002f)));
  }
  StreamOptions options;
  options.sensor = SensorModel::axial(0.003, 0.0);
  ScanLineStream stream(scanner.geometry(), options);
  Count count;
  countInto(count, stream);
  std::int64_t index = 0;
  const auto feed = [&](int turns) {
    bool all_taken = true;
    for (std::int64_t end = index + turns * scanner.columns; index < end; ++index) {
      if (index % 1000 >= 990) continue;  // lost
      const auto& column = columns[static_cast<std::size_t>(index % scanner.columns)];
      all_taken = stream.addColumn(index, scanner.azimuth(index), column.data(), kStride, 0.002) && all_taken;
    }
    return all_taken;
  };
  ASSERT_TRUE(feed(50)) << stream.error();
  const std::int64_t warm = count.planes;
  test::forgetAllocations();
  EXPECT_TRUE(feed(100));
  EXPECT_EQ(test::largestAllocation(), 0u);
  EXPECT_GE(count.planes, warm + 400) << "four walls, each turn";
}

// Nothing but clutter, gaps, and one that nobody listens to.
TEST(StreamMemory, StaysTheSameWithoutAPlaneAndWithoutAListener) {
  std::mt19937 random(3);
  const test::SpinningScanner scanner;
  std::vector<std::vector<float>> columns;
  for (int c = 0; c < 500; ++c) {
    columns.emplace_back();
    double range = 5.0;
    for (int ring = 0; ring < scanner.rings; ++ring) {
      if (random() % 12 == 0) range = 1.0 + 0.02 * static_cast<double>(random() % 1000);
      const double noisy = range + 0.0001 * static_cast<double>(random() % 100);
      columns.back().push_back(random() % 20 == 0 ? NAN : static_cast<float>(noisy));
    }
  }
  StreamOptions options;
  options.sensor = SensorModel::axial(0.003, 0.0);
  options.paper.min_segments = 2;
  options.lines_at_once = 3;
  ScanLineStream stream(scanner.geometry(), options);
  std::int64_t index = 0;
  const auto feed = [&](int count) {
    for (int i = 0; i < count; ++i) {
      index += random() % 50 == 0 ? 7 : 1;
      EXPECT_TRUE(stream.addColumn(index, scanner.azimuth(index), columns[random() % columns.size()].data()));
    }
  };
  feed(50000);
  test::forgetAllocations();
  feed(50000);
  EXPECT_EQ(test::largestAllocation(), 0u);
}

TEST(StreamMemory, RunsOutWithAStatus) {
  const EndlessScanner endless;
  StreamOptions options;
  options.sensor = SensorModel::axial(0.003, 0.0);
  int failures = 0;
  for (long allowed = 0; allowed < 400; allowed += 7) {
    ScanLineStream stream(endless.scanner().geometry(), options);
    bool all_taken = true;
    bool happened = false;
    {
      const test::FailingAllocations failing(allowed);
      for (int i = 0; i < 300 && all_taken; ++i) all_taken = endless.add(i, stream);
      happened = failing.happened();
    }
    EXPECT_EQ(all_taken, !happened) << allowed;
    if (all_taken) continue;
    ++failures;
    EXPECT_EQ(stream.status(), Status::OutOfMemory);
    stream.reset();
    for (int i = 0; i < 300; ++i) ASSERT_TRUE(endless.add(i, stream)) << stream.error();
    ASSERT_TRUE(stream.finish());
  }
  EXPECT_GT(failures, 5);
}

}  // namespace
}  // namespace epcc
