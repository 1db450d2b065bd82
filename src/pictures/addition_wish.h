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
#include "scene/second/beside_state.h"
#include "scene/second/second_input.h"
#include "scene/segments/segmentation_choice.h"
#include "scene/segments/segments_to_draw.h"
#include "scene/state/study_state.h"
#include "study/open/read_study.h"

namespace macula::app {

// Empty fields: not given.
struct AdditionWish {
    std::vector<std::string> segments = {};  // each as segmentWishFrom takes it
    SecondWish second = {};                  // drawn in the same picture; scanned as the study is
    bool secondLinkIsGiven = false;
};

// Options that may name a file, for OutputFiles::read.
std::vector<std::filesystem::path> filesOf(const AdditionWish& wish);

// The options together with the segments and second volume of a view.
struct AdditionChoice {
    std::vector<SegmentWish> segments;
    std::vector<SegmentationChoice> ofView;
    SecondWish second;
    std::optional<BesideState> beside;  // of the view

    bool needsSegmentations() const;
};

// Checks the options before the study at that path is read. Moves segments and second volume of the view from
// `state` into the choice.
Result<AdditionChoice> additionChoice(const AdditionWish& wish, const std::filesystem::path& study,
                                      StudyState& state);

struct MadeAdditions {
    Additions additions;
    std::vector<std::string> notes;     // sentences, without patient data
    std::vector<std::string> warnings;  // those notes that change what is seen
};

// Makes the additions that `look` draws: for a projection it does not read the second volume. The volume of
// the study must be stored16. Adds the mask of hidden segments to `clip`. Errors: those of segmentsToDraw and
// secondToDraw.
Result<MadeAdditions> makeAdditions(const AdditionChoice& choice, const ReadStudy& study, trace::Look look,
                                    Clip& clip, Progress& progress);

}  // namespace macula::app
