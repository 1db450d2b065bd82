#include "scene/slices/reported_measurements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "base/coded_name.h"
#include "base/utf8.h"
#include "dicom/write/uid.h"
#include "study/open/slice_images.h"

namespace macula::scene {

namespace {

using dicom::ReportedMeasurement;
using slices::Measurement;

const CodedName kMm{"mm", "UCUM", "millimeter"};
const CodedName kDegree{"deg", "UCUM", "degree"};
const CodedName kMm2{"mm2", "UCUM", "square millimeter"};
constexpr std::size_t kLongestMeaning = 64;  // VR LO

CodedName unitOf(const Volume& volume, bool isDeidentified) {
    const std::string name = volume.unitName();
    if (name == unitSymbol(volume.unit())) {
        switch (volume.unit()) {
            case Unit::hounsfield:
                return {"[hnsf'U]", "UCUM", "Hounsfield unit"};
            case Unit::becquerelsPerMillilitre:
                return {"Bq/ml", "UCUM", "Becquerels/milliliter"};
            case Unit::suvBodyWeight:
                return {"g/ml{SUVbw}", "UCUM", "Standardized Uptake Value body weight"};
            case Unit::raw:
            case Unit::other:
                return {"1", "UCUM", "no units"};
        }
    }
    // A word of the file, which need not be a code of UCUM.
    std::string meaning(isDeidentified ? "unit of the images" : startOf(name, kLongestMeaning));
    std::ranges::replace(meaning, '\\', '/');
    return {"UNIT-OF-IMAGES", "99MACULA", meaning};
}

struct NamesOfValues {
    CodedName mean, deviation, low, high;
};

// Of HU there are codes that name the quantity as well (CID 6141), which no reader can mistake.
NamesOfValues namesOfValues(const CodedName& unit) {
    if (unit.value == "[hnsf'U]")
        return {{"112181", "DCM", "Mean Attenuation Coefficient"},
                {"112183", "DCM", "Standard Deviation of Attenuation Coefficient"},
                {"112179", "DCM", "Minimum Attenuation Coefficient"},
                {"112180", "DCM", "Maximum Attenuation Coefficient"}};
    return {{"373098007", "SCT", "Mean"},
            {"386136009", "SCT", "Standard Deviation"},
            {"255605001", "SCT", "Minimum"},
            {"56851009", "SCT", "Maximum"}};
}

bool isFirstLonger(const slices::Bidirectional& lesion) {
    return slices::lengthMm(slices::Distance{lesion.firstMm}) >=
           slices::lengthMm(slices::Distance{lesion.secondMm});
}

// The points as a report has them: of an ellipse both ends of its longer axis, then of the shorter one; of a
// lesion with two axes those of its long axis.
std::vector<glm::dvec3> reportedPoints(const Measurement& measurement) {
    if (const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape)) {
        const auto& axis = isFirstLonger(*lesion) ? lesion->firstMm : lesion->secondMm;
        return {axis.begin(), axis.end()};
    }
    const auto* ellipse = std::get_if<slices::Ellipse>(&measurement.shape);
    if (ellipse == nullptr) return slices::pointsOf(measurement);
    const glm::dvec3& centre = ellipse->plane.centreMm;
    glm::dvec3 longer = ellipse->radiiMm.x * ellipse->plane.right;
    glm::dvec3 shorter = ellipse->radiiMm.y * ellipse->plane.down;
    if (ellipse->radiiMm.y > ellipse->radiiMm.x) std::swap(longer, shorter);
    return {centre - longer, centre + longer, centre - shorter, centre + shorter};
}

// The points of the short axis; none: it has only one line.
std::vector<glm::dvec3> secondPoints(const Measurement& measurement) {
    const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape);
    if (lesion == nullptr) return {};
    const auto& axis = isFirstLonger(*lesion) ? lesion->secondMm : lesion->firstMm;
    return {axis.begin(), axis.end()};
}

bool canBeSaid(const ReportedMeasurement& said, std::span<const glm::dvec3> pointsMm) {
    constexpr double kFarthestMm = 1e7;  // float32, in which points are written, has 7 digits
    return !said.numbers.empty() && std::ranges::all_of(said.numbers, [](const dicom::ReportedNumber& n) {
        return std::isfinite(n.value);
    }) && std::ranges::all_of(pointsMm, [](const glm::dvec3& mm) {
        return std::abs(mm.x) <= kFarthestMm && std::abs(mm.y) <= kFarthestMm &&
               std::abs(mm.z) <= kFarthestMm;
    });
}

