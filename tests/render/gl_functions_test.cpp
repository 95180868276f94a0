// What the OpenGL driver lacks or refuses is said by name.
#include "render/gl_functions.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "headless/context.hpp"
#include "io/trouble.hpp"
#include "render/shader_program.hpp"

namespace sph {
namespace {

TEST(GlFunctions, AMissingOneIsNamed) {
  const auto context = MakeOffscreenContext(Backend::kOsmesa);
  const GlLoader loader = [find = context->Loader()](const char* name) {
    return std::string_view(name) == "glDrawArraysInstanced" ? nullptr : find(name);
  };
  EXPECT_TRUE(Complains([&] { LoadGlFunctions(loader); }, {"glDrawArraysInstanced", "3.3"}));
}

void SayVersion21(GLenum name, GLint* value) { *value = name == GL_MAJOR_VERSION ? 2 : 1; }

TEST(GlFunctions, AnOldVersionIsRefused) {
  const auto context = MakeOffscreenContext(Backend::kOsmesa);
  const GlLoader loader = [find = context->Loader()](const char* name) {
    return std::string_view(name) == "glGetIntegerv" ? reinterpret_cast<void*>(&SayVersion21) : find(name);
  };
  EXPECT_TRUE(Complains([&] { LoadGlFunctions(loader); }, {"version", "3.3"}));
}

TEST(Shader, ThatDoesNotCompileIsNamedWithTheDriversLog) {
  const auto context = MakeOffscreenContext(Backend::kOsmesa);
  const GlFunctions gl = LoadGlFunctions(context->Loader());
  const auto compile = [&] {
    CompileShader(gl, GL_FRAGMENT_SHADER, "broken.frag", "#version 330 core\nvoid main() { no_such_name = 1; }\n");
  };
  EXPECT_TRUE(Complains(compile, {"broken.frag", "no_such_name"}));
}

}  // namespace
}  // namespace sph
