// Reads Grayscale Softcopy Presentation State objects (PS3.3 A.33.1): how grey images are shown in 2D, as far
// as this applies to slices of a volume.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/planar/planar_header.h"
#include "dicom/presentation/softcopy_annotations.h"
#include "dicom/read/referenced_frames.h"

namespace macula::dicom {

// No `images` means all images of the object.
struct SoftcopyWindow {
    std::vector<ReferencedFrames> images;
    std::optional<DisplayWindow> window;  // of values after the rescale below; nothing for a table
    std::optional<VoiTable> table;        // of the same values, where there is no window

    bool operator==(const SoftcopyWindow&) const = default;
};

// Presentation Size Mode (PS3.3 C.10.4). `fitted`: the area fills the pane. `trueSize`: a millimetre of the
// patient is one on the screen. `magnified`: each pixel of the image covers a given number of screen pixels.
enum class DisplayedSize { fitted, trueSize, magnified };

// Corners in pixels, (column, row) from 1 (PS3.3 C.10.4); bottomRight is included, and not less than topLeft.
struct DisplayedArea {
    std::vector<ReferencedFrames> images;
    glm::ivec2 topLeft{1};
    glm::ivec2 bottomRight{1};
    DisplayedSize size = DisplayedSize::fitted;

    bool operator==(const DisplayedArea&) const = default;
};

// Texts and UIDs may name a patient: never logged.
struct SoftcopyState {
    std::vector<std::string> seriesUids;  // in the order of the file, as are images
    std::vector<ReferencedFrames> images;
    // How to rotate and flip images for display (PS3.3 C.10.6).
    int rotationDeg = 0;
    bool isFlipped = false;
    // The rescale to the values of the windows (PS3.3 C.11.1); 1 and 0 if there is none.
    double slope = 1.0;
    double intercept = 0.0;
    bool hasModalityTable = false;
    std::vector<SoftcopyWindow> windows;
    std::vector<DisplayedArea> areas;
    bool isInverse = false;  // white and black change places
    // For images that are shown as they are; slices of a volume have none of it.
    SoftcopyAnnotations annotations;
    std::optional<DisplayShutter> shutter;
    std::vector<OverlayPlane> overlays;  // with pixels of its own, or naming those of the images (`layer`)
    // What slices have not of the object, in words that complete "The presentation state has …".
    std::vector<Text> leftOut;
    std::vector<Text> leftOutOfImages;  // the same of images that are shown as they are
};

// Never throws. Fails with inputNotUsable when it is not such an object, or names no images; or outOfMemory.
Result<SoftcopyState> readSoftcopyState(const std::filesystem::path& path);

}  // namespace macula::dicom
