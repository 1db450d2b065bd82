// The options of `macula render`.
#pragma once

#include <CLI/App.hpp>

#include "pictures/render_wish.h"

namespace macula::cli {

// Their defaults are what `wish` holds; it must outlive the parsing.
void addRenderOptions(CLI::App& command, app::RenderWish& wish);

}  // namespace macula::cli
