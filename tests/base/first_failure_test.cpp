#include "base/first_failure.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

namespace sph {
namespace {

TEST(FirstFailure, IsThrownOnceTheThreadsAreDone) {
  FirstFailure failure;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&failure, k] {
      failure.Catch([k] {
        if (k == 2) throw std::runtime_error("the third");
      });
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THROW(failure.Rethrow(), std::runtime_error);
}

TEST(FirstFailure, OfSeveralIsTheFirst) {
  FirstFailure failure;
  failure.Catch([] { throw 1; });
  failure.Catch([] { throw 2.0; });
  EXPECT_THROW(failure.Rethrow(), int);
}

TEST(FirstFailure, IsNoneWhereAllWentWell) {
  FirstFailure failure;
  failure.Catch([] {});
  EXPECT_NO_THROW(failure.Rethrow());
}

}  // namespace
}  // namespace sph
