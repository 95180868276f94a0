#include "headless/context.hpp"

#include <gtest/gtest.h>

#include "headless/target.hpp"
#include "io/scratch.hpp"
#include "io/trouble.hpp"

namespace sph {
namespace {

const BackendLibraries kNone = {{"libsphlab-no-osmesa.so"}, {"libsphlab-no-egl.so"}};

TEST(Backend, ThatIsMissingIsNamedWithItsLibraryAndPackage) {
  EXPECT_TRUE(Complains([] { MakeOffscreenContext(Backend::kOsmesa, kNone); },
                        {"OSMesa", "libsphlab-no-osmesa.so", "No such file", "libosmesa6"}));
  EXPECT_TRUE(Complains([] { MakeOffscreenContext(Backend::kEgl, kNone); }, {"EGL", "libsphlab-no-egl.so", "libegl1"}));
  EXPECT_TRUE(Complains([] { MakeOffscreenContext(Backend::kAuto, kNone); },
                        {"libsphlab-no-osmesa.so", "libosmesa6", "libsphlab-no-egl.so", "libegl1"}));
}

TEST(Backend, WhoseLibraryIsNoneOrAnotherOneIsExplained) {
  const ScratchDirectory scratch;
  const std::string bogus = scratch.Path() / "libOSMesa.so.8";
  std::ofstream(bogus) << "this is not a shared library, whatever its name says";
  EXPECT_TRUE(Complains([&] { MakeOffscreenContext(Backend::kOsmesa, {{bogus}, {}}); }, {bogus.c_str(), "libosmesa6"}));
  EXPECT_TRUE(Complains(
      [] {
        MakeOffscreenContext(Backend::kOsmesa, {{"libm.so.6"}, {}});
      },
      {"libm.so.6", "OSMesa", "libosmesa6"}));
  EXPECT_TRUE(Complains([] { MakeOffscreenContext(Backend::kEgl, {{}, {"libm.so.6"}}); }, {"libm.so.6", "eglBindAPI"}));
}

TEST(Backend, IsTriedUnderEachNameInTurn) {
  const BackendLibraries second = {{"libsphlab-no-osmesa.so", "libOSMesa.so.8"}, {}};
  EXPECT_EQ(MakeOffscreenContext(Backend::kOsmesa, second)->Name(), "osmesa");
}

TEST(Backend, LeftToChooseIsOsmesaThenEgl) {
  EXPECT_EQ(MakeOffscreenContext(Backend::kAuto)->Name(), "osmesa");
  const BackendLibraries only_egl = {kNone.osmesa, BackendLibraries().egl};
  EXPECT_EQ(MakeOffscreenContext(Backend::kAuto, only_egl)->Name(), "egl");
}

TEST(Backend, GivesOpenGl33OrLater) {
  for (const Backend backend : {Backend::kOsmesa, Backend::kEgl}) {
    const auto context = MakeOffscreenContext(backend);
    EXPECT_NO_THROW(LoadGlFunctions(context->Loader())) << context->Name();
  }
}

TEST(Backends, AreListedWithVersionOrReason) {
  for (const BackendInfo& backend : FindBackends()) {
    EXPECT_TRUE(backend.available) << backend.name << ": " << backend.description;
    EXPECT_NE(backend.description.find("Core Profile"), std::string::npos) << backend.description;
  }
  const std::vector<BackendInfo> none = FindBackends(kNone);
  ASSERT_EQ(none.size(), 2U);
  EXPECT_EQ(none[0].name, "osmesa");
  EXPECT_EQ(none[1].name, "egl");
  for (const BackendInfo& backend : none) {
    EXPECT_FALSE(backend.available);
    EXPECT_NE(backend.description.find("package"), std::string::npos) << backend.description;
  }
}

TEST(Backends, HaveNames) {
  EXPECT_EQ(BackendNamed("auto"), Backend::kAuto);
  EXPECT_EQ(BackendNamed("osmesa"), Backend::kOsmesa);
  EXPECT_EQ(BackendNamed("egl"), Backend::kEgl);
  EXPECT_TRUE(Complains<UsageError>([] { BackendNamed("osmessa"); }, {"osmessa", "auto, osmesa, egl", "'osmesa'?"}));
}

TEST(OffscreenTarget, OfAnImpossibleSizeIsRefusedWithTheLimit) {
  const auto context = MakeOffscreenContext(Backend::kOsmesa);
  const GlFunctions gl = LoadGlFunctions(context->Loader());
  EXPECT_TRUE(Complains([&] { OffscreenTarget(gl, 1'000'000, 10); }, {"1000000 x 10", "to "}));
  EXPECT_TRUE(Complains([&] { OffscreenTarget(gl, 10, 0); }, {"10 x 0"}));
}

}  // namespace
}  // namespace sph
