// What a Grayscale Softcopy Presentation State says, as slices of a volume can be shown.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "dicom/presentation/softcopy_state.h"
#include "dicom/stack/stack.h"
#include "scene/state/study_state.h"
#include "slices/slice_plane.h"
#include "study/open/opened_study.h"

namespace macula::app {

// What of a slice is to be seen, all of it as large as a pane can show it.
struct SliceArea {
    slices::Orientation orientation = slices::Orientation::axial;  // of the pane
    glm::dvec3 centreMm{0.0};
    glm::dvec2 sizeMm{1.0};  // to the right and down in the pane

    bool operator==(const SliceArea&) const = default;
};

struct SoftcopyOnSlices {
    SliceState slices;
    std::optional<SliceArea> area;   // nothing: all of the volume
    std::vector<std::string> notes;  // sentences: what it has that is not shown, or otherwise
};

// On the images of the volume that the object is of: the cross-hair goes to the middle of what is seen of the
// first of them, in the planes of the acquisition. Windows are of the volume's values only where the object
// makes them as its images do. Of a file of many frames only those that it names are meant; all slices are
// shown as the first is, which is told. Slices are never turned nor mirrored: of an object that does, the
// area is left out. What is left out stays as in `usual`. inputNotUsable when it is of none of these images;
// `where` is for the error. `isLowBright` as OpenedStudy has it.
Result<SoftcopyOnSlices> softcopyOn(const dicom::SoftcopyState& said, const dicom::Stack& stack,
                                    const Volume& volume, bool isLowBright, SliceState usual,
                                    const std::string& where);

// A file, on the study that is open. usage where that is of no DICOM folder.
Result<SoftcopyOnSlices> openSoftcopy(const std::filesystem::path& path, const OpenedStudy& study,
                                      SliceState usual);

}  // namespace macula::app