// Of shapes without an area.
std::vector<dicom::ReportedNumber> numbersOf(const Measurement& measurement) {
    const CodedName length{"410668003", "SCT", "Length"};
    if (const auto* distance = std::get_if<slices::Distance>(&measurement.shape))
        return {{length, kMm, slices::lengthMm(*distance)}};
    if (const auto* line = std::get_if<slices::OpenLine>(&measurement.shape))
        return {{length, kMm, slices::lengthMm(*line)}};
    if (const auto* angle = std::get_if<slices::Angle>(&measurement.shape))
        return {{{"110859", "DCM", "Angle"}, kDegree, slices::angleDeg(*angle)}};
    if (const auto* cobb = std::get_if<slices::CobbAngle>(&measurement.shape))
        return {{{"285285000", "SCT", "Cobb angle"}, kDegree, slices::angleDeg(*cobb)}};
    if (const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape)) {
        const slices::Axes axes = slices::axesOf(*lesion);
        return {{{"103339001", "SCT", "Long Axis"}, kMm, axes.longMm},
                {{"103340004", "SCT", "Short Axis"}, kMm, axes.shortMm, true}};
    }
    return {};
}

// Fills in shape, numbers and comment.
void sayNumbers(ReportedMeasurement& said, const Measurement& measurement, const Volume& volume,
                bool isDeidentified) {
    said.numbers = numbersOf(measurement);
    if (!volume.provenance().isCalibrated && slices::hasSize(measurement))
        said.comment = "The size of the pixels is not calibrated: lengths and areas are estimates.";
    double area = 0.0;
    if (const auto* ellipse = std::get_if<slices::Ellipse>(&measurement.shape)) {
        said.shape = dicom::ReportedShape::ellipse;
        area = slices::areaMm2(*ellipse);
    } else if (const auto* outline = std::get_if<slices::Outline>(&measurement.shape)) {
        said.shape = dicom::ReportedShape::outline;
        area = slices::areaMm2(*outline);
    } else {
        return;
    }
    said.numbers = {{{"42798000", "SCT", "Area"}, kMm2, area}};
    const auto values = slices::valuesIn(measurement, volume);
    if (!values) return;
    const CodedName unit = unitOf(volume, isDeidentified);
    const NamesOfValues names = namesOfValues(unit);
    said.numbers.push_back({names.mean, unit, values->mean});
    if (values->voxels > 1) said.numbers.push_back({names.deviation, unit, values->deviation});
    said.numbers.push_back({names.low, unit, values->low});
    said.numbers.push_back({names.high, unit, values->high});
    if (values->interpolated > 0)
        said.comment += fmt::format("{}Of {} voxels, {} lie in slices without an image.",
                                    said.comment.empty() ? "" : " ", values->voxels, values->interpolated);
}

// Collects the images that measurements refer to, each once.
class Places {
  public:
    explicit Places(const MeasuredImages& of)
        : of_(of),
          voxelFromWorld_(glm::inverse(of.volume.worldFromVoxel())),
          frameOfReferenceUid_(study::frameOfReferenceOf(of.stack)),
          slices_(study::imagesOfSlices(of.volume, of.stack)) {}

    const std::string& frameOfReferenceUid() const { return frameOfReferenceUid_; }
    std::vector<dicom::ReferencedImage> images() const { return images_; }
    const dicom::Instance* first() const { return first_; }

    // Nothing where the report could not say where the points are.
    std::optional<dicom::ReportedPoints> placeOf(std::span<const glm::dvec3> pointsMm) {
        if (const dicom::Frame* frame = frameHolding(pointsMm)) {
            dicom::PointsOnImage on;
            for (const glm::dvec3& mm : pointsMm) on.pointsPx.push_back(pixelOf(*frame->plane, mm));
            if (isInside(on.pointsPx, *frame->instance) || frameOfReferenceUid_.empty()) {
                on.image = placeAmongImages(*frame);
                if (frame->instance->multiFrame) on.frame = frame->number + 1;
                return on;
            }
        }
        if (frameOfReferenceUid_.empty()) return {};
        addImagesAround(pointsMm);
        return dicom::PointsInSpace{{pointsMm.begin(), pointsMm.end()}};
    }

