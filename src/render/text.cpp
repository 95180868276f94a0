#include "render/text.hpp"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <vector>

#include "base/check.hpp"
#include "render/colour_map.hpp"
#include "render/draw_list_painter.hpp"
#include "render/fonts.hpp"
#include "render/wrap.hpp"

namespace sph {
namespace {

// What is written on the picture: dark on a light veil; the message, which must be seen, light on dark.
constexpr ImU32 kInk = IM_COL32(24, 24, 24, 255);
constexpr ImU32 kVeil = IM_COL32(255, 255, 255, 215);
constexpr ImU32 kMessageInk = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kMessageVeil = IM_COL32(40, 40, 40, 235);
constexpr ImU32 kHelpVeil = IM_COL32(255, 255, 255, 240);
constexpr ImU32 kFrame = IM_COL32(120, 120, 120, 255);

struct HelpPage {
  std::string title;
  std::vector<HelpRow> rows;
};

/// Where the parts of a help page go [pixels].
struct HelpLayout {
  const ImFont* font = nullptr;
  ImVec2 size = {};
  float title_height = 0;         // with the gap below
  float key_width = 0;            // with the gap beside
  std::vector<std::string> does;  // of each row, wrapped
  std::vector<float> heights;     // of each row, with the gap below
};

ImVec2 SizeOf(const ImFont* font, std::string_view text) {
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size());
  return {std::ceil(size.x), std::ceil(size.y)};
}

std::string WrappedIn(const ImFont* font, std::string_view text, float room) {
  return Wrapped(text, room, [font](std::string_view part) { return static_cast<double>(SizeOf(font, part).x); });
}

void Write(ImDrawList* list, const ImFont* font, ImVec2 at, ImU32 ink, std::string_view text) {
  const ImVec2 whole = {std::round(at.x), std::round(at.y)};  // letters are sharp on whole pixels only
  list->AddText(font, font->FontSize, whole, ink, text.data(), text.data() + text.size());
}

HelpLayout LayOut(const HelpPage& page, const ImFont* font, float room) {
  const float gap = std::round(0.3F * font->FontSize);
  HelpLayout layout;
  layout.font = font;
  for (const HelpRow& row : page.rows) layout.key_width = std::max(layout.key_width, SizeOf(font, row.key).x);
  layout.key_width += 5 * gap;
  const ImVec2 title = SizeOf(font, page.title);
  layout.title_height = title.y + 3 * gap;
  layout.size = {title.x, layout.title_height};
  for (const HelpRow& row : page.rows) {
    layout.does.push_back(WrappedIn(font, row.does, room - layout.key_width));
    const ImVec2 does = SizeOf(font, layout.does.back());
    layout.heights.push_back(std::max(SizeOf(font, row.key).y, does.y) + gap);
    layout.size.x = std::max(layout.size.x, layout.key_width + does.x);
    layout.size.y += layout.heights.back();
  }
  layout.size.y -= gap;
  return layout;
}

}  // namespace

struct TextLayer::State {
  State(const GlFunctions& gl, double scale) : painter(gl), ui_scale(scale) {}

  void MakeFonts();
  /// The usual font, but a smaller one in a window with little room.
  const ImFont* Font() const;
  /// The largest font, from Font() on, in which `text` fits on its lines; else the smallest.
  const ImFont* FontFor(std::string_view text, float room) const;
  /// So many pixels beside letters of 15.
  float Pixels(double beside_15) const { return static_cast<float>(std::round(beside_15 * Font()->FontSize / 15)); }
  float Margin() const { return Pixels(8); }
  float Padding() const { return Pixels(6); }
  float Border() const { return Margin() + Padding(); }

  /// A veil with rounded corners behind what is `size` large and has its top left corner at `at`.
  void DrawVeil(ImDrawList* list, ImVec2 at, ImVec2 size, ImU32 colour) const;
  /// The width of the colour bar and of all that belongs to it; 0 without a legend.
  float LegendWidth() const;
  void DrawLegend(ImDrawList* list) const;
  void DrawStatus(ImDrawList* list) const;
  void DrawMessage(ImDrawList* list) const;
  void DrawHelp(ImDrawList* list) const;

