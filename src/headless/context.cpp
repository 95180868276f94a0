#include "headless/context.hpp"

#include <array>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "headless/egl.hpp"
#include "headless/osmesa.hpp"

namespace sph {
namespace {

struct BackendRow {
  Backend backend;
  const char* name;
  std::unique_ptr<OffscreenContext> (*make)(const BackendLibraries&);
};

// In the order in which kAuto tries them.
constexpr std::array kBackends = {
    BackendRow{Backend::kOsmesa, "osmesa",
               [](const BackendLibraries& names) { return MakeOsmesaContext(names.osmesa); }},
    BackendRow{Backend::kEgl, "egl", [](const BackendLibraries& names) { return MakeEglContext(names.egl); }},
};

}  // namespace

std::unique_ptr<OffscreenContext> MakeOffscreenContext(Backend backend, const BackendLibraries& libraries) {
  std::string failures;
  for (const BackendRow& row : kBackends) {
    if (backend != Backend::kAuto && backend != row.backend) continue;
    try {
      return row.make(libraries);
    } catch (const TroubleError& error) {
      failures += fmt::format("{}{}", failures.empty() ? "" : "\n", error.what());
    }
  }
  throw TroubleError("{}", failures);
}

std::string DescribeGl(const GlFunctions& gl) {
  const auto* version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
  const auto* renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
  return fmt::format("{}, {}", version == nullptr ? "unknown version" : version,
                     renderer == nullptr ? "unknown renderer" : renderer);
}

std::vector<BackendInfo> FindBackends(const BackendLibraries& libraries) {
  std::vector<BackendInfo> found;
  for (const BackendRow& row : kBackends) {
    BackendInfo info{row.name, false, ""};
    try {
      const auto context = row.make(libraries);
      info.description = DescribeGl(LoadGlFunctions(context->Loader()));
      info.available = true;
    } catch (const TroubleError& error) {
      info.description = error.what();
    }
    found.push_back(std::move(info));
  }
  return found;
}

Backend BackendNamed(std::string_view name) {
  if (name == "auto") return Backend::kAuto;
  std::vector<std::string> names = {"auto"};
  std::string accepted = "auto";
  for (const BackendRow& row : kBackends) {
    if (name == row.name) return row.backend;
    names.emplace_back(row.name);
    accepted += fmt::format(", {}", row.name);
  }
  throw UsageError("back-end '{}': accepted are {}.{}", name, accepted, DidYouMean(name, names));
}

}  // namespace sph
