// Texts over a slice.
#pragma once

#include <QColor>
#include <QString>
#include <optional>

#include "scene/camera/orbit_camera.h"
#include "slices/sampled_slice.h"
#include "slices/slice_plane.h"
#include "study/open/opened_study.h"
#include "viewer/overlay/slice_steps.h"

namespace macula::viewer {

QString nameOf(slices::Orientation orientation);  // "Axial"
// The usual colour of its plane's lines in other panes: axial red, sagittal yellow, coronal green.
QColor colourOf(slices::Orientation orientation);
// The orientations of the planes that a cross-hair's vertical and horizontal lines mark.
slices::Orientation verticalOf(slices::Orientation orientation);
slices::Orientation horizontalOf(slices::Orientation orientation);

// The patient's sides at the edges of the picture.
scene::EdgeLetters edgeLetters(const slices::SlicePlane& plane);

// "Axial S 123.4 mm, slice 45 of 95": how far the plane is from the patient's origin and in which direction,
// and the slice's number if images were taken in such planes. "Axial, oblique" for a plane that is not
// perpendicular to the patient's axes, "Axial, turned by 12.5°" for one that a person has turned. With the
// number of an image: "…, slice 45 of 95, image 51".
QString positionText(slices::Orientation orientation, const SliceSteps& steps, int slice,
                     std::optional<int> imageNumber = {});
// The same without numbers.
QString planeText(slices::Orientation orientation, const SliceSteps& steps, int slice);
// `text` with the numbers behind it.
QString withNumbers(const QString& text, int slice, int count, std::optional<int> imageNumber);
QString slabText(const slices::Slab& slab);  // "MIP 10 mm"; empty for the plane alone
// The number by which a report names the slice, often counted from the other end; nothing where no image was
// taken, or where all numbers equal those of the slices.
std::optional<int> imageNumber(const study::OpenedStudy& study, int slice);
std::optional<int> imageNumber(const study::OpenedStudy& study, const SliceSteps& steps, int slice);
QString degreesText(double deg);          // "12.5°"
QString pointText(const glm::dvec3& mm);  // "L 12.3 P 45.6 S 78.9 mm"
// "-87 HU at (12, 200, 45), L 12.3 P 45.6 S 78.9 mm"; padding, interpolated and outside points in words.
QString probeText(const Volume& volume, const glm::dvec3& mm);

// "12.3 mm, not calibrated": marks an estimated size.
QString notCalibrated(const QString& text);
// "5 cm"; uncalibrated "≈ 5 cm, not calibrated".
QString sizeText(const QString& size, bool isCalibrated);

// Whether no image was taken where the slice is.
bool isInterpolated(const Volume& volume, const SliceSteps& steps, int slice);

}  // namespace macula::viewer
