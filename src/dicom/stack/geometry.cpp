#include "dicom/stack/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace macula::dicom {

namespace {

constexpr double kDirectionTolerance = 1e-3;  // deviation from unit length and perpendicularity
constexpr double kExactDirection = 1e-4;      // files often have 5 or 6 decimals; beyond this it is repaired
constexpr double kSameDirection = 1e-4;       // per component, between slices
constexpr double kSameSpacing = 1e-4;         // relative
// No patient is this far away, and no pixel is this small or large. Beyond, rounding would hide the slice
// distances.
constexpr double kMostMm = 1e7;
constexpr double kLeastSpacingMm = 1e-6;
constexpr double kMostSpacingMm = 1e5;
constexpr double kUnevenErrorOfStep = 0.01;     // error of a slice's position that is worth a message
constexpr double kIrregularErrorOfStep = 0.10;  // and the one above which slices are resampled
constexpr double kExactOfStep = 0.01;           // a resampled slice this near to a plane is that plane
constexpr double kTiltWorthTellingDeg = 0.1;
constexpr double kMostTiltDeg = 60.0;  // gantries tilt by at most 30
constexpr double kDegPerRad = 57.29577951308232;

bool near(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z}) <= kSameDirection;
}

bool near(double a, double b) {
    return std::abs(a - b) <= kSameSpacing * std::max(std::abs(a), std::abs(b));
}

std::optional<Message> inconsistency(std::span<const StackedPlane> planes) {
    const ImagePlane& first = planes[0].plane;
    for (const StackedPlane& other : planes) {
        if (!isUsable(other.plane)) return message(key::kInvalidOrientation);
        if (!near(first.rowDirection, other.plane.rowDirection) ||
            !near(first.columnDirection, other.plane.columnDirection)) {
            return message(key::kNotParallel);
        }
        if (!near(first.columnSpacingMm, other.plane.columnSpacingMm) ||
            !near(first.rowSpacingMm, other.plane.rowSpacingMm)) {
            return message(key::kNotReconstructable, {{"reason", Text("their pixel spacings differ")}});
        }
    }
    return {};
}

// Repairs the directions of row and column where they are not quite perpendicular unit vectors: the row is
// kept, the column turned.
ImagePlane orthonormal(ImagePlane plane, std::vector<Message>& messages) {
    const double dot = glm::dot(plane.rowDirection, plane.columnDirection);
    const double worst = std::max({std::abs(dot), std::abs(glm::length(plane.rowDirection) - 1.0),
                                   std::abs(glm::length(plane.columnDirection) - 1.0)});
    if (worst <= kExactDirection) return plane;
    plane.rowDirection = glm::normalize(plane.rowDirection);
    plane.columnDirection = glm::normalize(
        plane.columnDirection - glm::dot(plane.rowDirection, plane.columnDirection) * plane.rowDirection);
    messages.push_back(message(key::kRepairedOrientation, {{"error", worst}}));
    return plane;
}

// Positions along the stack, ascending, and the distances between them.
struct Positions {
    std::vector<double> alongMm;
    std::vector<double> stepsMm;
    double usualMm = 0.0;  // the median distance

    double extentMm() const { return alongMm.back() - alongMm.front(); }
    double leastMm() const { return *std::min_element(stepsMm.begin(), stepsMm.end()); }
    double mostMm() const { return *std::max_element(stepsMm.begin(), stepsMm.end()); }
};

// The grid place of each position when all distances are multiples of the usual one; nothing otherwise.
std::optional<std::vector<std::size_t>> placesWithGaps(const Positions& positions) {
    std::vector<std::size_t> places{0};
    for (const double step : positions.stepsMm) {
        const double multiple = std::round(step / positions.usualMm);
        // The allowance does not grow with the gap: many irregular distances are near some multiple.
        if (multiple < 1.0 || multiple > 1e6 ||
            std::abs(step / positions.usualMm - multiple) > kIrregularErrorOfStep) {
            return {};
        }
        places.push_back(places.back() + static_cast<std::size_t>(multiple));
    }
    const double gridStep = (positions.alongMm.back() - positions.alongMm.front()) / double(places.back());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double error = positions.alongMm[k] - positions.alongMm.front() - gridStep * double(places[k]);
        if (std::abs(error) > kIrregularErrorOfStep * positions.usualMm) return {};
    }
    return places;
}

