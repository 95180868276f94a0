#include "commands/interrupt.hpp"

#include <unistd.h>

#include <csignal>

#include "base/error.hpp"

namespace sph {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void Note(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

/// What stdio has not written yet is lost; exit() may not be called in a signal.
void EndNow(int) { _exit(static_cast<int>(ExitCode::kInterrupted)); }

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, &Note);
  std::signal(SIGTERM, &Note);
}

void EndWhenInterrupted() {
  std::signal(SIGINT, &EndNow);
  std::signal(SIGTERM, &EndNow);
}

bool Interrupted() { return interrupted != 0; }

}  // namespace sph
