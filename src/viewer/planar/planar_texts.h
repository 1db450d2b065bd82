// The texts over an image that is shown as it is.
#pragma once

#include <QString>
#include <QStringList>
#include <array>
#include <optional>

#include "dicom/planar/planar_header.h"
#include "study/planar/planar_display.h"

namespace macula::viewer {

// A picture that is turned, and then perhaps mirrored.
struct PlanarTurn {
    int quarters = 0;  // clockwise, 0 to 3
    bool isMirrored = false;

    bool operator==(const PlanarTurn&) const = default;
};

// The letters at the left, top, right and bottom edge: empty where the file does not say. Feet and head are F
// and H, as in the files (PS3.3 C.7.6.1.1.1).
std::array<QString, 4> edgeLetters(const std::array<std::string, 2>& towards, const PlanarTurn& turn);

// "image 2 of 5, frame 3 of 30"; without the frame where the file has only one.
QString placeText(int image, int images, int frame, int frames);
// "L CC": side and view; empty where the file says neither.
QString viewText(const dicom::PlanarHeader& header);
// Window or table; empty for colours.
QString displayText(const dicom::PlanarHeader& header, const study::PlanarDisplay& display, bool isColour);
// What is not as in the file: turned, mirrored, inverted.
QStringList changesOf(const PlanarTurn& turn, const study::PlanarDisplay& display);
// "0.16 mm per pixel, estimated: ..."; empty where no size is known.
QString pixelSizeText(const dicom::PlanarHeader& header);

}  // namespace macula::viewer
