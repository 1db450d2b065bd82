// Measurements for other programs: as CSV for spreadsheets, and as JSON. Points are in patient LPS mm, values
// in the units of the volume. Nothing says whose they are but what a person wrote into a label.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "slices/measurement.h"

namespace macula::app {

// What was measured on.
struct Measured {
    // Implicit: most that is measured on has no numbers.
    Measured(const Volume& of, std::span<const int> numbers = {}) : volume(of), imageNumbers(numbers) {}

    const Volume& volume;               // the values of the file: OpenedStudy::measured
    std::span<const int> imageNumbers;  // imageNumbersOf; empty: not known
};

// RFC 4180, in UTF-8: a line of names, then one for each measurement; lines end with CR LF. Numbers have a
// point and three decimals, values nine digits, whatever the locale; what a measurement does not have is
// empty. Points are those of slices::pointsOf. No text is one that a spreadsheet would run: where it begins
// like a formula, an apostrophe is put before it. "calibrated" is "no" where points, lengths and areas are
// estimates. "slice" counts from 1 and "image" is its InstanceNumber, both empty where a measurement goes
// through several; "interpolated_voxels" are those of "voxels" where no image was taken.
std::string measurementsCsv(std::span<const slices::Measurement> measurements, const Measured& of);

//   { "version": 1, "frame": "patient LPS, mm", "calibrated": true, "measurements": [{as slices_json.h}] }
// A distance has "lengthMm" besides, an angle "angleDeg", and an ellipse "areaMm2", "voxels", "mean",
// "deviation", "low", "high", "unit" and "interpolatedVoxels"; those behind the area are missing where there
// is no voxel, and a number that is not defined is null. "slice" and "image" as above, where there is one.
std::string measurementsJsonText(std::span<const slices::Measurement> measurements, const Measured& of);

// By the ending of the name: .csv or .json, else usage. Fails as writeTextAtomically.
Result<void> writeMeasurements(const std::filesystem::path& path,
                               std::span<const slices::Measurement> measurements, const Measured& of);

}  // namespace macula::app
