// A second volume in the same 3D picture, for who has no window.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/additions.h"
#include "scene/second/beside_state.h"
#include "study/open/study_input.h"

namespace macula::app {

// What takes the study's places to the second volume's.
enum class SecondLink {
    asItLies,  // both have the same coordinates: images of one examination, or of one frame of reference
    search,    // registration::registerRigid
};

// Empty: not given.
struct SecondWish {
    std::filesystem::path path;
    std::string series;  // as loadStudy
    std::string preset;  // as choosePreset; nothing: the colours that it would have over slices
    SecondLink link = SecondLink::asItLies;
    dicom::ScanOptions how;

    bool isGiven() const { return !path.empty(); }
};

// usage when there is a series, a preset or a link, and no second volume.
Result<void> check(const SecondWish& wish, bool linkIsGiven);

// What a second volume is refused with that is the study's own.
Error secondIsTheStudy();

struct SecondToDraw {
    SecondVolume second;
    std::string remark;                 // secondRemark
    std::vector<std::string> notes;     // sentences, without patient data
    std::vector<std::string> warnings;  // those of them that change what is seen
};

// The volume of `study` is stored16. A view that was saved with this second volume (`beside`, or null) says
// where it lies, unless it is searched, and what it is drawn with, unless a preset is given. Fails as
// loadStudy, choosePreset and registerRigid; inputNotUsable where nothing of it lies in the study, it is
// of another patient, or it is the study's own volume.
Result<SecondToDraw> secondToDraw(const SecondWish& wish, const StudyInput& study, const BesideState* beside,
                                  Progress& progress);

}  // namespace macula::app
