// Pictures joined into one: the panels of a figure.
#pragma once

#include <span>

#include "io/image.hpp"

namespace sph {

/// The panels in rows of `columns`, from the top left, with `gap` pixels of grey between them and white where the last
/// row has none. Precondition: at least one panel, all of one size; columns >= 1, gap >= 0.
Image JoinPanels(std::span<const Image> panels, int columns, int gap);

}  // namespace sph
