// The options of `macula render`.
#pragma once

#include <CLI/App.hpp>

#include "pictures/render_request.h"

namespace macula::cli {

// Their defaults are what `request` holds; it must outlive the parsing.
void addRenderOptions(CLI::App& command, pictures::RenderRequest& request);

}  // namespace macula::cli
