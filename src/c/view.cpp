#include "c/view.h"

#include <cmath>
#include <memory>
#include <utility>

#include "c/camera.h"
#include "c/handles.h"
#include "c/last_error.h"
#include "c/sized.h"
#include "c/study.h"
#include "pipeline/trace/look.h"
#include "scene/camera/view_directions.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/study_preset.h"
#include "scene/lights/background_colour.h"

namespace macula::c {

namespace {

std::string textOf(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

// The box as a clip, in fractions of the volume's box.
Result<ClipPreset> boxOf(const Volume& volume, const double* low, const double* high) {
    const Box all = volume.worldBox();
    OrientedBox box;
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(low[axis]) || !std::isfinite(high[axis]) || !(low[axis] < high[axis]))
            return badArgument(Text("The box is none."),
                               Text("Give finite corners in mm, each number of the low one smaller."));
        const double length = all.high[axis] - all.low[axis];
        box.centreMm[axis] = (0.5 * (low[axis] + high[axis]) - all.low[axis]) / length;
        box.halfSizeMm[axis] = 0.5 * (high[axis] - low[axis]) / length;
    }
    ClipPreset preset;
    preset.name = "box";
    preset.clip.box = box;
    MACULA_TRY_VOID(validate(clipFor(preset, volume)));
    return preset;
}

// Calls change(view), which returns a Result<void>.
template <class Change>
macula_status changed(macula_view* view, const Change& change) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<macula_view> of, changing(view));
        return change(*of);
    });
}

}  // namespace

extern "C" {

macula_status macula_view_create(const macula_study* study, macula_view** view) {
    if (view != nullptr) *view = nullptr;
    return guarded([&]() -> Result<void> {
        if (view == nullptr) return nullHandle();
        MACULA_TRY(const Held<const macula_study> of, reading(study));
        auto made = std::make_unique<macula_view>();
        made->study.volume = of->opened.volume;
        made->study.seriesDigest = of->opened.seriesDigest;
        *view = opened(std::move(made));
        return {};
    });
}

macula_status macula_view_set_preset(macula_view* view, const char* preset, std::int32_t fit) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        const std::string named = textOf(preset);
        if (!named.empty()) MACULA_TRY_VOID(scene::presetToDraw(named, fit != 0));
        of.chosen.preset.reset();
        of.request.preset = named;
        of.request.fit = fit != 0;
        return {};
    });
}

macula_status macula_view_set_look(macula_view* view, const char* look) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        if (textOf(look).empty()) {
            of.request.look.reset();
            of.chosen.settings.look = usualState().settings.look;
            return {};
        }
        const auto known = trace::lookNamed(look);
        if (!known)
            return badArgument(Text("There is no such look."),
                               Text("The looks are cinematic, clear, dvr, mip, minip and average."));
        of.request.look = known;
        return {};
    });
}

macula_status macula_view_set_lights(macula_view* view, const char* lights) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        const std::string named = textOf(lights);
        if (!named.empty()) MACULA_TRY_VOID(scene::chooseLights(named));
        of.chosen.lights.reset();
        of.lights = named;
        return {};
    });
}

macula_status macula_view_set_window(macula_view* view, double centre, double width) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        // The limits of states: what can be set can be kept and set again.
        constexpr double kMost = 1e9;
        constexpr double kNarrowest = 1e-9;
        const bool isUsable =
            std::abs(centre) <= kMost && (width == 0.0 || (width >= kNarrowest && width <= kMost));
        if (!isUsable)
            return badArgument(
                Text("The window is not usable."),
                Text("Give a centre of -1e9 to 1e9, and a width of 1e-9 to 1e9, or 0 for the usual one."));
        of.window.reset();
        of.chosen.windows = {};
        if (width > 0.0)
            of.window = DisplayWindow{
                .center = centre, .width = width, .explanation = {}, .function = "LINEAR_EXACT"};
        return {};
    });
}

macula_status macula_view_set_clip(macula_view* view, const char* clip) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        const std::string named = textOf(clip);
        std::optional<ClipPreset> found;
        if (!named.empty()) {
            MACULA_TRY(found, scene::chooseClip(named));
        }
        of.chosen.clip = std::move(found);
        of.chosen.cuts = {};
        return {};
    });
}

macula_status macula_view_set_box(macula_view* view, const double* lowMm, const double* highMm) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        if (lowMm == nullptr || highMm == nullptr) return nullHandle();
        MACULA_TRY(of.chosen.clip, boxOf(*of.study.volume, lowMm, highMm));
        of.chosen.cuts = {};
        return {};
    });
}

macula_status macula_view_remove_table(macula_view* view, std::int32_t remove) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        of.chosen.leavesTableOut = remove != 0;
        return {};
    });
}

macula_status macula_view_set_camera(macula_view* view, const macula_camera* camera) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        if (camera == nullptr) return nullHandle();
        MACULA_TRY(const macula_camera given, taken(camera));
        MACULA_TRY(of.chosen.camera, cameraOf(given));
        of.request.view.reset();
        return {};
    });
}

macula_status macula_view_set_direction(macula_view* view, const char* direction) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        const bool isChosen = !textOf(direction).empty();
        const auto known = isChosen ? scene::viewDirectionOf(direction) : std::nullopt;
        if (isChosen && !known)
            return badArgument(Text("There is no such direction to look from."),
                               Text("They are anterior, posterior, left, right, superior, inferior, oblique, "
                                    "three-quarter and turned."));
        of.request.view = known;
        of.chosen.camera.reset();
        return {};
    });
}

macula_status macula_view_set_background(macula_view* view, const char* background) {
    return changed(view, [&](macula_view& of) -> Result<void> {
        const std::string named = textOf(background);
        std::optional<scene::BackgroundColour> colour;
        if (!named.empty()) {
            const Result<scene::BackgroundColour> known = scene::backgroundOf(named);
            if (!known)
                return badArgument(Text("The background is no colour."),
                                   Text("Give black, white, grey, or red, green and blue as #rrggbb."));
            colour = *known;
        }
        of.chosen.background = colour;
        return {};
    });
}

const char* macula_view_note(const macula_view* view, std::uint32_t index) {
    return textAt(
        view, index, [](const macula_view& of) -> const auto& { return of.notes; });
}

void macula_view_close(macula_view* view) {
    close(view);
}

}  // extern "C"

Result<scene::StudyState> stateOf(const macula_view& view) {
    MACULA_TRY(scene::StudyState state, pictures::stateOf(view.request, view.chosen));
    if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    return state;
}

std::string lightsNamed(const macula_view& view, const scene::StudyState& state) {
    return view.lights.empty() ? std::string(scene::defaultLightsFor(state.settings.look)) : view.lights;
}

Result<SeenView> seenBy(const macula_view& view, scene::StudyState state, Progress& progress) {
    study::LoadedStudy study = view.study;
    SeenView seen;
    MACULA_TRY(seen.preset, pictures::completeState(state, view.request, study));
    // The window of a preset must not replace it.
    if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    MACULA_TRY(seen.shown, scene::shownClip(state, *study.volume, progress));
    seen.state = std::move(state);
    seen.notes = std::move(study.notes);
    seen.notes.insert(seen.notes.end(), seen.shown.notes.begin(), seen.shown.notes.end());
    return seen;
}

}  // namespace macula::c