std::vector<SliceSource> slicesWithGaps(const std::vector<std::size_t>& places) {
    std::vector<SliceSource> slices{{0, 0, 0.0}};
    for (std::size_t k = 1; k < places.size(); ++k) {
        const std::size_t steps = places[k] - places[k - 1];
        for (std::size_t s = 1; s < steps; ++s) slices.push_back({k - 1, k, double(s) / double(steps)});
        slices.push_back({k, k, 0.0});
    }
    return slices;
}

// `count` slices, evenly from the first position to the last.
std::vector<SliceSource> slicesEvenly(const Positions& positions, std::size_t count) {
    const double first = positions.alongMm.front();
    const double step = (positions.alongMm.back() - first) / double(count - 1);
    std::vector<SliceSource> slices;
    std::size_t below = 0;
    for (std::size_t s = 0; s < count; ++s) {
        const double at = first + step * double(s);
        while (below + 2 < positions.alongMm.size() && positions.alongMm[below + 1] <= at) ++below;
        const double weight =
            std::clamp((at - positions.alongMm[below]) / positions.stepsMm[below], 0.0, 1.0);
        const double toleranceOfGap = kExactOfStep * step / positions.stepsMm[below];
        // If both planes are near enough, takes the nearer one.
        if (std::min(weight, 1.0 - weight) <= toleranceOfGap) {
            const std::size_t nearest = weight <= 0.5 ? below : below + 1;
            slices.push_back({nearest, nearest, 0.0});
        } else {
            slices.push_back({below, below + 1, weight});
        }
    }
    return slices;
}

// "5, 9-11": slices counted from 1, as they are on screen.
std::string listInterpolated(const std::vector<SliceSource>& slices) {
    std::string list;
    for (std::size_t k = 0; k < slices.size();) {
        std::size_t end = k;
        while (end < slices.size() && slices[end].interpolated()) ++end;
        if (end > k) {
            if (list.size() > 100) return list + ", …";
            list += fmt::format("{}{}", list.empty() ? "" : ", ", k + 1);
            if (end > k + 1) list += fmt::format("-{}", end);
        }
        k = end + 1;
    }
    return list;
}

// The position of each plane along the normal of the first one, in the order given.
std::vector<double> alongNormal(std::span<const StackedPlane> planes) {
    const glm::dvec3 normal = planes[0].plane.normal();
    std::vector<double> along;
    for (const StackedPlane& p : planes) along.push_back(glm::dot(p.plane.positionMm, normal));
    return along;
}

// The order of planes: ascending along the normal, then by instance number, then as given.
std::vector<std::size_t> sortedOrder(std::span<const StackedPlane> planes, const std::vector<double>& along) {
    std::vector<std::size_t> order(planes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const bool sortable = std::all_of(along.begin(), along.end(), [](double a) { return std::isfinite(a); });
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (sortable && along[a] != along[b]) return along[a] < along[b];
        return planes[a].instanceNumber < planes[b].instanceNumber;
    });
    return order;
}

// The positions of two planes or more, in order.
Positions positionsInOrder(const std::vector<std::size_t>& order, const std::vector<double>& along) {
    Positions positions;
    for (const std::size_t index : order) positions.alongMm.push_back(along[index]);
    for (std::size_t k = 1; k < order.size(); ++k) {
        positions.stepsMm.push_back(positions.alongMm[k] - positions.alongMm[k - 1]);
    }
    std::vector<double> sorted = positions.stepsMm;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    positions.usualMm = sorted[sorted.size() / 2];
    return positions;
}

std::optional<Message> duplicates(const Positions& positions) {
    const std::vector<double>& steps = positions.stepsMm;
    const auto count =
        std::count_if(steps.begin(), steps.end(), [](double s) { return s <= kSamePositionMm; });
    if (count == 0) return {};
    return message(key::kDuplicatePositions,
                   {{"count", std::int64_t(count)}, {"total", std::int64_t(positions.alongMm.size())}});
}

// The line on which the planes of a stack have to lie: from the first position to the last.
struct StackLine {
    ImagePlane first;  // orthonormal
    glm::dvec3 extentMm{0.0};
};