  DrawListPainter painter;
  double ui_scale;
  ImGuiContext* context = nullptr;
  Fonts fonts = {};
  bool in_frame = false;
  ImVec2 window = {};  // [pixels]
  std::string status;
  std::string message;
  std::optional<HelpPage> help;
  std::optional<LegendText> legend;
};

void TextLayer::State::MakeFonts() {
  ImGui::SetCurrentContext(context);
  ImGuiIO& io = ImGui::GetIO();
  fonts = AddFonts(*io.Fonts, ui_scale);
  io.FontDefault = fonts[0];
  painter.UploadFonts(*io.Fonts);
  ImGuiStyle style;
  ImGui::StyleColorsLight(&style);
  style.ScaleAllSizes(static_cast<float>(ui_scale));
  ImGui::GetStyle() = style;
}

const ImFont* TextLayer::State::Font() const {
  const double lines = std::min(window.x, window.y) / ui_scale;
  return fonts[lines >= 400 ? 0 : lines >= 300 ? 1 : 2];
}

const ImFont* TextLayer::State::FontFor(std::string_view text, float room) const {
  for (const ImFont* font : fonts) {
    if (font->FontSize <= Font()->FontSize && SizeOf(font, text).x <= room) return font;
  }
  return fonts.back();
}

void TextLayer::State::DrawVeil(ImDrawList* list, ImVec2 at, ImVec2 size, ImU32 colour) const {
  const float padding = Padding();
  list->AddRectFilled({at.x - padding, at.y - padding}, {at.x + size.x + padding, at.y + size.y + padding}, colour,
                      Pixels(4));
}

float TextLayer::State::LegendWidth() const {
  if (!legend) return 0;
  const float bar = std::min(Pixels(180), std::floor(0.4F * window.x));
  const float labels = SizeOf(Font(), legend->low).x + Pixels(12) + SizeOf(Font(), legend->high).x;
  return std::max({bar, SizeOf(Font(), legend->title).x, labels});
}

void TextLayer::State::DrawLegend(ImDrawList* list) const {
  if (!legend) return;
  const float width = LegendWidth();
  const float line = std::ceil(Font()->FontSize);
  const float bar_height = Pixels(12);
  const float gap = Pixels(3);
  const ImVec2 at = {window.x - Border() - width, Border()};
  DrawVeil(list, at, {width, 2 * line + bar_height + 2 * gap}, kVeil);

  Write(list, Font(), at, kInk, legend->title);
  const float top = at.y + line + gap;
  for (int column = 0; column < static_cast<int>(width); ++column) {
    const Rgb colour = ColourAt((column + 0.5) / width);
    const float left = at.x + static_cast<float>(column);
    list->AddRectFilled({left, top}, {left + 1, top + bar_height},
                        IM_COL32(colour.red, colour.green, colour.blue, 255));
  }
  list->AddRect({at.x, top}, {at.x + width, top + bar_height}, kFrame);
  const float labels = top + bar_height + gap;
  Write(list, Font(), {at.x, labels}, kInk, legend->low);
  Write(list, Font(), {at.x + width - SizeOf(Font(), legend->high).x, labels}, kInk, legend->high);
}

void TextLayer::State::DrawStatus(ImDrawList* list) const {
  if (status.empty()) return;
  const float legend_room = legend ? LegendWidth() + 2 * Border() : 0;
  const float room = window.x - 2 * Border() - legend_room;
  const ImFont* font = FontFor(status, room);
  const std::string text = WrappedIn(font, status, room);
  const ImVec2 at = {Border(), Border()};
  DrawVeil(list, at, SizeOf(font, text), kVeil);
  Write(list, font, at, kInk, text);
}

void TextLayer::State::DrawMessage(ImDrawList* list) const {
  if (message.empty()) return;
  const float room = window.x - 2 * Border();
  const ImFont* font = FontFor(message, room);
  const std::string text = WrappedIn(font, message, room);
  const ImVec2 size = SizeOf(font, text);
  const ImVec2 at = {std::round(0.5F * (window.x - size.x)), window.y - Border() - size.y};
  DrawVeil(list, at, size, kMessageVeil);
  Write(list, font, at, kMessageInk, text);
}

