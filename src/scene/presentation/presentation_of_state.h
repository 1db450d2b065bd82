// A StudyState as a DICOM presentation state.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/presentation/volume_presentation.h"
#include "scene/state/study_state.h"

namespace macula::scene {

struct SaidState {
    dicom::VolumePresentation presentation;  // the caller fills in its `series`
    std::vector<Text> leftOut;               // sentences: what other programs will show differently
};

// Needs a preset, a camera, and a volume that is stored16. VolumePresentation::ownState holds the whole state
// (up to 200000 bytes), so that Macula draws the same picture. `isDeidentified` removes from it names and
// texts that a person typed, and the digests of UIDs by which a second volume and segmentations are found.
// Error: usage without preset, camera or positive aspect, or if the camera is not usable.
Result<SaidState> presentationOf(const StudyState& state, const Volume& volume, double aspectWidthOverHeight,
                                 bool isDeidentified = false);

}  // namespace macula::scene
