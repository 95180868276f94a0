#include "base/hand_over.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace sph {
namespace {

using Numbers = std::vector<int>;

std::exception_ptr Failure(const char* message) { return std::make_exception_ptr(std::runtime_error(message)); }

TEST(HandOver, HandsOverEverythingInOrderThroughTheSameMemory) {
  HandOver<Numbers> numbers;
  std::vector<int> received;
  std::set<const int*> places;
  std::thread receiver([&] {
    while (const Numbers* slot = numbers.NextFull()) {
      received.push_back(slot->front());
      places.insert(slot->data());
      numbers.Return();
    }
  });
  for (int i = 0; i < 1000; ++i) {
    numbers.NextFree().assign(50, i);
    numbers.Pass();
  }
  numbers.End();
  receiver.join();
  ASSERT_EQ(received.size(), 1000u) << "what was passed before the end is not lost";
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(received[static_cast<std::size_t>(i)], i);
  EXPECT_EQ(places.size(), 2u);
}

TEST(HandOver, HoldsBackWhoFillsFasterThanTheOtherEmpties) {
  HandOver<int, 3> numbers;
  std::atomic<int> passed = 0;
  std::thread filler([&] {
    for (int i = 0; i < 4; ++i) {
      numbers.NextFree() = i;
      ++passed;
      numbers.Pass();
    }
  });
  while (passed < 3) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(passed, 3) << "there are three slots";
  EXPECT_EQ(*numbers.NextFull(), 0);
  numbers.Return();
  filler.join();
  EXPECT_EQ(passed, 4);
}

TEST(HandOver, CarriesAFailureToWhoWaitsForAFreeSlot) {
  HandOver<int> numbers;
  std::thread filler([&] {
    try {
      for (;;) {
        numbers.NextFree() = 1;
        numbers.Pass();
      }
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "the first");
    }
  });
  EXPECT_NE(numbers.NextFull(), nullptr);
  numbers.Fail(Failure("the first"));
  numbers.Fail(Failure("a later one"));
  filler.join();
  EXPECT_EQ(numbers.NextFull(), nullptr) << "nothing is handed over any more";
  EXPECT_THROW(numbers.Check(), std::runtime_error);
}

TEST(HandOver, HasNothingToCheckWhileAllIsWell) {
  HandOver<int> numbers;
  numbers.NextFree() = 7;
  numbers.Pass();
  numbers.End();
  EXPECT_NO_THROW(numbers.Check());
  EXPECT_EQ(*numbers.NextFull(), 7);
  numbers.Return();
  EXPECT_EQ(numbers.NextFull(), nullptr);
}

}  // namespace
}  // namespace sph
