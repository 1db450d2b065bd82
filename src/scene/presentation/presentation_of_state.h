// What was chosen, as a DICOM presentation state says it.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/presentation/volume_presentation.h"
#include "scene/state/study_state.h"

namespace macula::app {

struct SaidState {
    dicom::VolumePresentation presentation;  // its series is still to be put in
    std::vector<std::string> leftOut;        // sentences: what other programs will show otherwise
};

// Needs a preset and a camera; the volume in 16 bits. The state as a whole goes into
// VolumePresentation::ownState, so that Macula draws the same picture; `isDeidentified` leaves out of it
// digests of UIDs, by which a second volume and segmentations are found, and what a person has named or
// written. usage without preset or camera, or for a camera that is none.
Result<SaidState> presentationOf(const StudyState& state, const Volume& volume, double aspectWidthOverHeight,
                                 bool isDeidentified = false);

}  // namespace macula::app
