#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/planar/box_keys.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "viewer/planar/image_box.h"
#include "viewer/planar/planar_measuring.h"

namespace macula::viewer {

namespace {

// An unfinished measurement ends first, then the tool, then the images.
void pressEscape(ImageBox& box) {
    if (box.measuring().isDrawing()) return box.measuring().dropDrawing();
    if (box.measuring().tool()) return box.measuring().setTool({});
    Q_EMIT box.closeAsked();
}

bool pressForAll(ImageBox& box, PlanarKey key) {
    if (key == PlanarKey::alone)
        Q_EMIT box.aloneAsked();
    else if (key == PlanarKey::link)
        Q_EMIT box.linkAsked();
    else if (key == PlanarKey::escape)
        pressEscape(box);
    else
        return false;
    return true;
}

bool chooseTool(ImageBox& box, PlanarKey key) {
    using Kind = study::ImageMeasurement::Kind;
    constexpr std::array<std::pair<PlanarKey, std::optional<Kind>>, 5> kTools{
        {{PlanarKey::window, std::nullopt},
         {PlanarKey::distance, Kind::distance},
         {PlanarKey::angle, Kind::angle},
         {PlanarKey::ellipse, Kind::ellipse},
         {PlanarKey::cobb, Kind::cobb}}};
    const auto* tool = std::ranges::find(kTools, key, &std::pair<PlanarKey, std::optional<Kind>>::first);
    if (tool == kTools.end()) return false;
    box.measuring().setTool(tool->second);
    return true;
}

}  // namespace

void pressKey(ImageBox& box, PlanarKey key) {
    constexpr double kZoomOfKey = 1.2;
    if (pressForAll(box, key) || !box.isShown() || chooseTool(box, key)) return;
    PlanarView& view = box.view();
    const QPointF middle(0.5 * view.width(), 0.5 * view.height());
    switch (key) {
        case PlanarKey::play:
            return box.setPlaying(!box.isPlaying());
        case PlanarKey::back:
            return box.stepBy(-1);
        case PlanarKey::forward:
            return box.stepBy(1);
        case PlanarKey::first:
            return box.stepBy(-int(box.place()));
        case PlanarKey::last:
            return box.stepBy(int(box.series().stack->frames.size()));
        case PlanarKey::remove:
            return box.measuring().removeSelected();
        case PlanarKey::label:
            return box.measuring().editLabelOfSelected();
        case PlanarKey::invert:
            return box.pane().invert(!box.display().isInverted);
        case PlanarKey::turn:
            return box.pane().turn(false);
        case PlanarKey::mirror:
            return box.pane().turn(true);
        case PlanarKey::fit:
            return view.fit();
        case PlanarKey::closer:
            return view.zoomBy(kZoomOfKey, middle);
        case PlanarKey::farther:
            return view.zoomBy(1.0 / kZoomOfKey, middle);
        case PlanarKey::overlays:
            return box.pane().showOverlays(!box.pane().shown().overlaysAreShown());
        default:
            return;
    }
}

}  // namespace macula::viewer