  private:
    static constexpr double kToleranceSlices = 0.01;

    // The frame in whose plane all of the points lie, to a hundredth of a slice; null if there is none.
    const dicom::Frame* frameHolding(std::span<const glm::dvec3> pointsMm) const {
        const double slice = std::round(transformPoint(voxelFromWorld_, pointsMm.front()).z);
        if (!(slice >= 0.0 && slice < double(of_.volume.size().z))) return nullptr;
        const bool isPlane = std::ranges::all_of(pointsMm, [&](const glm::dvec3& mm) {
            return std::abs(transformPoint(voxelFromWorld_, mm).z - slice) <= kToleranceSlices;
        });
        const dicom::Frame* frame = slices_[std::size_t(slice)].frame;
        return isPlane && frame != nullptr && frame->plane && frame->instance ? frame : nullptr;
    }

    static glm::dvec2 pixelOf(const dicom::ImagePlane& plane, const glm::dvec3& mm) {
        const glm::dvec3 from = mm - plane.positionMm;  // the centre of the first pixel, which is (0.5, 0.5)
        return {glm::dot(from, plane.rowDirection) / plane.columnSpacingMm + 0.5,
                glm::dot(from, plane.columnDirection) / plane.rowSpacingMm + 0.5};
    }

    static bool isInside(std::span<const glm::dvec2> pointsPx, const dicom::Instance& image) {
        return std::ranges::all_of(pointsPx, [&](const glm::dvec2& px) {
            return px.x >= 0.0 && px.y >= 0.0 && px.x <= image.columns && px.y <= image.rows;
        });
    }

    std::size_t placeAmongImages(const dicom::Frame& frame) {
        const dicom::Instance& image = *frame.instance;
        const auto [at, isNew] = placeByUid_.try_emplace(image.sopInstanceUid, images_.size());
        if (isNew) {
            images_.push_back({image.sopClassUid, image.sopInstanceUid, {}});
            if (first_ == nullptr) first_ = &image;
        }
        return at->second;
    }

    void addImagesAround(std::span<const glm::dvec3> pointsMm) {
        double low = std::numeric_limits<double>::max();
        double high = std::numeric_limits<double>::lowest();
        for (const glm::dvec3& mm : pointsMm) {
            const double slice = transformPoint(voxelFromWorld_, mm).z;
            low = std::min(low, slice);
            high = std::max(high, slice);
        }
        const double last = double(of_.volume.size().z) - 1.0;
        auto first = std::size_t(std::clamp(std::floor(low + kToleranceSlices), 0.0, last));
        auto end = std::size_t(std::clamp(std::ceil(high - kToleranceSlices), 0.0, last));
        while (first > 0 && slices_[first].frame == nullptr) --first;
        while (end + 1 < slices_.size() && slices_[end].frame == nullptr) ++end;
        for (std::size_t slice = first; slice <= end; ++slice)
            if (const dicom::Frame* frame = slices_[slice].frame; frame != nullptr && frame->instance)
                placeAmongImages(*frame);
    }

    const MeasuredImages& of_;
    glm::dmat4 voxelFromWorld_;
    std::string frameOfReferenceUid_;
    std::vector<study::SliceImage> slices_;
    std::vector<dicom::ReferencedImage> images_;
    std::map<std::string, std::size_t> placeByUid_;
    const dicom::Instance* first_ = nullptr;
};

// "Distance 2": the second one.
std::string usualLabel(const Measurement& measurement, std::map<std::string, int>& counts) {
    std::string kind(slices::kindOf(measurement));
    kind.front() = char(kind.front() - 'a' + 'A');
    return fmt::format("{} {}", kind, ++counts[kind]);
}

// The same for the same measurement, in whichever report it is.
std::string trackingUidOf(const Measurement& measurement, const std::string& seriesUid) {
    std::string text = fmt::format("{} on {}", slices::kindOf(measurement), seriesUid);
    for (const glm::dvec3& mm : slices::pointsOf(measurement))
        text += fmt::format(" {} {} {}", mm.x, mm.y, mm.z);
    return dicom::uidFrom(text);
}

