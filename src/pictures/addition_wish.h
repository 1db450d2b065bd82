// A second volume and segments in a picture, as somebody asks for them who has no window.
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

// Empty: not given.
struct AdditionWish {
    std::vector<std::string> segments = {};  // segmentWishFrom each
    SecondWish second = {};                  // in the same picture; scanned as the study is
    bool secondLinkIsGiven = false;
};

// What may be a file among what is given, for OutputFiles::read.
std::vector<std::filesystem::path> filesOf(const AdditionWish& wish);

// What is asked for, and what a view says.
struct AdditionChoice {
    std::vector<SegmentWish> segments;
    std::vector<SegmentationChoice> ofView;
    SecondWish second;
    std::optional<BesideState> beside;  // of the view

    bool needsSegmentations() const;
};

// All that can be wrong about the wish, nothing yet read of the study at that path. What the view says of
// segments and of a second volume is in the choice then, and not in the state any more.
Result<AdditionChoice> additionChoice(const AdditionWish& wish, const std::filesystem::path& study,
                                      StudyState& state);

struct MadeAdditions {
    Additions additions;
    std::vector<std::string> notes;     // sentences, without patient data
    std::vector<std::string> warnings;  // those of them that change what is seen
};

// Makes what is drawn beside the study, as far as `look` draws it: a projection does not read a second
// volume. The volume of the study must be stored16. Writes to `clip` the mask of the segments that are left
// out. Errors: those of segmentsToDraw and secondToDraw.
Result<MadeAdditions> makeAdditions(const AdditionChoice& choice, const ReadStudy& study, trace::Look look,
                                    Clip& clip, Progress& progress);

}  // namespace macula::app
