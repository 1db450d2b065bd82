// A second volume in the same 3D picture, for programs without a window.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/additions.h"
#include "scene/second/second_volume_state.h"
#include "study/open/loaded_study.h"

namespace macula::scene {

// How points of the study are mapped to the second volume.
enum class SecondPlacement {
    asItLies,  // both have the same coordinates: images of one examination, or of one frame of reference
    search,    // registration::registerRigid
};

// An empty `path` means no second volume.
struct SecondVolumeRequest {
    std::filesystem::path path;
    std::string series;  // as loadStudy
    std::string preset;  // as choosePreset; empty: the colours used over slices
    SecondPlacement link = SecondPlacement::asItLies;
    dicom::ScanOptions how;

    bool isGiven() const { return !path.empty(); }
};

// Error: usage if a series, a preset or a link is given without a second volume.
Result<void> check(const SecondVolumeRequest& request, bool linkIsGiven);

// The error for a second volume that is the study's own.
Error secondIsTheStudy();

struct DrawableSecond {
    DrawnSecondVolume second;
    Text remark;                 // secondRemark
    std::vector<Text> notes;     // sentences, without patient data
    std::vector<Text> warnings;  // the notes that affect what is seen
};

// Loads the second volume for a `study` that is stored16. A saved view of both (`beside`, or null) sets its
// look, unless `request` has a preset, and, if pairDigest matches, its place, unless `request` searches for
// it. Errors: those of loadStudy, choosePreset and registerRigid; inputNotUsable if all of it lies outside
// the study, it belongs to another patient, or it is the study's own volume.
Result<DrawableSecond> secondToDraw(const SecondVolumeRequest& request, const study::LoadedStudy& study,
                                    const SecondVolumeState* beside, Progress& progress);

}  // namespace macula::scene
