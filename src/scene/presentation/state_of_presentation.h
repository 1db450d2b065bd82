// A StudyState from a DICOM presentation state.
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

namespace macula::scene {

struct PresentedState {
    StudyState state;
    bool isOwn = false;            // read from Macula's own state, so the picture is the same
    double widthOverHeight = 0.0;  // of the view that another program wrote; 0: that of the window
    std::vector<Text> notes;       // sentences: what Macula does not show, or shows differently
};

// Converts what needs no volume: look, camera, colours, windows, lights. What the object lacks stays as in
// `usual`, except that nothing hides voxels. The caller then checks the series (completeFor). Error:
// inputNotUsable for a camera that is not usable; the error names `where`.
Result<PresentedState> stateOf(const dicom::PresentationState& read, StudyState usual,
                               const std::string& where);

// Checks that the object refers to the open series (LoadedStudy::seriesDigest) and to images of its volume
// (imagesOf; empty: not compared), then sets what needs the volume: clip, unit and modality. Error:
// inputNotUsable if it refers to another series or none of the images, or (a state that is not Macula's own)
// if its clip leaves nothing or has too many planes, or the volume is in SUV.
Result<void> completeFor(PresentedState& presented, const dicom::PresentationState& read,
                         const Volume& volume, std::string_view seriesDigest,
                         std::span<const dicom::ReferencedFrames> images, const std::string& where);

// If a picture of that aspect is narrower than the view, enlarges the camera's field to the view's width;
// more is then seen above and below. Changes nothing else.
void widenFor(PresentedState& presented, double aspectWidthOverHeight);

// Reads the file, then calls stateOf and completeFor.
Result<PresentedState> openPresentation(const std::filesystem::path& path, const Volume& volume,
                                        std::string_view seriesDigest,
                                        std::span<const dicom::ReferencedFrames> images,
                                        StudyState usual = {});

}  // namespace macula::scene
