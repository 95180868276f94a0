#include "window/key_script.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "window/controls.hpp"

namespace sph {
namespace {

constexpr double kTap = 0.1;  // [s] for which a key without a duration is held

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts = {""};
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::optional<double> ReadSeconds(const std::string& text) {
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(seconds) || seconds < 0)
    return std::nullopt;
  return seconds;
}

std::vector<std::string> KeysOf(const Scene& scene) {
  std::vector<std::string> keys = AllKeyNames();
  for (const SceneControl& control : scene.controls) {
    if (FindControl(control.press) == nullptr) keys.push_back(control.press);
  }
  return keys;
}

}  // namespace

KeyScript::KeyScript(const std::string& text, const Scene& scene) {
  if (text.empty()) return;
  const std::vector<std::string> keys = KeysOf(scene);
  for (const std::string& entry : Split(text, ',')) {
    const auto parts = Split(entry, ':');
    const auto time = ReadSeconds(parts[0]);
    const auto held = parts.size() == 3 ? ReadSeconds(parts[2]) : std::optional<double>(kTap);
    if (parts.size() < 2 || parts.size() > 3 || !time || !held) {
      throw UsageError(
          "--keys: '{}' is not accepted; an entry is T:KEY or T:KEY:SECONDS with T and SECONDS >= 0, such as 4:d",
          entry);
    }
    if (std::find(keys.begin(), keys.end(), parts[1]) == keys.end()) {
      std::string all;
      for (const std::string& key : keys) all += " " + key;
      throw UsageError("--keys: unknown key '{}' in '{}'.{} The keys are:{}", parts[1], entry,
                       DidYouMean(parts[1], keys), all);
    }
    events_.push_back({*time, parts[1], true});
    const Control* control = FindControl(parts[1]);
    if (control != nullptr && control->release != nullptr) events_.push_back({*time + *held, parts[1], false});
  }
  std::stable_sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
}

void KeyScript::Play(Session& session) {
  for (; IsDue(session.System().Time()); ++next_) {
    const Event& event = events_[next_];
    if (event.down) {
      PressKey(session, event.key);
    } else {
      ReleaseKey(session, event.key);
    }
    played_until_ = std::max(played_until_, event.time);
  }
}

bool KeyScript::IsDue(double time) const {
  constexpr double kRoundOff = 1e-9;  // [s], of the sum of the time steps
  return next_ < events_.size() && events_[next_].time <= time + kRoundOff;
}

void KeyScript::Transfer(Archive& archive) {
  archive(played_until_);
  if (!archive.Reading()) return;
  next_ = 0;
  while (next_ < events_.size() && events_[next_].time <= played_until_) ++next_;
}

}  // namespace sph
