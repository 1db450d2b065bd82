#include "dicom/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace macula::dicom {

namespace {

constexpr double kDirectionTolerance = 1e-3;  // of unit length and perpendicularity
constexpr double kSameDirection = 1e-4;       // per component, between slices: files often have 6 decimals
constexpr double kSameSpacing = 1e-4;         // relative
constexpr double kSamePositionMm = 1e-3;
constexpr double kUnevenErrorOfStep = 0.01;     // error of a slice's position that is worth telling
constexpr double kIrregularErrorOfStep = 0.10;  // and the one above which nothing is shown
constexpr double kTiltWorthTellingDeg = 0.1;
constexpr double kDegPerRad = 57.29577951308232;

bool near(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z}) <= kSameDirection;
}

bool near(double a, double b) {
    return std::abs(a - b) <= kSameSpacing * std::max(std::abs(a), std::abs(b));
}

Message blocking(std::string_view key, std::string sentence, std::string action) {
    return {Severity::blocksVolume, std::string(key), std::move(sentence), std::move(action)};
}

std::optional<Message> inconsistency(std::span<const StackedPlane> planes) {
    const ImagePlane& first = planes[0].plane;
    for (const StackedPlane& other : planes) {
        if (!isUsable(other.plane)) {
            return blocking(key::kInvalidOrientation,
                            "The orientation or pixel spacing of a slice is not a valid one.",
                            "Export the series again, or choose another.");
        }
        if (!near(first.rowDirection, other.plane.rowDirection) ||
            !near(first.columnDirection, other.plane.columnDirection)) {
            return blocking(
                key::kInconsistentOrientation, "The slices of this series are not parallel to each other.",
                "Choose another series; a localizer, or reformatted images, may be mixed into this one.");
        }
        if (!near(first.columnSpacingMm, other.plane.columnSpacingMm) ||
            !near(first.rowSpacingMm, other.plane.rowSpacingMm)) {
            return blocking(key::kInconsistentPixelSpacing,
                            "The slices of this series have different pixel spacings.",
                            "Choose another series.");
        }
    }
    return {};
}

// Says what is wrong with steps that are not even: a gap that is a multiple of the usual step is a missing
// slice.
Message irregular(std::span<const double> steps, double usual) {
    std::size_t missing = 0;
    for (const double step : steps) {
        const double multiple = std::round(step / usual);
        if (multiple >= 2.0 && std::abs(step / usual - multiple) <= kIrregularErrorOfStep) {
            missing += static_cast<std::size_t>(multiple) - 1;
        } else if (std::abs(step / usual - 1.0) > kIrregularErrorOfStep) {
            const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
            return blocking(key::kIrregularSpacing,
                            fmt::format("The slices are unevenly spaced: between {:.3f} and {:.3f} mm apart.",
                                        *least, *most),
                            "Choose an evenly spaced series of this study.");
        }
    }
    if (missing == 0) {
        return blocking(
            key::kIrregularSpacing,
            fmt::format("The distance between slices drifts along the stack; it is {:.3f} mm in the middle "
                        "of the range.",
                        usual),
            "Choose an evenly spaced series of this study.");
    }
    return blocking(
        key::kMissingSlices,
        fmt::format("{} missing between slices that are {:.3f} mm apart.",
                    missing == 1 ? std::string("One slice is") : fmt::format("{} slices are", missing),
                    usual),
        "Copy the whole series again from its source.");
}

}  // namespace

bool isUsable(const ImagePlane& plane) {
    const auto within = [](double value, double target) {
        return std::abs(value - target) <= kDirectionTolerance;
    };
    return within(glm::length(plane.rowDirection), 1.0) && within(glm::length(plane.columnDirection), 1.0) &&
           within(glm::dot(plane.rowDirection, plane.columnDirection), 0.0) && plane.columnSpacingMm > 0.0 &&
           plane.rowSpacingMm > 0.0;
}

