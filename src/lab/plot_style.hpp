// What plots look like: colours that colour-blind readers can tell apart, shapes, sizes.
#pragma once

#include <array>
#include <cstddef>

#include "lab/plot.hpp"

namespace sph {

/// The eight colours of M. Okabe and K. Ito, "Color Universal Design" (2008), ordered for thin lines on white: dark
/// ones first, and no two alike in brightness next to each other. Yellow is too pale for a line and is not used.
constexpr std::array<Colour, 7> kPalette = {{
    {0 / 255.0, 114 / 255.0, 178 / 255.0},    // blue
    {213 / 255.0, 94 / 255.0, 0 / 255.0},     // vermillion
    {0 / 255.0, 158 / 255.0, 115 / 255.0},    // bluish green
    {204 / 255.0, 121 / 255.0, 167 / 255.0},  // reddish purple
    {230 / 255.0, 159 / 255.0, 0 / 255.0},    // orange
    {86 / 255.0, 180 / 255.0, 233 / 255.0},   // sky blue
    {0, 0, 0},
}};
constexpr std::array<Marker, 7> kMarkers = {Marker::kDisk,         Marker::kSquare, Marker::kTriangle, Marker::kDiamond,
                                            Marker::kDownTriangle, Marker::kCross,  Marker::kPlus};

constexpr Colour kInk = {0.1, 0.1, 0.1};          // text, frame
constexpr Colour kFaintInk = {0.35, 0.35, 0.35};  // notes
constexpr Colour kMajorGrid = {0.86, 0.86, 0.86};
constexpr Colour kMinorGrid = {0.94, 0.94, 0.94};
constexpr Colour kNoValueColour = {0.75, 0.75, 0.75};  // of a map
constexpr Colour kWhite = {1, 1, 1};

/// Letters [pixels of a plot of 1200 x 800].
constexpr double kTitleSize = 26;
constexpr double kLabelSize = 25;
constexpr double kTickSize = 22;
constexpr double kLegendSize = 22;
constexpr double kNoteSize = 18;

/// The series at `index` with its colour and marker chosen, and the bands with theirs.
Series Styled(const Plot& plot, std::size_t index);
Colour ColourOf(const Band& band);

/// From dark blue over green to pale yellow, ever brighter: readable in grey and without seeing red. `part` in [0, 1].
/// [D. A. Green 2011, "A colour scheme for the display of astronomical intensity images": the cube helix]
Colour MapColour(double part);

}  // namespace sph
