// All that a person can choose about how a study is shown, as one value with a JSON text. The state drives
// the window, which saves and opens it as a view. Camera and clips are in patient LPS, mm.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
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
#include "scene/second/second_volume_state.h"
#include "scene/segments/segmentation_settings.h"
#include "scene/state/parameters.h"
#include "slices/colour_table.h"
#include "slices/measurement.h"
#include "slices/sampled_slice.h"

namespace macula::scene {

// The voxel grid that a view was saved with: its camera, clips and measurements refer to these places.
struct SavedGrid {
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};

    bool operator==(const SavedGrid&) const = default;
};

SavedGrid savedGridOf(const Volume& volume);

// Whether the volume has the same size, and each voxel lies within 0.01 mm of its place in `grid`. Images
// that are exported again keep their UIDs, but may have other positions.
bool liesAt(const Volume& volume, const SavedGrid& grid);

// Which panes a study is shown in.
enum class Layout { volume, fourPanes, axial, coronal, sagittal };
inline constexpr std::array kLayouts{Layout::volume, Layout::fourPanes, Layout::axial, Layout::coronal,
                                     Layout::sagittal};

// The name in files.
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
    // None: that of the series. The text of a state omits its explanation.
    std::optional<DisplayWindow> window = {};
    slices::Slab slab = {};
    bool isInverted = false;  // swaps white and black
    bool asAcquired = false;  // in the planes of the acquisition; otherwise in those of the patient
    std::optional<glm::dvec3> crosshairMm = {};  // nothing: the middle of the volume
    // Turns the normals of all three planes about the cross-hair: double oblique planes. A unit quaternion in
    // patient LPS; nothing: the planes are not turned.
    std::optional<glm::dquat> turn = {};
    // Points that a curved plane runs through, in order, patient LPS mm. Fewer than two: no curve.
    std::vector<glm::dvec3> curveMm = {};
    // Shows values in colours; nothing: in grey. A second volume over the study has its own colours.
    std::optional<slices::ColourTable> colours = {};

    bool operator==(const SliceState&) const = default;
};

struct StudyState {
    // LoadedStudy::seriesDigest of the volume. Empty: whichever is open.
    std::string seriesDigest = {};
    // The grid that a saved view was made on; none: any grid of the series.
    std::optional<SavedGrid> grid = {};
    // Null: the default of the volume (presets::defaultTransfer). The preset may ask for a fit to the volume,
    // which is made when it is drawn.
    std::shared_ptr<const TransferFunction> preset = {};
    std::optional<ClipPreset> clip = {};  // nothing: all of the volume is shown
    bool leavesTableOut = false;          // and other objects next to the patient; CT only
    // Nothing: the default lights of the look.
    std::shared_ptr<const trace::LightRig> lights = {};
    // Look, shading and the parameters. Seed and noise threshold belong to a picture, not to a state;
    // `windows` replaces its `window`.
    trace::Settings settings = {.shading = trace::Shading::headlight};
    // The windows that a person set for projections, by look. None: that of the series.
    std::array<std::optional<DisplayWindow>, trace::kLooks.size()> windows = {};
    std::optional<Camera> camera = {};  // nothing: one that fits what is visible
    bool showsMarks = true;             // cube and scale over the picture in 3D
    // The background in 3D. None: nearly black in a window, black in a file.
    std::optional<BackgroundColour> background = {};
    Layout layout = Layout::fourPanes;
    SliceState slices = {};
    std::vector<slices::Measurement> measurements = {};
    Cuts cuts = {};                                        // applied to what the clip leaves
    std::vector<NamedClip> namedClips = {};                // saved for later, not applied
    std::vector<SegmentationSettings> segmentations = {};  // kept in order by `choose`
    std::optional<SecondVolumeState> secondVolume = {};    // nothing: no second volume
    // JSON object of the keys that a newer Macula wrote and this one does not know; toJson writes them back.
    std::string otherKeys = {};

    // Compares by value, preset and lights too.
    bool operator==(const StudyState& b) const;
};

// What a change from `before` to `after` makes stale in the 3D picture: nothing for layout, slices,
// measurements and a second volume that only slices show.
Stale staleAfter(const StudyState& before, const StudyState& after);

// Indented JSON; reading it gives an equal state. Contains no name of a patient, unless a person typed one as
// the name of a preset, clip or lights, or as a label.
std::string toJson(const StudyState& state);

// Error: inputNotUsable; the message names the line or the key, the hint what was expected; the error names
// `where`. Unknown keys of the outermost object are kept.
Result<StudyState> studyStateFromJson(std::string_view text, const std::string& where);

// Reads a saved view. Errors: those of readText and studyStateFromJson.
Result<StudyState> readStudyState(const std::filesystem::path& path);

// Error: inputNotUsable if the state was saved for another series (LoadedStudy::seriesDigest) or for voxels
// at other places than the volume's; the error names `where`.
Result<void> checkSeries(const StudyState& state, std::string_view seriesDigest, const Volume& volume,
                         const std::string& where);

// The outermost keys that toJson(StudyState) writes where there is something to write. A store that updates
// an older text removes those of them that the new text lacks: they are no longer set.
std::vector<std::string> stateKeys();

}  // namespace macula::scene