// The message if a plane lies off the line sideways, at whatever spacing, or the line runs along the planes.
std::optional<Message> offTheLine(std::span<const StackedPlane> planes, const std::vector<std::size_t>& order,
                                  const Positions& positions, const StackLine& line) {
    const ImagePlane& first = line.first;
    double largestSideways = 0.0;
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const double share = (positions.alongMm[k] - positions.alongMm.front()) / positions.extentMm();
        const glm::dvec3 error =
            planes[order[k]].plane.positionMm - (first.positionMm + share * line.extentMm);
        largestSideways = std::max(largestSideways, glm::length(error));
    }
    if (largestSideways > kIrregularErrorOfStep * std::max(positions.usualMm, first.columnSpacingMm)) {
        return message(key::kNotReconstructable,
                       {{"reason", Text("they are shifted sideways against each other")}});
    }
    if (!isInvertibleAffine(
            affine(first.rowDirection, first.columnDirection, line.extentMm, first.positionMm))) {
        return message(key::kNotReconstructable, {{"reason", Text("they lie beside each other")}});
    }
    return {};
}

// Sets the slices of the stack, and its quality where they are resampled; or says why there is no volume.
std::optional<Message> placeSlices(const Positions& positions, StackGeometry& stack) {
    const std::size_t planes = positions.alongMm.size();
    if (const auto places = placesWithGaps(positions)) {
        const std::size_t total = places->back() + 1;
        if (total > 2 * planes) {
            return message(key::kMissingSlices, Severity::blocksVolume,
                           {{"missing", std::int64_t(total - planes)},
                            {"total", std::int64_t(total)},
                            {"spacingMm", positions.usualMm}});
        }
        stack.slices = slicesWithGaps(*places);
        return {};
    }
    // The step between slices of the volume is fine enough for the smallest distance between planes, and
    // bounded from below: one pair of almost equal positions among wide distances must not make a volume of
    // thousands of slices, and a wide gap must not be filled with blended ones.
    constexpr double kMostSlicesPerPlane = 4.0;
    constexpr double kWideGapOfStep = 8.0;
    const double wantedMm =
        std::clamp(positions.leastMm(), positions.usualMm / kMostSlicesPerPlane, positions.usualMm);
    const double gridSteps = std::ceil(positions.extentMm() / wantedMm - 1e-6);
    if (positions.mostMm() > kWideGapOfStep * positions.usualMm ||
        !(gridSteps <= kMostSlicesPerPlane * double(planes))) {
        return message(key::kSpacingTooIrregular,
                       {{"leastMm", positions.leastMm()}, {"mostMm", positions.mostMm()}});
    }
    stack.slices = slicesEvenly(positions, static_cast<std::size_t>(gridSteps) + 1);
    stack.quality = StackGeometry::Quality::resampled;
    return {};
}

double gridStepMm(const Positions& positions, const StackGeometry& stack) {
    return positions.extentMm() / double(stack.slices.size() - 1);
}

glm::dvec3 sliceStepMm(const StackLine& line, const StackGeometry& stack) {
    return line.extentMm / double(stack.slices.size() - 1);
}

// Reports which slices are interpolated and why, and sets the final quality of the stack.
void tellSpacing(const Positions& positions, StackGeometry& stack) {
    const double spacingMm = gridStepMm(positions, stack);
    const auto interpolated = std::count_if(stack.slices.begin(), stack.slices.end(),
                                            [](const auto& s) { return s.interpolated(); });
    if (stack.quality == StackGeometry::Quality::resampled) {
        stack.messages.push_back(message(
            key::kIrregularSpacing,
            {{"leastMm", positions.leastMm()}, {"mostMm", positions.mostMm()}, {"spacingMm", spacingMm}}));
    } else if (interpolated > 0) {
        stack.messages.push_back(message(key::kMissingSlices, {{"missing", std::int64_t(interpolated)},
                                                               {"total", std::int64_t(stack.slices.size())},
                                                               {"spacingMm", spacingMm}}));
        stack.quality = StackGeometry::Quality::resampled;
    } else {
        stack.quality = StackGeometry::Quality::even;
    }
    if (interpolated > 0) {
        stack.messages.push_back(
            message(key::kGapInterpolated,
                    {{"count", std::int64_t(interpolated)}, {"slices", listInterpolated(stack.slices)}}));
    }
}

