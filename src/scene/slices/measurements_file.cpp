#include "scene/slices/measurements_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/parsing.h"
#include "pipeline/volume/json_writer.h"
#include "scene/state/measurements_json.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;
using slices::Measurement;

// The results of a measurement.
struct Said {
    std::optional<double> lengthMm, shortMm, angleDeg, areaMm2;
    std::optional<bool> isNode;
    std::optional<slices::AreaValues> values;
    std::optional<int> slice;  // from 0
    std::optional<int> imageNumber;
};

void sayShape(Said& said, const Measurement& measurement) {
    if (const auto* distance = std::get_if<slices::Distance>(&measurement.shape))
        said.lengthMm = slices::lengthMm(*distance);
    if (const auto* line = std::get_if<slices::OpenLine>(&measurement.shape))
        said.lengthMm = slices::lengthMm(*line);
    if (const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape)) {
        const slices::Axes axes = slices::axesOf(*lesion);
        said.lengthMm = axes.longMm;
        said.shortMm = axes.shortMm;
        said.isNode = lesion->isNode;
    }
    if (const auto* angle = std::get_if<slices::Angle>(&measurement.shape))
        said.angleDeg = slices::angleDeg(*angle);
    if (const auto* cobb = std::get_if<slices::CobbAngle>(&measurement.shape))
        said.angleDeg = slices::angleDeg(*cobb);
    if (const auto* ellipse = std::get_if<slices::Ellipse>(&measurement.shape))
        said.areaMm2 = slices::areaMm2(*ellipse);
    if (const auto* outline = std::get_if<slices::Outline>(&measurement.shape))
        said.areaMm2 = slices::areaMm2(*outline);
}

Said saidBy(const Measurement& measurement, const Measured& of) {
    Said said;
    said.slice = slices::sliceOf(measurement, of.volume);
    if (said.slice && std::size_t(*said.slice) < of.imageNumbers.size()) {
        const int number = of.imageNumbers[std::size_t(*said.slice)];
        if (number > 0) said.imageNumber = number;
    }
    sayShape(said, measurement);
    said.values = slices::valuesIn(measurement, of.volume);
    return said;
}

constexpr std::array kColumns{"kind",      "label",     "length_mm",
                              "angle_deg", "area_mm2",  "voxels",
                              "mean",      "deviation", "low",
                              "high",      "unit",      "x1_mm",
                              "y1_mm",     "z1_mm",     "x2_mm",
                              "y2_mm",     "z2_mm",     "x3_mm",
                              "y3_mm",     "z3_mm",     "normal_x",
                              "normal_y",  "normal_z",  "calibrated",
                              "slice",     "image",     "interpolated_voxels",
                              "short_mm",  "node",      "x4_mm",
                              "y4_mm",     "z4_mm"};
constexpr std::size_t kFirstPoints = 3;  // in the columns before the normal
constexpr std::size_t kMostPoints = 4;   // with those at the end

// Nine significant digits, because values may be small, as those of a diffusion map in mm²/s.
std::string valueText(double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string();
}

std::string number(std::optional<double> value) {
    if (!value || !std::isfinite(*value)) return {};
    const std::string text = fmt::format("{:.3f}", *value);
    return text == "-0.000" ? "0.000" : text;
}

std::string line(std::span<const std::string> fields) {
    return fmt::format("{}\r\n", fmt::join(fields, ","));
}

std::string lineOf(const Measurement& measurement, const Measured& of) {
    const Volume& volume = of.volume;
    const Said said = saidBy(measurement, of);
    std::vector<std::string> fields{std::string(slices::kindOf(measurement)), csvWords(measurement.label),
                                    number(said.lengthMm), number(said.angleDeg), number(said.areaMm2)};
    if (const auto& values = said.values) {
        fields.push_back(std::to_string(values->voxels));
        for (const double value : {values->mean, values->deviation, values->low, values->high})
            fields.push_back(valueText(value));
        fields.push_back(csvWords(volume.unitName()));
    } else {
        fields.resize(fields.size() + 6);
    }
    std::vector<glm::dvec3> points = slices::pointsOf(measurement);
    if (points.size() > kMostPoints) points.clear();
    const auto addPoint = [&](std::size_t i) {
        for (int axis = 0; axis < 3; ++axis)
            fields.push_back(i < points.size() ? number(points[i][axis]) : std::string());
    };
    for (std::size_t i = 0; i < kFirstPoints; ++i) addPoint(i);
    for (int axis = 0; axis < 3; ++axis) fields.push_back(number(measurement.normal[axis]));
    fields.emplace_back(volume.provenance().isCalibrated ? "yes" : "no");
    fields.push_back(said.slice ? std::to_string(*said.slice + 1) : std::string());
    fields.push_back(said.imageNumber ? std::to_string(*said.imageNumber) : std::string());
    fields.push_back(said.values ? std::to_string(said.values->interpolated) : std::string());
    fields.push_back(number(said.shortMm));
    fields.emplace_back(!said.isNode ? "" : *said.isNode ? "yes" : "no");
    addPoint(kFirstPoints);
    MACULA_CHECK_EQ(fields.size(), kColumns.size());
    return line(fields);
}

// JSON has no infinity and no NaN.
void nullWhatIsNotFinite(Json& json) {
    if (json.is_number_float() && !std::isfinite(json.get<double>())) json = nullptr;
    if (json.is_structured())
        for (Json& part : json) nullWhatIsNotFinite(part);
}

Json jsonOf(const Measurement& measurement, const Measured& of) {
    const Volume& volume = of.volume;
    const Said said = saidBy(measurement, of);
    Json json = toJson(measurement);
    if (said.lengthMm) json["lengthMm"] = *said.lengthMm;
    if (said.shortMm) json["shortMm"] = *said.shortMm;
    if (said.angleDeg) json["angleDeg"] = *said.angleDeg;
    if (said.areaMm2) json["areaMm2"] = *said.areaMm2;
    if (const auto& values = said.values) {
        json["voxels"] = values->voxels;
        json["mean"] = values->mean;
        json["deviation"] = values->deviation;
        json["low"] = values->low;
        json["high"] = values->high;
        json["unit"] = volume.unitName();
        json["interpolatedVoxels"] = values->interpolated;
    }
    if (said.slice) json["slice"] = *said.slice + 1;
    if (said.imageNumber) json["image"] = *said.imageNumber;
    nullWhatIsNotFinite(json);
    return json;
}

}  // namespace

std::string measurementsCsv(std::span<const Measurement> measurements, const Measured& of) {
    std::string text = line(std::vector<std::string>(kColumns.begin(), kColumns.end()));
    for (const Measurement& measurement : measurements) text += lineOf(measurement, of);
    return text;
}

std::string measurementsJsonText(std::span<const Measurement> measurements, const Measured& of) {
    Json all = Json::array();
    for (const Measurement& measurement : measurements) all.push_back(jsonOf(measurement, of));
    return prettyJson({{"version", 1},
                       {"frame", "patient LPS, mm"},
                       {"calibrated", of.volume.provenance().isCalibrated},
                       {"measurements", std::move(all)}});
}

Result<void> writeMeasurements(const std::filesystem::path& path, std::span<const Measurement> measurements,
                               const Measured& of) {
    const std::string extension = lowerCase(path.extension().string());
    if (extension == ".csv") return writeTextAtomically(path, measurementsCsv(measurements, of));
    if (extension == ".json") return writeTextAtomically(path, measurementsJsonText(measurements, of));
    return Error{ErrorCode::usage, Text("Measurements are written to a .csv or .json file."), path.string(),
                 Text("Choose a name with one of these endings.")};
}

}  // namespace macula::scene
