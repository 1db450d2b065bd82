// What a structured report measured (PS3.16 TID 1500 and others that draw shapes), as measurements on slices.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "base/text.h"
#include "dicom/documents/document.h"
#include "dicom/stack/series.h"
#include "slices/measurement.h"

namespace macula::scene {

struct MeasurementsOfReport {
    std::vector<slices::Measurement> taken;  // points in patient LPS mm
    std::vector<Text>
        leftOut;  // sentences: what is not among them, and numbers that differ from the report's
};

// The series that is open, of which `stack` is one.
struct ReportedOn {
    const dicom::Series& series;
    const dicom::Stack& stack;
};

// A line of two points is a distance; two such lines in a group, with the numbers Long Axis and Short Axis,
// are both axes of a lesion. One of three points with an angle in degrees is an angle, one of four with a
// Cobb angle is that. A circle or an ellipse is an ellipse; a line or a polygon that ends where it begins is
// an outline, and any other line with a length is a line. Points on an image go through the plane of that
// image, and have to be on one of the stack; points in space have to be in its frame of reference. A
// measurement that is already among `there`, to a micrometre, is not taken again. Its values are measured
// anew: a sentence says where the report has another length, angle or area for the same points, by more than
// 2 %. Fails with inputNotUsable when the report is of another patient or study than the images, when an
// image cannot be read, and when nothing can be taken.
Result<MeasurementsOfReport> measurementsOf(const dicom::StudyDocument& report, const ReportedOn& of,
                                            std::span<const slices::Measurement> there = {});

}  // namespace macula::scene
