// Pictures joined into one: the panels of a figure, each under its caption.
#pragma once

#include <span>
#include <string>

#include "io/image.hpp"

namespace sph {

/// The picture with a line of text on white above it: letters of 20 pixels, or as small as the picture's width demands.
Image WithCaption(const Image& picture, const std::string& caption);

/// The panels in rows of `columns`, from the top left, with `gap` pixels of grey between them and white where the last
/// row has none. Precondition: at least one panel, all of one size; columns >= 1, gap >= 0.
Image JoinPanels(std::span<const Image> panels, int columns, int gap);

}  // namespace sph
