#include "scene/slices/measurements_of_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/utf8.h"
#include "dicom/read/dataset.h"
#include "dicom/read/patient.h"
#include "scene/slices/shapes_of_report.h"
#include "study/open/found_volumes.h"

namespace macula::scene {

namespace {

using dicom::DocumentEntry;
using slices::Measurement;

constexpr std::size_t kMostMeasurements = 1000;
constexpr std::size_t kLongestLabel = 64;
constexpr double kOther = 0.02;  // of a number
constexpr std::size_t kNone = DocumentEntry::kNone;

Error notUsable(Text why, Text hint) {
    return {ErrorCode::inputNotUsable, std::move(why), {}, std::move(hint)};
}

bool isNamed(const DocumentEntry& entry, std::string_view code) {
    return entry.name.scheme == "DCM" && entry.name.value == code;
}

bool isAngle(const DocumentEntry& entry) {
    return entry.number && (entry.code.value == "deg" || entry.code.meaning == "degree");
}

// By SNOMED CT, or by the codes that older reports have (PS3.16 Annex D of 2018 and before).
bool isNamed(const DocumentEntry& entry, std::string_view sct, std::string_view srt) {
    const CodedName& name = entry.name;
    const bool isOld = name.scheme == "SRT" || name.scheme == "SNM3" || name.scheme == "99SDM";
    return (name.scheme == "SCT" && name.value == sct) || (isOld && (name.value == srt || name.value == sct));
}

bool isLongAxis(const DocumentEntry& entry) {
    return isNamed(entry, "103339001", "G-A185");
}

bool isShortAxis(const DocumentEntry& entry) {
    return isNamed(entry, "103340004", "G-A186");
}

bool isCobbAngle(const DocumentEntry& entry) {
    return isAngle(entry) && isNamed(entry, "285285000", "F-00E5C");
}

// A number in mm, mm² or degrees; nothing for other units.
std::optional<double> inUsualUnit(const DocumentEntry& entry, std::string_view usual) {
    struct Unit {
        std::string_view code, usual;
        double factor;
    };
    constexpr std::array kUnits = std::to_array<Unit>({{"mm", "mm", 1.0},
                                                       {"cm", "mm", 10.0},
                                                       {"um", "mm", 1e-3},
                                                       {"mm2", "mm2", 1.0},
                                                       {"cm2", "mm2", 100.0},
                                                       {"deg", "deg", 1.0}});
    for (const Unit& unit : kUnits) {
        if (entry.number && unit.code == entry.code.value && unit.usual == usual)
            return *entry.number * unit.factor;
    }
    return {};
}

bool isLength(const DocumentEntry& entry) {
    return inUsualUnit(entry, "mm").has_value();
}

using Why = WhyLeftOut;

// Points in patient space, and the normal of the image that they lie on, if they lie on one.
struct Placed {
    std::vector<glm::dvec3> pointsMm;
    std::optional<glm::dvec3> normal;
};

class Taker {
  public:
    Taker(const dicom::StudyDocument& report, const ReportedOn& of)
        : report_(report), of_(of), frameOfReferenceUid_(study::frameOfReferenceOf(of.stack)) {}

    void take(std::span<const Measurement> there) {
        for (std::size_t i = 0; i < report_.entries.size(); ++i) {
            if (!report_.entries[i].points) continue;
            if (otherAxisOf(i, isShortAxis, isLongAxis)) continue;  // comes with the long axis
            const auto made = measurementOf(i);
            if (const auto* why = std::get_if<Why>(&made)) {
                ++leftOut_[std::size_t(*why)];
                continue;
            }
            const auto& measurement = std::get<Measurement>(made);
            const auto isIt = [&](const Measurement& other) { return isSame(measurement, other); };
            // A report may name a shape once for each of its numbers.
            if (std::ranges::any_of(taken_, isIt)) continue;
            if (std::ranges::any_of(there, isIt)) {
                ++repeated_;
                continue;
            }
            if (taken_.size() == kMostMeasurements) {
                ++tooMany_;
                continue;
            }
            if (saysOtherwise(i, measurement)) ++otherwise_;
            taken_.push_back(measurement);
        }
    }

    std::vector<Measurement>& taken() { return taken_; }

    std::vector<Text> sentences() const {
        std::vector<Text> all;
        const auto say = [&](std::size_t count, Text sentence) {
            if (count > 0) all.push_back(std::move(sentence));
        };
        const auto of = [&](Why why) { return leftOut_[std::size_t(why)]; };
        say(of(Why::elsewhere),
            Text("Shapes that the report draws on images that are not open, and that were left out: {}.",
                 of(Why::elsewhere)));
        say(of(Why::notPlaced),
            Text("Shapes on images that do not say where they lie, and that were left out: {}.",
                 of(Why::notPlaced)));
        say(of(Why::otherShape),
            Text("Shapes that Macula does not measure, and that were left out: {}.", of(Why::otherShape)));
        say(of(Why::notRead),
            Text("Shapes whose points cannot be right, and that were left out: {}.", of(Why::notRead)));
        say(repeated_,
            Text("Measurements that are there already, and that were not taken again: {}.", repeated_));
        say(tooMany_, Text("The report has too many measurements; left out were {}.", tooMany_));
        say(otherwise_, Text("Macula measures another value between the same points than the report says: {} "
                             "measurements. Compare them with the report.",
                             otherwise_));
        return all;
    }

