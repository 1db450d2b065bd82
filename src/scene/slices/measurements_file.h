// Measurements for other programs: as CSV for spreadsheets, and as JSON. Points are in patient LPS mm, values
// in the units of the volume. Only a label that a person typed can identify the patient.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "slices/measurement.h"

namespace macula::scene {

// The volume that was measured on.
struct Measured {
    // Implicit, because most callers have no image numbers.
    Measured(const Volume& of, std::span<const int> numbers = {}) : volume(of), imageNumbers(numbers) {}

    const Volume& volume;               // with the values of the file: OpenedStudy::measured
    std::span<const int> imageNumbers;  // imageNumbersOf; empty: not known
};

// RFC 4180, in UTF-8: a line of names, then one for each measurement; lines end with CR LF. Numbers have a
// decimal point and three decimals, values nine significant digits, in every locale; fields that do not apply
// are empty. Of a lesion with two axes "length_mm" is the long one, "short_mm" the other, and "node" whether
// a person calls it a lymph node. Points are those of slices::pointsOf if they are at most four. A text that
// a spreadsheet would take for a formula gets an apostrophe in front. "calibrated" is "no" where points,
// lengths and areas are estimates. "slice" counts from 1 and "image" is its InstanceNumber, both empty if the
// measurement crosses several slices; "interpolated_voxels" counts those of "voxels" in slices without an
// image.
std::string measurementsCsv(std::span<const slices::Measurement> measurements, const Measured& of);

//   { "version": 1, "frame": "patient LPS, mm", "calibrated": true, "measurements": [{as
//   measurements_json.h}] }
// A distance and a line also have "lengthMm", a lesion with two axes "lengthMm" and "shortMm", an angle
// "angleDeg", and an ellipse or an outline "areaMm2", "voxels", "mean", "deviation", "low", "high", "unit"
// and "interpolatedVoxels"; without a voxel it has only the area. A number that is not finite is null.
// "slice" and "image" are as above, and missing where those are empty.
std::string measurementsJsonText(std::span<const slices::Measurement> measurements, const Measured& of);

// The extension selects the format: .csv or .json, otherwise usage. Other errors: those of
// writeTextAtomically.
Result<void> writeMeasurements(const std::filesystem::path& path,
                               std::span<const slices::Measurement> measurements, const Measured& of);

}  // namespace macula::scene
