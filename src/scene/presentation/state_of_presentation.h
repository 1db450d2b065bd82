// What a DICOM presentation state says, as something to choose.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/presentation/presentation_state.h"
#include "dicom/read/referenced_frames.h"
#include "scene/state/study_state.h"

namespace macula::app {

struct PresentedState {
    StudyState state;
    bool isOwn = false;              // in the words of Macula, and so the same picture
    double widthOverHeight = 0.0;    // of the view that another program wrote; 0: as the window is
    std::vector<std::string> notes;  // sentences: what it has that is not shown, or otherwise
};

// As far as that can be said without the volume: look, camera, colours, windows, lights. What is not in the
// object is as in `usual`, but for what hides voxels: nothing is hidden. The series is still to be checked.
// inputNotUsable for a camera that is none; `where` is for the error.
Result<PresentedState> stateOf(const dicom::PresentationState& read, StudyState usual,
                               const std::string& where);

// Of the series that is open (StudyInput::seriesDigest) and the images of its volume (imagesOf; none: they
// are not known, and not compared), and with what needs its volume: the clip, and what the values are.
// inputNotUsable when it is of another series, or of none of these images, or its clip leaves nothing or is
// of too many planes.
Result<void> completeFor(PresentedState& presented, const dicom::PresentationState& read,
                         const Volume& volume, std::string_view seriesDigest,
                         std::span<const dicom::ReferencedFrames> images, const std::string& where);

// A picture of that aspect, where it is narrower than the view, becomes as wide as that: more is seen above
// and below. Nothing else changes.
void widenFor(PresentedState& presented, double aspectWidthOverHeight);

// A file, the first two of the above.
Result<PresentedState> openPresentation(const std::filesystem::path& path, const Volume& volume,
                                        std::string_view seriesDigest,
                                        std::span<const dicom::ReferencedFrames> images,
                                        StudyState usual = {});

}  // namespace macula::app
