// The action of the left button on a slice.
#pragma once

namespace macula::viewer {

enum class SliceTool {
    crosshair,
    window,
    zoom,
    pan,
    distance,
    bidirectional,
    angle,
    cobb,
    ellipse,
    outline,
    line,
    arrow,
    probe,
    segment,
    curve,
};

constexpr bool measures(SliceTool tool) {
    return tool >= SliceTool::distance && tool <= SliceTool::arrow;
}

}  // namespace macula::viewer
