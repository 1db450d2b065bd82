#include "scene/slices/measurements_of_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/is_finite.h"
#include "base/utf8.h"
#include "dicom/read/dataset.h"
#include "dicom/read/patient.h"
#include "study/open/found_volumes.h"

namespace macula::scene {

namespace {

using dicom::DocumentEntry;
using slices::Measurement;

constexpr std::size_t kMostMeasurements = 1000;
constexpr std::size_t kLongestLabel = 64;
constexpr double kFarthestMm = 1e6;
constexpr double kSameMm = 1e-3;
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

// Why a shape is left out.
enum class Why { elsewhere, notPlaced, notRead, otherShape };

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
            Text("Shapes that are no distance, angle or ellipse, and that were left out: {}.",
                 of(Why::otherShape)));
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

    std::variant<Measurement, Why> measurementOf(std::size_t shape) const {
        auto placed = place(shape);
        if (const auto* why = std::get_if<Why>(&placed)) return *why;
        const auto& [mm, normal] = std::get<Placed>(placed);
        for (const glm::dvec3& each : mm) {
            if (!isFinite(each) || std::abs(each.x) > kFarthestMm || std::abs(each.y) > kFarthestMm ||
                std::abs(each.z) > kFarthestMm)
                return Why::notRead;
        }
        Measurement made{.label = labelOf(shape), .shape = slices::Distance{}};
        const std::string& type = at(shape).points->type;
        if (type == "POLYLINE" && mm.size() == 2) {
            if (glm::length(mm[1] - mm[0]) < kSameMm) return Why::notRead;
            made.shape = slices::Distance{{mm[0], mm[1]}};
            made.normal = normal ? *normal : normalBeside(mm[1] - mm[0]);
            return made;
        }
        if (type == "POLYLINE" && mm.size() == 3 && hasAngle(shape)) {
            const glm::dvec3 across = glm::cross(mm[0] - mm[1], mm[2] - mm[1]);
            if (!(glm::length(mm[0] - mm[1]) > kSameMm && glm::length(mm[2] - mm[1]) > kSameMm))
                return Why::notRead;
            made.shape = slices::Angle{{mm[0], mm[1], mm[2]}};
            made.normal = normal                          ? *normal
                          : glm::length(across) > kSameMm ? glm::normalize(across)
                                                          : normalBeside(mm[0] - mm[1]);
            return made;
        }
        if (type == "CIRCLE" && mm.size() == 2 && normal) return circle(std::move(made), mm, *normal);
        if (type == "ELLIPSE" && mm.size() == 4) return ellipse(std::move(made), mm, normal);
        return Why::otherShape;
    }

    bool hasAngle(std::size_t shape) const {
        return std::ranges::any_of(numbersOf(shape), [&](std::size_t i) { return isAngle(at(i)); });
    }

    static std::variant<Measurement, Why> circle(Measurement made, const std::vector<glm::dvec3>& mm,
                                                 const glm::dvec3& normal) {
        const double radiusMm = glm::length(mm[1] - mm[0]);
        if (!(radiusMm > kSameMm)) return Why::notRead;
        const glm::dvec3 right = (mm[1] - mm[0]) / radiusMm;
        made.shape = slices::Ellipse{.plane = {mm[0], right, glm::normalize(glm::cross(normal, right))},
                                     .radiiMm = glm::dvec2(radiusMm)};
        made.normal = normal;
        return made;
    }

