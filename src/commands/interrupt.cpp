#include "commands/interrupt.hpp"

#include <csignal>

namespace sph {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void Note(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, &Note);
  std::signal(SIGTERM, &Note);
}

bool Interrupted() { return interrupted != 0; }

}  // namespace sph
