#include "study/planar/linked_frames.h"

#include <cmath>

namespace macula::study {

namespace {

constexpr double kParallel = 0.9396926207859084;  // cosine of 20 degrees
constexpr double kAcross = 0.7071067811865476;    // and of 45

glm::dvec3 middleOf(const dicom::Frame& frame) {
    const dicom::ImagePlane& plane = *frame.plane;
    return plane.positionMm +
           plane.rowDirection * (0.5 * (frame.instance->columns - 1) * plane.columnSpacingMm) +
           plane.columnDirection * (0.5 * (frame.instance->rows - 1) * plane.rowSpacingMm);
}

double cosineOf(const dicom::ImagePlane& a, const dicom::ImagePlane& b) {
    return std::abs(glm::dot(a.normal(), b.normal()));
}

// NaN compares as false.
bool areParallel(const dicom::Frame& a, const dicom::Frame& b) {
    return a.plane && b.plane && cosineOf(*a.plane, *b.plane) >= kParallel;
}

}  // namespace

bool shareFrameOfReference(const dicom::Frame& a, const dicom::Frame& b) {
    return !a.frameOfReferenceUid.empty() && a.frameOfReferenceUid == b.frameOfReferenceUid;
}

std::optional<double> shiftMm(const dicom::Frame& from, const dicom::Frame& to) {
    if (!areParallel(from, to)) return {};
    if (shareFrameOfReference(from, to)) return 0.0;
    const double shift = glm::dot(from.plane->normal(), middleOf(to) - middleOf(from));
    return std::isfinite(shift) ? std::optional(shift) : std::nullopt;
}

std::optional<std::size_t> linkedFrame(const dicom::Frame& from, const dicom::Stack& to, double shiftMm) {
    if (!from.plane) return {};
    const glm::dvec3 normal = from.plane->normal();
    const double wanted = glm::dot(normal, middleOf(from)) + shiftMm;
    std::optional<std::size_t> nearest;
    double least = 0.0;
    for (std::size_t i = 0; i < to.frames.size(); ++i) {
        const dicom::Frame& frame = to.frames[i];
        if (!areParallel(from, frame)) continue;
        const double away = std::abs(glm::dot(normal, middleOf(frame)) - wanted);
        if (std::isfinite(away) && (!nearest || away < least - dicom::kSamePositionMm)) {
            nearest = i;
            least = away;
        }
    }
    return nearest;
}

std::optional<std::array<glm::dvec2, 4>> outlineOn(const dicom::Frame& on, const dicom::Frame& image) {
    if (!on.plane || !image.plane || !shareFrameOfReference(on, image)) return {};
    const dicom::ImagePlane& plane = *on.plane;
    if (!(cosineOf(plane, *image.plane) <= kAcross) || !(plane.columnSpacingMm > 0.0) ||
        !(plane.rowSpacingMm > 0.0))
        return {};
    const double right = image.instance->columns - 0.5;
    const double bottom = image.instance->rows - 0.5;
    const std::array<glm::dvec2, 4> corners{glm::dvec2(-0.5), glm::dvec2(right, -0.5),
                                            glm::dvec2(right, bottom), glm::dvec2(-0.5, bottom)};
    std::array<glm::dvec2, 4> outline{};
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const glm::dvec3 mm = image.plane->positionMm +
                              image.plane->rowDirection * (corners[c].x * image.plane->columnSpacingMm) +
                              image.plane->columnDirection * (corners[c].y * image.plane->rowSpacingMm);
        const glm::dvec3 from = mm - plane.positionMm;
        outline[c] = glm::dvec2(glm::dot(from, plane.rowDirection) / plane.columnSpacingMm + 0.5,
                                glm::dot(from, plane.columnDirection) / plane.rowSpacingMm + 0.5);
    }
    return outline;
}

}  // namespace macula::study
