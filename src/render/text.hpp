// Text over the picture, through Dear ImGui's draw lists: one context that the panel of the window draws in too.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "render/gl_functions.hpp"
#include "render/legend.hpp"

namespace sph {

/// One row of the help table: the key, and what it does.
struct HelpRow {
  std::string key;
  std::string does;
};

/// Everything asked for between BeginFrame and EndFrame is laid out and drawn in EndFrame, over what is there already.
/// Text that is too wide is wrapped, and a help table that is too tall is set smaller. UTF-8; one line each ends with
/// \n.
///
/// The ImGui context is this object's, so widgets may be used between BeginFrame and EndFrame as after ImGui::NewFrame;
/// the window feeds ImGui::GetIO() (mouse, keys, DeltaTime) before BeginFrame.
class TextLayer {
 public:
  /// @param ui_scale  1 for text of 15 pixels; > 0. The GL context must be current, and `gl` outlive this object.
  TextLayer(const GlFunctions& gl, double ui_scale);
  ~TextLayer();
  TextLayer(const TextLayer&) = delete;
  TextLayer& operator=(const TextLayer&) = delete;

  double UiScale() const;
  /// Makes the fonts anew at another scale; not between BeginFrame and EndFrame.
  void SetUiScale(double ui_scale);

  /// Makes this object's ImGui context the current one and starts a frame of width x height pixels.
  void BeginFrame(int width, int height);
  /// Top left. Three spaces part fields, which are kept together when wrapped.
  void StatusLine(std::string_view text);
  /// Bottom centre, for what the user must see.
  void Message(std::string_view text);
  /// Over everything, in the middle, on a translucent panel.
  void HelpTable(std::string_view title, std::span<const HelpRow> rows);
  /// Top right: the colour bar of render/colour_map.hpp with its quantity, unit and end values.
  void Legend(const LegendText& legend);
  void EndFrame();

  /// So many pixels at the top of a window does a status line of one line take, its margins included.
  double StatusHeight(int width, int height) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A UI scale that suits a picture of this size where no screen says one: 1 up to 720 lines, then in proportion.
double UiScaleFor(int width, int height);

}  // namespace sph
