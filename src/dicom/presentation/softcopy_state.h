// Grayscale Softcopy Presentation State objects (PS3.3 A.33.1): how grey images are shown in 2D, as far as
// slices of a volume can be shown so. Reading only.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/read/referenced_frames.h"

namespace macula::dicom {

// `images`, none: all that the object is of.
struct SoftcopyWindow {
    std::vector<ReferencedFrames> images;
    std::optional<DisplayWindow> window;  // of values after the rescale below; nothing: it is a table

    bool operator==(const SoftcopyWindow&) const = default;
};

// Presentation Size Mode (PS3.3 C.10.4). `fitted`: the area fills the pane. `trueSize`: a millimetre of the
// patient is one on the screen. `magnified`: each pixel of the image covers a given number of screen pixels.
enum class DisplayedSize { fitted, trueSize, magnified };

// Corners in pixels, (column, row) from 1 (PS3.3 C.10.4); bottom right is within. Its columns and rows grow.
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
    // How images are to be turned and mirrored before they are seen (PS3.3 C.10.6).
    int rotationDeg = 0;
    bool isFlipped = false;
    // What makes the values that windows are of (PS3.3 C.11.1); without it 1 and 0.
    double slope = 1.0;
    double intercept = 0.0;
    bool hasModalityTable = false;
    std::vector<SoftcopyWindow> windows;
    std::vector<DisplayedArea> areas;
    bool isInverse = false;  // white and black change places
    // What else is in it, in words that end "The presentation state has …".
    std::vector<std::string> leftOut;
};

// Throws nothing, whatever is in the file. inputNotUsable when it is no such object, or names no images.
Result<SoftcopyState> readSoftcopyState(const std::filesystem::path& path);

}  // namespace macula::dicom
