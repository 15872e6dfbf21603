// SPDX-License-Identifier: BSD-3-Clause
// What is unwound while there is no memory may need some.
#include "eval/program/memory_reserve.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "tests/support/address_limit.h"

namespace epcc::test {
namespace {

/// All memory that there is, down to the smallest pieces.
class FilledMemory {
 public:
  FilledMemory() {
    for (std::size_t size = 1 << 16; size > kKeptApart; size /= 2) fill(size);
    for (std::size_t size = kKeptApart; size >= sizeof(Piece); size -= sizeof(Piece)) fill(size);
  }
  FilledMemory(const FilledMemory&) = delete;
  FilledMemory& operator=(const FilledMemory&) = delete;
  ~FilledMemory() {
    while (last_ != nullptr) std::free(std::exchange(last_, last_->next));
  }

 private:
  /// The allocator keeps small pieces that were freed for others of their size alone.
  static constexpr std::size_t kKeptApart = 2048;
  struct Piece {
    Piece* next;
  };
  void fill(std::size_t size) {
    while (void* piece = std::malloc(size)) last_ = new (piece) Piece{last_};
  }
  Piece* last_ = nullptr;
};

/// Throws a JSON value away, whose destructor makes a list of what it holds.
void unwindWithoutMemory() {
  std::optional<FilledMemory> filling;  // outlives the value
  const nlohmann::json value = {{"surfaces", {{"a", 1}, {"b", {1, 2, 3}}}}, {"path", {"x", "y"}}};
  filling.emplace();
  const std::string more(100, 'x');
  std::_Exit(static_cast<int>(more.size()));
}

/// In a process of its own, which is ended by what is thrown in a destructor.
[[noreturn]] void runOutOfMemory(int times) {
  AddressLimit limit(16 << 20);
  if (!limit.ok()) std::_Exit(1);
  for (int i = 0; i < times; ++i) {
    reserveMemory();
    try {
      unwindWithoutMemory();
    } catch (const std::bad_alloc&) {
    }
  }
  std::_Exit(0);
}

TEST(MemoryReserve, IsThereForWhatIsUnwound) {
  EPCC_NEED_ADDRESS_LIMIT();
  EXPECT_EXIT(runOutOfMemory(1), testing::ExitedWithCode(0), "");
}

TEST(MemoryReserve, IsThereAgainOnceItIsAskedFor) {
  EPCC_NEED_ADDRESS_LIMIT();
  EXPECT_EXIT(runOutOfMemory(5), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace epcc::test
