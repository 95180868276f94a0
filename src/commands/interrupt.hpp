// SIGINT and SIGTERM asked for, not obeyed at once: a command ends where its files are whole.
#pragma once

namespace sph {

/// From now on the two signals only set a flag; a second one ends the program as usual.
void CatchInterrupts();
bool Interrupted();

}  // namespace sph
