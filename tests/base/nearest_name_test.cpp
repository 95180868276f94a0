// Edit distance is a distance, and the suggested name is one that a slip of the finger explains.
#include "base/nearest_name.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace sph {
namespace {

const std::vector<std::string> kScenes = {"dam-break", "mueller", "mueller-published", "toy-star"};

/// From few letters, so that strings have something in common.
rc::Gen<std::string> Words() { return rc::gen::container<std::string>(rc::gen::element('a', 'b', 'c')); }

/// The recursive definition, without a table.
std::size_t PlainEditDistance(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::size_t replaced = PlainEditDistance(a.substr(1), b.substr(1)) + (a[0] == b[0] ? 0 : 1);
  return std::min({PlainEditDistance(a.substr(1), b) + 1, PlainEditDistance(a, b.substr(1)) + 1, replaced});
}

TEST(EditDistance, OfTheTextbookExamples) {
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(EditDistance("saturday", "sunday"), 3u);
  EXPECT_EQ(EditDistance("", "dam"), 3u);
  EXPECT_EQ(EditDistance("dam", "dam"), 0u);
}

RC_GTEST_PROP(EditDistance, EqualsTheRecursiveDefinition, ()) {
  const auto a = *rc::gen::resize(5, Words());  // the definition takes exponential time
  const auto b = *rc::gen::resize(5, Words());
  RC_ASSERT(EditDistance(a, b) == PlainEditDistance(a, b));
}

RC_GTEST_PROP(EditDistance, IsSymmetricAndObeysTheTriangleInequality, ()) {
  const auto a = *Words();
  const auto b = *Words();
  const auto c = *Words();
  RC_ASSERT(EditDistance(a, b) == EditDistance(b, a));
  RC_ASSERT(EditDistance(a, c) <= EditDistance(a, b) + EditDistance(b, c));
  RC_ASSERT((EditDistance(a, b) == 0) == (a == b));
}

RC_GTEST_PROP(EditDistance, LiesBetweenDifferenceAndMaximumOfTheLengths, ()) {
  const auto a = *Words();
  const auto b = *Words();
  RC_ASSERT(EditDistance(a, b) <= std::max(a.size(), b.size()));
  RC_ASSERT(EditDistance(a, b) + std::min(a.size(), b.size()) >= std::max(a.size(), b.size()));
}

TEST(NearestName, IsWhatTheSlipWasMeantToBe) {
  EXPECT_EQ(NearestName("dambreak", kScenes), "dam-break");
  EXPECT_EQ(NearestName("Toy-Star", kScenes), "toy-star");
  EXPECT_EQ(NearestName("muller", kScenes), "mueller");
  EXPECT_EQ(NearestName("mueller-publisched", kScenes), "mueller-published");
}

TEST(NearestName, IsEmptyWhereNoSlipExplainsTheDifference) {
  EXPECT_EQ(NearestName("waterfall", kScenes), "");
  EXPECT_EQ(NearestName("", kScenes), "");
  EXPECT_EQ(NearestName("dam", {}), "");
  EXPECT_EQ(NearestName("xy", std::vector<std::string>{"ab", "k"}), "") << "nothing of the name was typed";
}

TEST(NearestName, TakesTheEarlierOfTwoThatAreEquallyNear) {
  EXPECT_EQ(NearestName("bat", std::vector<std::string>{"cat", "rat"}), "cat");
  EXPECT_EQ(NearestName("bat", std::vector<std::string>{"rat", "cat"}), "rat");
}

TEST(DidYouMean, IsASentenceOrNothing) {
  EXPECT_EQ(DidYouMean("dam-brake", kScenes), " Did you mean 'dam-break'?");
  EXPECT_EQ(DidYouMean("waterfall", kScenes), "");
}

}  // namespace
}  // namespace sph
