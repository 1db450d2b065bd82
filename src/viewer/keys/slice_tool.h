// The action of the left button on a slice.
#pragma once

namespace macula::viewer {

enum class SliceTool { crosshair, window, zoom, pan, distance, angle, ellipse, probe, segment };

constexpr bool measures(SliceTool tool) {
    return tool == SliceTool::distance || tool == SliceTool::angle || tool == SliceTool::ellipse;
}

}  // namespace macula::viewer
