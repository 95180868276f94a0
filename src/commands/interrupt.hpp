// SIGINT and SIGTERM asked for, not obeyed at once: a command ends where its files are whole.
#pragma once

namespace sph {

/// From now on the two signals only set a flag; a second one ends the program as usual.
void CatchInterrupts();
bool Interrupted();

/// From now on the two signals end the program at once, with the exit code of an interruption: for commands that write
/// no files, and compute for long between two looks.
void EndWhenInterrupted();

}  // namespace sph
