// freeglut's key codes as the names that the table of controls and --keys use.
#pragma once

#include <string>

namespace sph {

/// "d" for d and D, "space", "Esc", "Tab", ...; empty for a code that has no name.
std::string NameOfKey(unsigned char code);

/// "Left", "F1", "Home", ... for GLUT_KEY_LEFT and its kin; empty for one that has no name.
std::string NameOfSpecialKey(int code);

}  // namespace sph