// How many measurements a report leaves out, and why.
struct LeftOut {
    std::size_t arrows = 0, undefined = 0, nowhere = 0;
    bool labels = false;
};

std::vector<Text> sentencesOn(const LeftOut& leftOut, std::size_t count) {
    std::vector<Text> sentences;
    if (leftOut.arrows > 0)
        sentences.push_back(
            Text("A report of measurements has no place for arrows and their words: of {} measurements, it "
                 "leaves out {}.",
                 count, leftOut.arrows));
    if (leftOut.undefined > 0)
        sentences.push_back(Text(
            "A report holds no measurement whose value is not defined, or whose points are too far away: "
            "of {} measurements, it leaves out {}.",
            count, leftOut.undefined));
    if (leftOut.nowhere > 0)
        sentences.push_back(
            Text("These images name no frame of reference, so a report cannot say where a measurement lies "
                 "that is in no plane of theirs: of {} measurements, it leaves out {}.",
                 count, leftOut.nowhere));
    if (leftOut.labels)
        sentences.push_back(Text("Without patient and study, the report leaves out the labels."));
    return sentences;
}

// Where the measurement lies; false where the report could not say it.
bool sayPlaces(ReportedMeasurement& said, Places& places, const Measurement& measurement) {
    auto place = places.placeOf(reportedPoints(measurement));
    if (!place) return false;
    said.points = std::move(*place);
    const std::vector<glm::dvec3> second = secondPoints(measurement);
    if (second.empty()) return true;
    said.second = places.placeOf(second);
    return said.second.has_value();
}

}  // namespace

Result<SaidMeasurements> saidMeasurements(std::span<const Measurement> measurements, const MeasuredImages& of,
                                          bool isDeidentified) {
    MACULA_TRY_VOID(dicom::checkReferable(of.series));
    Places places(of);
    SaidMeasurements said;
    std::map<std::string, int> counts;
    LeftOut leftOut;
    bool hasLabels = false;
    for (const Measurement& measurement : measurements) {
        if (std::holds_alternative<slices::Arrow>(measurement.shape)) {
            ++leftOut.arrows;
            continue;
        }
        ReportedMeasurement each;
        each.label = usualLabel(measurement, counts);
        sayNumbers(each, measurement, of.volume, isDeidentified);
        if (!canBeSaid(each, slices::pointsOf(measurement))) {
            ++leftOut.undefined;
            continue;
        }
        if (!sayPlaces(each, places, measurement)) {
            ++leftOut.nowhere;
            continue;
        }
        hasLabels = hasLabels || !measurement.label.empty();
        if (!measurement.label.empty() && !isDeidentified) each.label = measurement.label;
        each.trackingUid =
            isDeidentified ? dicom::newUid() : trackingUidOf(measurement, of.series.seriesInstanceUid);
        said.report.measurements.push_back(std::move(each));
    }
    leftOut.labels = hasLabels && isDeidentified;
    said.leftOut = sentencesOn(leftOut, measurements.size());
    if (said.report.measurements.empty() || places.first() == nullptr)
        return Error{ErrorCode::usage,
                     said.leftOut.empty() ? Text("There are no measurements to write.") : said.leftOut[0],
                     {},
                     measurements.empty() ? Text("Measure something on a slice first.")
                                          : Text("Save the measurements as a table.")};
    said.report.modality = of.stack.modality;
    said.report.series = {.seriesInstanceUid = of.series.seriesInstanceUid,
                          .frameOfReferenceUid = places.frameOfReferenceUid(),
                          .images = places.images()};
    said.image = {places.first()->file, places.first()->sopInstanceUid};
    return said;
}

Result<std::vector<Text>> writeMeasurementReport(const std::filesystem::path& path,
                                                 const ReportRequest& request) {
    const study::FoundVolume& of = request.found->volumes().at(request.volumeIndex);
    MACULA_TRY(SaidMeasurements said,
               saidMeasurements(request.measurements, {*request.volume, *of.series, *of.stack},
                                request.isDeidentified));
    const dicom::NewObject object{
        .image = said.image, .isDeidentified = request.isDeidentified, .softwareVersion = MACULA_VERSION};
    MACULA_TRY_VOID(dicom::writeMeasurementReport(path, said.report, object));
    return std::move(said.leftOut);
}

}  // namespace macula::scene
