#include "base/double_buffer.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <thread>
#include <vector>

namespace sph {
namespace {

TEST(DoubleBuffer, GivesTheLatestAndEachOnce) {
  DoubleBuffer<int> numbers;
  EXPECT_FALSE(numbers.Take()) << "nothing has been published";
  for (const int number : {1, 2, 3}) {
    numbers.Fill() = number;
    numbers.Publish();
  }
  EXPECT_TRUE(numbers.Take());
  EXPECT_EQ(numbers.Front(), 3);
  EXPECT_FALSE(numbers.Take());
  EXPECT_EQ(numbers.Front(), 3) << "it stays until there is something newer";
}

TEST(DoubleBuffer, GivesNothingThatIsHalfFilled) {
  DoubleBuffer<int> numbers;
  numbers.Fill() = 1;
  EXPECT_FALSE(numbers.Take());
  numbers.Publish();
  numbers.Fill() = 2;
  EXPECT_FALSE(numbers.Take()) << "the one that was ready is being filled anew";
  numbers.Publish();
  EXPECT_TRUE(numbers.Take());
  EXPECT_EQ(numbers.Front(), 2);
}

TEST(DoubleBuffer, KeepsThreadsApart) {
  DoubleBuffer<std::vector<int>> numbers;
  std::atomic<bool> done = false;
  std::thread filler([&] {
    for (int i = 1; i <= 20000; ++i) {
      numbers.Fill().assign(100, i);
      numbers.Publish();
    }
    done = true;
  });
  int last = 0;
  std::set<const int*> places;
  while (last < 20000) {
    const bool was_done = done;
    if (!numbers.Take()) {
      ASSERT_FALSE(was_done) << "the last one is not lost";
      continue;
    }
    const std::vector<int>& front = numbers.Front();
    ASSERT_GT(front[0], last) << "never an older one";
    for (const int number : front) ASSERT_EQ(number, front[0]) << "never a mixture";
    last = front[0];
    places.insert(front.data());
  }
  filler.join();
  EXPECT_LE(places.size(), 2u) << "memory is used again";
}

}  // namespace
}  // namespace sph
