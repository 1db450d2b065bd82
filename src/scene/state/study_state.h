// All that a person can choose about how a study is shown, as one value with a text. The window is driven by
// it, and saves and opens it as a view. Camera and clips are in patient LPS, mm.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/camera.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/clip_json.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/clip/cuts.h"
#include "scene/lights/background_colour.h"
#include "scene/second/beside_state.h"
#include "scene/segments/segmentation_choice.h"
#include "scene/state/parameters.h"
#include "scene/state/saved_grid.h"
#include "slices/measurement.h"
#include "slices/sampled_slice.h"

namespace macula::app {

// Which panes a study is shown in.
enum class Layout { volume, fourPanes, axial, coronal, sagittal };
inline constexpr std::array kLayouts{Layout::volume, Layout::fourPanes, Layout::axial, Layout::coronal,
                                     Layout::sagittal};

// As in files.
constexpr std::string_view nameOf(Layout layout) {
    switch (layout) {
        case Layout::volume:
            return "volume";
        case Layout::fourPanes:
            return "fourPanes";
        case Layout::axial:
            return "axial";
        case Layout::coronal:
            return "coronal";
        case Layout::sagittal:
            return "sagittal";
    }
    return {};
}

// How slices are shown, the same in all panes.
struct SliceState {
    // Nothing: that of the series. The text of a state keeps all but its explanation.
    std::optional<DisplayWindow> window = {};
    slices::Slab slab = {};
    bool isInverted = false;  // white and black change places
    bool asAcquired = false;  // in the planes of the acquisition; else in those of the patient
    std::optional<glm::dvec3> crosshairMm = {};  // nothing: the middle of the volume

    bool operator==(const SliceState&) const = default;
};

struct StudyState {
    // Which volume: see StudyInput::seriesDigest. Empty: whichever is open.
    std::string seriesDigest = {};
    std::optional<SavedGrid> grid = {};  // of a view that was saved; nothing: whatever the series is of
    // Nothing: what the volume is shown with when nobody chose (presets::defaultTransfer). A fit to the
    // volume is part of it, and is made when it is drawn.
    std::shared_ptr<const TransferFunction> preset = {};
    std::optional<ClipPreset> clip = {};  // nothing: all of the volume is shown
    bool leavesTableOut = false;          // and what else lies beside the patient; of CT
    // Nothing: the default lights of the look.
    std::shared_ptr<const trace::LightRig> lights = {};
    // Look, shading and the parameters. Seed and threshold of noise are of a picture and not of a
    // state; `window` is in `windows`.
    trace::Settings settings = {.shading = trace::Shading::headlight};
    // The windows of projections that somebody set, by look. Nothing: that of the series.
    std::array<std::optional<DisplayWindow>, trace::kLooks.size()> windows = {};
    std::optional<Camera> camera = {};  // nothing: one that fits what is visible
    bool showsMarks = true;             // cube and scale over the picture in 3D
    // Behind the patient in 3D. Nothing: nearly black in a window, black in a file.
    std::optional<BackgroundColour> background = {};
    Layout layout = Layout::fourPanes;
    SliceState slices = {};
    std::vector<slices::Measurement> measurements = {};
    Cuts cuts = {};                                      // of what the clip leaves
    std::vector<NamedClip> namedClips = {};              // to go back to; not shown
    std::vector<SegmentationChoice> segmentations = {};  // kept by `choose`
    std::optional<BesideState> beside = {};              // nothing: no second volume
    // A JSON object of what a newer Macula has written and this one does not know. It is written back.
    std::string otherKeys = {};

    // Compares by value, preset and lights too.
    bool operator==(const StudyState& b) const;
};

// What has to be made again of the picture in 3D when one follows the other: nothing for layout, slices,
// measurements and a second volume that is on slices alone.
Stale staleAfter(const StudyState& before, const StudyState& after);

// Readable text; reading it gives an equal state. Holds no name of a patient: presets, clips and lights that
// a person named may.
std::string toJson(const StudyState& state);

// inputNotUsable: the message tells the line or the key, the hint what was expected. `where` is for the
// error. Of the outermost object keys that are not known are kept.
Result<StudyState> studyStateFromJson(std::string_view text, const std::string& where);

// A view that was saved. Fails as readText and studyStateFromJson.
Result<StudyState> readStudyState(const std::filesystem::path& path);

// inputNotUsable when the state was saved of another series than that (StudyInput::seriesDigest), or of other
// places than those of the volume; `where` is for the error.
Result<void> checkSeries(const StudyState& state, std::string_view seriesDigest, const Volume& volume,
                         const std::string& where);

}  // namespace macula::app
