// A second volume and segments in a picture, as command-line options ask for them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/trace/look.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "scene/second/second_input.h"
#include "scene/second/second_volume_state.h"
#include "scene/segments/segmentation_settings.h"
#include "scene/segments/segments_to_draw.h"
#include "scene/state/study_state.h"
#include "study/open/loaded_study.h"

namespace macula::pictures {

// Empty fields: not given.
struct AdditionRequest {
    std::vector<std::string> segments = {};             // each as segmentRequestFrom takes it
    std::vector<std::filesystem::path> labelMaps = {};  // files with segments (study::openLabelMap)
    scene::SecondVolumeRequest second = {};             // in the same picture; read with the study's options
    bool secondLinkIsGiven = false;
};

// Options that may name a file, for OutputFiles::read.
std::vector<std::filesystem::path> filesOf(const AdditionRequest& request);

// The options together with the segments and second volume of a view.
struct ResolvedAdditions {
    std::vector<scene::SegmentRequest> segments;
    std::vector<std::filesystem::path> labelMaps;
    std::vector<scene::SegmentationSettings> ofView;
    scene::SecondVolumeRequest second;
    std::optional<scene::SecondVolumeState> secondVolume;  // the second volume of the view

    bool needsSegmentations() const;
};

// Checks the options before the study at that path is read. Moves segments and second volume of the view from
// `state` into the choice.
Result<ResolvedAdditions> resolveAdditions(const AdditionRequest& request, const std::filesystem::path& study,
                                           scene::StudyState& state);

struct DrawnAdditions {
    Additions additions;
    std::vector<Text> notes;     // sentences, without patient data
    std::vector<Text> warnings;  // those of the notes that affect what is seen
};

// Makes the additions that `look` draws: for a projection it does not read the second volume. The volume of
// the study must be stored16. Adds the mask of hidden segments to `clip`. Errors: those of segmentsToDraw and
// secondToDraw.
Result<DrawnAdditions> makeAdditions(const ResolvedAdditions& choice, const study::ReadStudy& study,
                                     trace::Look look, Clip& clip, Progress& progress);

}  // namespace macula::pictures
