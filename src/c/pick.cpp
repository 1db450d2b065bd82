// What a person points at in a picture.
#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "c/camera.h"
#include "c/handles.h"
#include "c/last_error.h"
#include "c/pixels.h"
#include "c/sized.h"
#include "c/told_progress.h"
#include "c/view.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/first_matter.h"
#include "scene/drawing/projection_windows.h"

namespace macula::c {

namespace {

Result<Camera> eyeOf(const macula_view& view, const macula_pick& pick) {
    if (pick.camera != nullptr) {
        MACULA_TRY(const macula_camera given, taken(pick.camera));
        return cameraOf(given);
    }
    if (!view.drawnFrom)
        return badArgument(Text("No camera was given, and the view was not drawn yet."),
                           Text("Give the camera of the picture, or draw the view first."));
    return *view.drawnFrom;
}

Result<macula_picked> picked(const macula_view& view, const macula_pick& pick, Progress& progress) {
    MACULA_TRY_VOID(checkSize(pick.width, pick.height));
    if (!(pick.x >= 0.0 && pick.x <= pick.width && pick.y >= 0.0 && pick.y <= pick.height))
        return badArgument(
            Text("The place is not in the picture."),
            Text("Give pixels from its upper left corner, 0 to its width and 0 to its height."));
    MACULA_TRY(const Camera eye, eyeOf(view, pick));
    MACULA_TRY(scene::StudyState state, stateOf(view));
    MACULA_TRY(SeenView seen, seenBy(view, std::move(state), progress));
    MACULA_TRY(const scene::Catalogue catalogue, scene::builtInCatalogue());
    auto clip = seen.shown.clip.isNothing() ? nullptr : std::make_shared<const Clip>(seen.shown.clip);
    const scene::Drawing drawing =
        scene::drawingOf(seen.state, catalogue, scene::SeriesWindows(), view.study.volume, std::move(clip));
    const glm::dvec2 place(2.0 * pick.x / pick.width - 1.0, 1.0 - 2.0 * pick.y / pick.height);
    const std::optional<glm::dvec3> met = scene::firstMatterMm(*view.study.volume, drawing, eye, place,
                                                               double(pick.width) / double(pick.height));
    macula_picked told{};
    if (!met) return told;
    told.is_something = 1;
    for (int axis = 0; axis < 3; ++axis) told.point_mm[axis] = (*met)[axis];
    return told;
}

}  // namespace

extern "C" macula_status macula_view_pick(const macula_view* view, const macula_pick* pick,
                                          const macula_progress* progress, macula_picked* there) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<const macula_view> of, reading(view));
        if (pick == nullptr) return nullHandle();
        MACULA_TRY(const macula_pick asked, taken(pick));
        if (!isSized(there)) return wrongSize(there);
        return withProgress(progress, [&](Progress& to) -> Result<void> {
            MACULA_TRY(const macula_picked told, picked(*of, asked, to));
            give(told, there);
            return {};
        });
    });
}

}  // namespace macula::c
