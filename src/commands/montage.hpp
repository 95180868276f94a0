// Pictures joined into one: the panels of a figure, each under its caption.
#pragma once

#include <span>
#include <string>

#include "io/image.hpp"

namespace sph {

struct Panel {
  Image picture;
  std::string caption;
};

/// The panels in rows of `columns`, from the top left, with thin grey lines between them; the rest of the last row is
/// white. Captions have letters of 20 pixels, fewer where a picture is too narrow for them.
/// Precondition: at least one panel, all pictures of one size; columns >= 1.
Image JoinPanels(std::span<const Panel> panels, int columns);

}  // namespace sph