Stack stackPlanes(std::span<const StackedPlane> planes) {
    Stack stack;
    stack.order.resize(planes.size());
    std::iota(stack.order.begin(), stack.order.end(), std::size_t{0});
    if (planes.empty()) return stack;

    const glm::dvec3 normal = planes[0].plane.normal();
    std::vector<double> along;
    for (const StackedPlane& p : planes) along.push_back(glm::dot(p.plane.positionMm, normal));
    std::stable_sort(stack.order.begin(), stack.order.end(), [&](std::size_t a, std::size_t b) {
        if (along[a] != along[b]) return along[a] < along[b];
        return planes[a].instanceNumber < planes[b].instanceNumber;
    });

    const auto fail = [&](Message message) {
        stack.messages.push_back(std::move(message));
        return stack;
    };
    if (auto problem = inconsistency(planes)) return fail(std::move(*problem));
    if (planes.size() < 2) {
        return fail(blocking(key::kSingleSlice, "The series has only one slice.",
                             "Choose a series with more slices."));
    }

    std::vector<double> steps;
    for (std::size_t k = 1; k < planes.size(); ++k)
        steps.push_back(along[stack.order[k]] - along[stack.order[k - 1]]);
    const auto duplicates =
        std::count_if(steps.begin(), steps.end(), [](double s) { return s <= kSamePositionMm; });
    if (duplicates > 0) {
        return fail(
            blocking(key::kDuplicatePositions,
                     fmt::format("{} of the {} slices lie at the same position as another.", duplicates,
                                 planes.size()),
                     "The series may hold several time points, echoes or copies; choose another series."));
    }
    std::vector<double> sorted = steps;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    const double usual = sorted[sorted.size() / 2];

    const ImagePlane& first = planes[stack.order.front()].plane;
    const ImagePlane& last = planes[stack.order.back()].plane;
    const glm::dvec3 sliceStep =
        (last.positionMm - first.positionMm) / static_cast<double>(planes.size() - 1);
    double largestAlong = 0.0;
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const glm::dvec3 error =
            planes[stack.order[k]].plane.positionMm - (first.positionMm + static_cast<double>(k) * sliceStep);
        stack.largestErrorMm = std::max(stack.largestErrorMm, glm::length(error));
        largestAlong = std::max(largestAlong, std::abs(glm::dot(error, normal)));
    }
    const bool stepsUneven = std::any_of(steps.begin(), steps.end(), [&](double step) {
        return std::abs(step / usual - 1.0) > 2.0 * kIrregularErrorOfStep;
    });
    if (stepsUneven || largestAlong > kIrregularErrorOfStep * usual) return fail(irregular(steps, usual));
    if (stack.largestErrorMm > kIrregularErrorOfStep * std::max(usual, first.columnSpacingMm)) {
        return fail(blocking(key::kSlicesNotInLine, "The slices are shifted sideways against each other.",
                             "Choose another series."));
    }
    if (stack.largestErrorMm > kUnevenErrorOfStep * usual) {
        stack.messages.push_back(
            {Severity::warning, std::string(key::kUnevenSpacing),
             fmt::format("The slices are not quite evenly spaced: a slice is up to {:.3f} mm away "
                         "from where it is drawn.",
                         stack.largestErrorMm),
             "Allow for this error when measuring across slices."});
    }
    const double cosTilt = std::clamp(glm::dot(glm::normalize(sliceStep), glm::normalize(normal)), -1.0, 1.0);
    if (const double tiltDeg = std::acos(cosTilt) * kDegPerRad; tiltDeg > kTiltWorthTellingDeg) {
        stack.messages.push_back(
            {Severity::info, std::string(key::kTiltedStack),
             fmt::format("The slices are stacked at an angle of {:.1f} degrees (tilted gantry), and "
                         "are drawn so.",
                         tiltDeg),
             "Nothing to do."});
    }
    stack.worldFromVoxel = affine(first.rowDirection * first.columnSpacingMm,
                                  first.columnDirection * first.rowSpacingMm, sliceStep, first.positionMm);
    return stack;
}

}  // namespace macula::dicom
