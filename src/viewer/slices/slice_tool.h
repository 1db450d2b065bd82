// What the left mouse button does on a slice.
#pragma once

namespace macula::viewer {

enum class SliceTool { crosshair, window, zoom, pan, distance, angle, ellipse, probe };

}  // namespace macula::viewer