void TextLayer::State::DrawHelp(ImDrawList* list) const {
  if (!help) return;
  const ImVec2 room = {window.x - 2 * (Border() + Padding()), window.y - 2 * (Border() + Padding())};
  HelpLayout layout;
  for (const ImFont* font : fonts) {
    layout = LayOut(*help, font, room.x);
    if (layout.size.y <= room.y) break;
  }
  ImVec2 at = {std::round(0.5F * (window.x - layout.size.x)), std::round(0.5F * (window.y - layout.size.y))};
  const float edge = 2 * Padding();
  const ImVec2 corner = {at.x - edge, at.y - edge};
  const ImVec2 opposite = {at.x + layout.size.x + edge, at.y + layout.size.y + edge};
  list->AddRectFilled(corner, opposite, kHelpVeil, Pixels(4));
  list->AddRect(corner, opposite, kFrame, Pixels(4));
  Write(list, layout.font, at, kInk, help->title);
  at.y += layout.title_height;
  for (std::size_t i = 0; i < help->rows.size(); ++i) {
    Write(list, layout.font, at, kInk, help->rows[i].key);
    Write(list, layout.font, {at.x + layout.key_width, at.y}, kInk, layout.does[i]);
    at.y += layout.heights[i];
  }
}

TextLayer::TextLayer(const GlFunctions& gl, double ui_scale) : state_(std::make_unique<State>(gl, ui_scale)) {
  state_->context = ImGui::CreateContext();
  ImGui::SetCurrentContext(state_->context);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is read or written behind the user's back
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  state_->MakeFonts();
}

TextLayer::~TextLayer() { ImGui::DestroyContext(state_->context); }

double TextLayer::UiScale() const { return state_->ui_scale; }

void TextLayer::SetUiScale(double ui_scale) {
  SPH_CHECK(!state_->in_frame, "within a frame");
  if (ui_scale == state_->ui_scale) return;
  state_->ui_scale = ui_scale;
  state_->MakeFonts();
}

void TextLayer::BeginFrame(int width, int height) {
  ImGui::SetCurrentContext(state_->context);
  if (state_->in_frame) ImGui::EndFrame();  // the last frame was given up halfway
  state_->in_frame = true;
  state_->status.clear();
  state_->message.clear();
  state_->help.reset();
  state_->legend.reset();
  state_->window = {static_cast<float>(width), static_cast<float>(height)};
  ImGui::GetIO().DisplaySize = state_->window;
  ImGui::NewFrame();
}

void TextLayer::StatusLine(std::string_view text) { state_->status = text; }
void TextLayer::Message(std::string_view text) { state_->message = text; }
void TextLayer::Legend(const LegendText& legend) { state_->legend = legend; }
void TextLayer::HelpTable(std::string_view title, std::span<const HelpRow> rows) {
  state_->help = HelpPage{std::string(title), {rows.begin(), rows.end()}};
}

void TextLayer::EndFrame() {
  ImGui::SetCurrentContext(state_->context);
  ImDrawList* below_panels = ImGui::GetBackgroundDrawList();
  state_->DrawLegend(below_panels);
  state_->DrawStatus(below_panels);
  state_->DrawMessage(below_panels);
  state_->DrawHelp(ImGui::GetForegroundDrawList());
  ImGui::Render();
  state_->in_frame = false;
  state_->painter.Draw(*ImGui::GetDrawData());
}

double TextLayer::StatusHeight(int width, int height) const {
  const ImVec2 window = state_->window;
  state_->window = {static_cast<float>(width), static_cast<float>(height)};
  const double size = state_->Margin() + 2 * state_->Padding() + state_->Font()->FontSize;
  state_->window = window;
  return size;
}

double UiScaleFor(int width, int height) { return std::max(1.0, std::min(width, height) / 720.0); }

}  // namespace sph