  private:
    const DocumentEntry& at(std::size_t i) const { return report_.entries[i]; }

    std::size_t groupOf(std::size_t i) const {
        for (std::size_t above = at(i).parent; above != kNone; above = at(above).parent)
            if (isNamed(at(above), "125007")) return above;
        return at(i).parent;
    }

    bool isBelow(std::size_t i, std::size_t above) const {
        for (; i != kNone; i = at(i).parent)
            if (i == above) return true;
        return false;
    }

    // The numbers that come from the shape: the one above it, otherwise those of its group.
    std::vector<std::size_t> numbersOf(std::size_t shape) const {
        const std::size_t parent = at(shape).parent;
        if (parent != kNone && at(parent).number) return {parent};
        std::vector<std::size_t> numbers;
        const std::size_t group = groupOf(shape);
        for (std::size_t i = group == kNone ? 0 : group; group != kNone && i < report_.entries.size(); ++i) {
            if (i > group && at(i).depth <= at(group).depth) break;
            if (at(i).number) numbers.push_back(i);
        }
        return numbers;
    }

    std::string labelOf(std::size_t shape) const {
        const std::size_t group = groupOf(shape);
        if (group == kNone) return {};
        for (std::size_t i = group + 1; i < report_.entries.size() && at(i).depth > at(group).depth; ++i) {
            if (!isNamed(at(i), "112039") || !isBelow(i, group)) continue;
            std::string label(startOf(at(i).value.english(), kLongestLabel));
            std::ranges::replace(label, '\n', ' ');
            return label;
        }
        return {};
    }

    const dicom::Frame* frameOf(const dicom::DocumentReference& reference) const {
        const int number = reference.frames.empty() ? 0 : reference.frames.front() - 1;
        for (const dicom::Frame& frame : of_.stack.frames) {
            if (!frame.instance || frame.instance->sopInstanceUid != reference.sopInstanceUid) continue;
            if (frame.number == number || frame.instance->frames == 1) return &frame;
        }
        return nullptr;
    }

    // The image below the shape that its points are on.
    const dicom::DocumentReference* imageOf(std::size_t shape) const {
        for (std::size_t i = shape + 1; i < report_.entries.size() && at(i).depth > at(shape).depth; ++i)
            if (at(i).parent == shape && !at(i).references.empty()) return &at(i).references.front();
        return nullptr;
    }

    std::variant<Placed, Why> place(std::size_t shape) const {
        const dicom::DrawnPoints& points = *at(shape).points;
        Placed placed;
        if (points.isInSpace) {
            if (frameOfReferenceUid_.empty() || points.frameOfReferenceUid != frameOfReferenceUid_)
                return Why::elsewhere;
            for (std::size_t i = 0; i + 2 < points.numbers.size(); i += 3)
                placed.pointsMm.emplace_back(points.numbers[i], points.numbers[i + 1], points.numbers[i + 2]);
            return placed;
        }
        const dicom::DocumentReference* image = imageOf(shape);
        const dicom::Frame* frame = image != nullptr ? frameOf(*image) : nullptr;
        if (frame == nullptr) return Why::elsewhere;
        if (!frame->plane || !isUsable(*frame->plane)) return Why::notPlaced;
        const dicom::ImagePlane& plane = *frame->plane;
        // PS3.3 C.18.6.1.2: (0.5, 0.5) is the middle of the first pixel.
        for (std::size_t i = 0; i + 1 < points.numbers.size(); i += 2)
            placed.pointsMm.push_back(
                plane.positionMm + (points.numbers[i] - 0.5) * plane.columnSpacingMm * plane.rowDirection +
                (points.numbers[i + 1] - 0.5) * plane.rowSpacingMm * plane.columnDirection);
        placed.normal = plane.normal();
        return placed;
    }

    // The points of the other axis of a lesion, where this shape is the one of an axis with that name.
    std::optional<std::size_t> otherAxisOf(std::size_t shape, bool (*isMine)(const DocumentEntry&),
                                           bool (*isOthers)(const DocumentEntry&)) const {
        const std::size_t parent = at(shape).parent;
        const std::size_t group = groupOf(shape);
        if (parent == kNone || group == kNone || !at(parent).number || !isMine(at(parent))) return {};
        for (std::size_t i = group + 1; i < report_.entries.size() && at(i).depth > at(group).depth; ++i) {
            const std::size_t above = at(i).parent;
            if (at(i).points && above != kNone && at(above).number && isOthers(at(above))) return i;
        }
        return {};
    }