    // Both ends of one axis, then of the other (PS3.3 C.18.6.1.2).
    static std::variant<Measurement, Why> ellipse(Measurement made, const std::vector<glm::dvec3>& mm,
                                                  const std::optional<glm::dvec3>& normal) {
        const glm::dvec3 first = 0.5 * (mm[1] - mm[0]);
        const glm::dvec3 second = 0.5 * (mm[3] - mm[2]);
        const glm::dvec2 radiiMm{glm::length(first), glm::length(second)};
        if (!(radiiMm.x > kSameMm && radiiMm.y > kSameMm)) return Why::notRead;
        const glm::dvec3 centre = 0.5 * (mm[0] + mm[1]);
        constexpr double kSquare = 0.02;
        const double apartMm = glm::length(centre - 0.5 * (mm[2] + mm[3]));
        const glm::dvec3 right = first / radiiMm.x;
        if (apartMm > kSquare * std::max(radiiMm.x, radiiMm.y) ||
            std::abs(glm::dot(right, second / radiiMm.y)) > kSquare)
            return Why::notRead;
        glm::dvec3 down = glm::normalize(second - glm::dot(second, right) * right);
        if (normal && glm::dot(glm::cross(right, down), *normal) < 0.0) down = -down;
        made.shape = slices::Ellipse{.plane = {centre, right, down}, .radiiMm = radiiMm};
        made.normal = glm::cross(right, down);
        return made;
    }

    // Of the plane with a line in space that is nearest to one that people look at: that of the images, or
    // one of the patient.
    glm::dvec3 normalBeside(const glm::dvec3& line) const {
        std::vector<glm::dvec3> normals{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
        if (!of_.stack.frames.empty() && of_.stack.frames.front().plane)
            normals.insert(normals.begin(), of_.stack.frames.front().plane->normal());
        const glm::dvec3 along = glm::normalize(line);
        const auto nearest = std::ranges::min_element(
            normals, {}, [&](const glm::dvec3& normal) { return std::abs(glm::dot(normal, along)); });
        return glm::normalize(*nearest - glm::dot(*nearest, along) * along);
    }

    static bool isSame(const Measurement& a, const Measurement& b) {
        const std::vector<glm::dvec3> mine = slices::pointsOf(a);
        const std::vector<glm::dvec3> others = slices::pointsOf(b);
        if (a.shape.index() != b.shape.index() || mine.size() != others.size()) return false;
        if (const auto* ellipse = std::get_if<slices::Ellipse>(&a.shape))
            return isSame(*ellipse, std::get<slices::Ellipse>(b.shape));
        for (std::size_t i = 0; i < mine.size(); ++i)
            if (!(glm::length(mine[i] - others[i]) <= kSameMm)) return false;
        return true;
    }

    // Whichever of its axes is called right.
    static bool isSame(const slices::Ellipse& a, const slices::Ellipse& b) {
        const auto along = [](const glm::dvec3& p, const glm::dvec3& q) {
            return glm::length(p - q) <= kSameMm || glm::length(p + q) <= kSameMm;
        };
        const glm::dvec3 a0 = a.radiiMm.x * a.plane.right, a1 = a.radiiMm.y * a.plane.down;
        const glm::dvec3 b0 = b.radiiMm.x * b.plane.right, b1 = b.radiiMm.y * b.plane.down;
        return glm::length(a.plane.centreMm - b.plane.centreMm) <= kSameMm &&
               ((along(a0, b0) && along(a1, b1)) || (along(a0, b1) && along(a1, b0)));
    }

    // Whether the report has numbers for the shape in its unit, and none of them is what is measured.
    bool saysOtherwise(std::size_t shape, const Measurement& measurement) const {
        double measured = 0.0;
        std::string_view unit = "mm";
        if (const auto* distance = std::get_if<slices::Distance>(&measurement.shape)) {
            measured = slices::lengthMm(*distance);
        } else if (const auto* angle = std::get_if<slices::Angle>(&measurement.shape)) {
            measured = slices::angleDeg(*angle);
            unit = "deg";
        } else {
            measured = slices::areaMm2(std::get<slices::Ellipse>(measurement.shape));
            unit = "mm2";
        }
        bool hasOne = false;
        for (const std::size_t i : numbersOf(shape)) {
            const std::optional<double> number = inUsualUnit(at(i), unit);
            if (!number) continue;
            hasOne = true;
            if (std::abs(*number - measured) <= kOther * std::max(std::abs(*number), measured)) return false;
        }
        return hasOne;
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
        return notUsable(measurements.leftOut.empty()
                             ? Text("The report draws no distance, angle or ellipse.")
                             : measurements.leftOut.front(),
                         Text("Open the series that it was measured on."));
    return measurements;
}

}  // namespace macula::scene
