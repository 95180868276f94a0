#include "window/key_names.hpp"

#include <GL/freeglut.h>
#include <fmt/format.h>

#include <map>

namespace sph {

std::string NameOfKey(unsigned char code) {
  static const std::map<unsigned char, std::string> names = {{8, "Backspace"}, {9, "Tab"},     {13, "Enter"},
                                                             {27, "Esc"},      {' ', "space"}, {127, "Delete"}};
  if (const auto found = names.find(code); found != names.end()) return found->second;
  if (code < ' ' || code > '~') return {};
  const bool capital = code >= 'A' && code <= 'Z';  // Caps Lock may be on
  return std::string(1, static_cast<char>(capital ? code - 'A' + 'a' : code));
}

std::string NameOfSpecialKey(int code) {
  static const std::map<int, std::string> names = {
      {GLUT_KEY_LEFT, "Left"},      {GLUT_KEY_RIGHT, "Right"},        {GLUT_KEY_UP, "Up"},     {GLUT_KEY_DOWN, "Down"},
      {GLUT_KEY_PAGE_UP, "PageUp"}, {GLUT_KEY_PAGE_DOWN, "PageDown"}, {GLUT_KEY_HOME, "Home"}, {GLUT_KEY_END, "End"},
      {GLUT_KEY_INSERT, "Insert"},  {GLUT_KEY_DELETE, "Delete"}};
  if (const auto found = names.find(code); found != names.end()) return found->second;
  constexpr int kFunctionKeys = 12;
  if (code >= GLUT_KEY_F1 && code < GLUT_KEY_F1 + kFunctionKeys) return fmt::format("F{}", code - GLUT_KEY_F1 + 1);
  return {};
}

}  // namespace sph