    std::variant<Measurement, Why> measurementOf(std::size_t shape) const {
        auto placed = place(shape);
        if (const auto* why = std::get_if<Why>(&placed)) return *why;
        const auto& [mm, normal] = std::get<Placed>(placed);
        DrawnShape drawn{.type = at(shape).points->type,
                         .pointsMm = mm,
                         .shortAxisMm = {},
                         .normal = normal,
                         .hasAngle = hasNumber(shape, isAngle),
                         .isCobb = hasNumber(shape, isCobbAngle),
                         .hasLength = hasNumber(shape, isLength),
                         .usualNormals = usualNormals()};
        if (const auto other = otherAxisOf(shape, isLongAxis, isShortAxis)) {
            auto beside = place(*other);
            if (const auto* why = std::get_if<Why>(&beside)) return *why;
            drawn.shortAxisMm = std::get<Placed>(beside).pointsMm;
        }
        auto made = scene::measurementOf(drawn);
        if (auto* measurement = std::get_if<Measurement>(&made)) measurement->label = labelOf(shape);
        return made;
    }

    // That of the images, and those of the patient.
    std::vector<glm::dvec3> usualNormals() const {
        std::vector<glm::dvec3> normals{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
        if (!of_.stack.frames.empty() && of_.stack.frames.front().plane)
            normals.insert(normals.begin(), of_.stack.frames.front().plane->normal());
        return normals;
    }

    bool hasNumber(std::size_t shape, bool (*isIt)(const DocumentEntry&)) const {
        return std::ranges::any_of(numbersOf(shape), [&](std::size_t i) { return isIt(at(i)); });
    }

    // Whether the report has numbers for the shape in its unit, and none of them is what is measured.
    bool saysOtherwise(std::size_t shape, const Measurement& measurement) const {
        if (const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape)) {
            const slices::Axes axes = slices::axesOf(*lesion);
            const auto other = otherAxisOf(shape, isLongAxis, isShortAxis);
            return saysOtherwise(shape, axes.longMm, "mm") ||
                   (other && saysOtherwise(*other, axes.shortMm, "mm"));
        }
        const auto [measured, unit] = measuredOf(measurement);
        return saysOtherwise(shape, measured, unit);
    }

    bool saysOtherwise(std::size_t shape, double measured, std::string_view unit) const {
        bool hasOne = false;
        for (const std::size_t i : numbersOf(shape)) {
            const std::optional<double> number = inUsualUnit(at(i), unit);
            if (!number) continue;
            hasOne = true;
            if (std::abs(*number - measured) <= kOther * std::max(std::abs(*number), measured)) return false;
        }
        return hasOne;
    }

    // Of shapes with one number.
    static std::pair<double, std::string_view> measuredOf(const Measurement& measurement) {
        const auto& shape = measurement.shape;
        if (const auto* distance = std::get_if<slices::Distance>(&shape))
            return {slices::lengthMm(*distance), "mm"};
        if (const auto* line = std::get_if<slices::OpenLine>(&shape)) return {slices::lengthMm(*line), "mm"};
        if (const auto* angle = std::get_if<slices::Angle>(&shape)) return {slices::angleDeg(*angle), "deg"};
        if (const auto* cobb = std::get_if<slices::CobbAngle>(&shape))
            return {slices::angleDeg(*cobb), "deg"};
        if (const auto* outline = std::get_if<slices::Outline>(&shape))
            return {slices::areaMm2(*outline), "mm2"};
        return {slices::areaMm2(std::get<slices::Ellipse>(shape)), "mm2"};
    }

    const dicom::StudyDocument& report_;
    const ReportedOn& of_;
    std::string frameOfReferenceUid_;
    std::vector<Measurement> taken_;
    std::array<std::size_t, 4> leftOut_{};  // by Why
    std::size_t repeated_ = 0, tooMany_ = 0, otherwise_ = 0;
};

Result<void> checkOwner(const dicom::StudyDocument& report, const ReportedOn& of) {
    const Text hint("Open the study that the report is about.");
    if (of.stack.frames.empty() || !of.stack.frames.front().instance)
        return notUsable(Text("There are no images to measure on."), hint);
    const dicom::HeaderFile image = dicom::readHeader(of.stack.frames.front().instance->file);
    if (!image.header)
        return notUsable(Text("The images of the open study cannot be read again."),
                         Text("Check that the file or disc is still there."));
    if (dicom::patientIdentity(*image.header) != report.patient)
        return notUsable(Text("The report is of another patient than the study that is open."), hint);
    if (report.studyInstanceUid.empty() || report.studyInstanceUid != of.series.studyInstanceUid)
        return notUsable(Text("The report belongs to another study than the one that is open."), hint);
    return {};
}

}  // namespace

Result<MeasurementsOfReport> measurementsOf(const dicom::StudyDocument& report, const ReportedOn& of,
                                            std::span<const Measurement> there) {
    MACULA_TRY_VOID(checkOwner(report, of));
    Taker taker(report, of);
    taker.take(there);
    MeasurementsOfReport measurements{std::move(taker.taken()), taker.sentences()};
    if (measurements.taken.empty())
        return notUsable(measurements.leftOut.empty() ? Text("The report draws nothing that Macula measures.")
                                                      : measurements.leftOut.front(),
                         Text("Open the series that it was measured on."));
    return measurements;
}

}  // namespace macula::scene