// Measures and reports how far planes that are slices lie from their place on the even grid.
void tellUnevenness(std::span<const StackedPlane> planes, const Positions& positions, const StackLine& line,
                    StackGeometry& stack) {
    const glm::dvec3 sliceStep = sliceStepMm(line, stack);
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        if (stack.slices[k].interpolated()) continue;
        const glm::dvec3 error = planes[stack.order[stack.slices[k].below]].plane.positionMm -
                                 (line.first.positionMm + double(k) * sliceStep);
        stack.largestErrorMm = std::max(stack.largestErrorMm, glm::length(error));
    }
    if (stack.largestErrorMm > kUnevenErrorOfStep * gridStepMm(positions, stack)) {
        stack.messages.push_back(message(key::kUnevenSpacing, {{"errorMm", stack.largestErrorMm}}));
    }
}

// The angle between the step from slice to slice and the normal of the planes: 0 unless the gantry was
// tilted.
double tiltDegOf(const StackLine& line, const StackGeometry& stack) {
    const double cosTilt = std::clamp(
        glm::dot(glm::normalize(sliceStepMm(line, stack)), glm::normalize(line.first.normal())), -1.0, 1.0);
    return std::acos(cosTilt) * kDegPerRad;
}

}  // namespace

bool isUsable(const ImagePlane& plane) {
    const auto within = [](double value, double target) {
        return std::abs(value - target) <= kDirectionTolerance;
    };
    const auto isNear = [](double mm) { return std::abs(mm) <= kMostMm; };  // false for NaN
    const auto isSpacing = [](double mm) { return mm >= kLeastSpacingMm && mm <= kMostSpacingMm; };
    return within(glm::length(plane.rowDirection), 1.0) && within(glm::length(plane.columnDirection), 1.0) &&
           within(glm::dot(plane.rowDirection, plane.columnDirection), 0.0) &&
           isSpacing(plane.columnSpacingMm) && isSpacing(plane.rowSpacingMm) && isNear(plane.positionMm.x) &&
           isNear(plane.positionMm.y) && isNear(plane.positionMm.z);
}

StackGeometry stackPlanes(std::span<const StackedPlane> planes) {
    StackGeometry stack;
    if (planes.empty()) return stack;
    const std::vector<double> along = alongNormal(planes);
    stack.order = sortedOrder(planes, along);

    const auto fail = [&](Message why) {
        stack.quality = StackGeometry::Quality::none;
        stack.slices.clear();
        stack.messages.push_back(std::move(why));
        return stack;
    };
    if (auto problem = inconsistency(planes)) return fail(std::move(*problem));
    if (planes.size() < 2) return fail(message(key::kSingleSlice));
    const Positions positions = positionsInOrder(stack.order, along);
    if (auto problem = duplicates(positions)) return fail(std::move(*problem));

    StackLine line{orthonormal(planes[stack.order.front()].plane, stack.messages)};
    line.extentMm = planes[stack.order.back()].plane.positionMm - line.first.positionMm;
    if (auto problem = offTheLine(planes, stack.order, positions, line)) return fail(std::move(*problem));
    if (auto problem = placeSlices(positions, stack)) return fail(std::move(*problem));
    tellSpacing(positions, stack);
    tellUnevenness(planes, positions, line, stack);

    const double tiltDeg = tiltDegOf(line, stack);
    if (tiltDeg > kMostTiltDeg) {
        return fail(message(key::kNotReconstructable,
                            {{"reason", Text("each is shifted sideways against the one before")}}));
    }
    if (tiltDeg > kTiltWorthTellingDeg) {
        stack.messages.push_back(message(key::kTiltedStack, {{"degrees", tiltDeg}}));
    }
    const ImagePlane& first = line.first;
    stack.worldFromVoxel =
        affine(first.rowDirection * first.columnSpacingMm, first.columnDirection * first.rowSpacingMm,
               sliceStepMm(line, stack), first.positionMm);
    return stack;
}

}  // namespace macula::dicom
