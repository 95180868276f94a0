// Keeps the last good states of a particle system, and goes back to one when a step has broken down.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "particles/particle_system.hpp"

namespace sph {

/// Steps a system, and notes its state every kStepsApart steps. A step that breaks down is undone: the system goes back
/// to the older of the last two states, because what broke it may have begun before the newer, and on with half the
/// step. It may do so `retries` times; then it stops at that state, and its Trouble() says what went wrong after it and
/// which step would hold.
class Guard {
 public:
  /// Noting a state costs about as much as a step or two: a hundredth of what these many do.
  static constexpr long kStepsApart = 128;

  /// The system must live as long. Its state now is the one to go back to.
  Guard(ParticleSystem& system, int retries);

  /// To be called when the system was changed by other means than steps: what was noted before is forgotten, so that
  /// going back never undoes what a user did.
  void Mark();
  /// The same, and all retries are there again.
  void Reset();

  /// ParticleSystem::Step, and going back where it breaks down.
  void Step();
  /// ParticleSystem::ComputeFields; where it finds that the last step has broken down, the system stops at the state to
  /// go back to.
  void ComputeFields();
  /// Puts the system back to the older of the states noted.
  void GoBack();

  /// How often a step was undone and halved since Reset.
  int Retreats() const { return retreats_; }
  /// What the last of these said, and where it led.
  const std::string& LastRetreat() const { return last_retreat_; }
  std::size_t Bytes() const { return noted_[0].state.capacity() + noted_[1].state.capacity(); }

  /// Goes with the system's own Transfer.
  void Transfer(Archive& archive);

 private:
  struct Noted {
    std::vector<std::byte> state;
    double longest_step = 0;  ///< [s], as LargestStep says
    std::string limit;        ///< the one that is closest
  };

  void Note(Noted& noted);
  void Retreat();
  void GiveUp();
  std::string Advice() const;

  ParticleSystem& system_;
  int retries_;
  int retreats_ = 0;
  std::string last_retreat_;
  long next_note_ = 0;          // step
  std::array<Noted, 2> noted_;  // the older first
};

}  // namespace sph
