# Turns FILES into the C++ source OUTPUT, which defines sph::EmbeddedFile: cmake -DOUTPUT=... -DFILES=a,b -P embed.cmake
string(REPLACE "," ";" FILES "${FILES}")
set(rows "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(SIZE ${file} size)
  file(READ ${file} hex HEX)
  string(REPEAT "." 64 line)
  string(REGEX REPLACE "(${line})" "\\1\n" bytes "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
  string(REPLACE "\n" "\"\n\"" bytes "${bytes}")
  string(APPEND rows "    {\"${name}\", {\n\"${bytes}\", ${size}}},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by src/render/embed.cmake.
#include \"render/embedded.hpp\"

#include <utility>

#include \"base/check.hpp\"

namespace sph {
namespace {

constexpr std::pair<std::string_view, std::string_view> kFiles[] = {
${rows}};

}  // namespace

std::string_view EmbeddedFile(std::string_view name) {
  for (const auto& [file, bytes] : kFiles) {
    if (file == name) return bytes;
  }
  SPH_CHECK(false, \"no embedded file {}\", name);
}

}  // namespace sph
")
