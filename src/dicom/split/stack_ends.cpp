#include "dicom/split/stack_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace macula::dicom {

namespace {

// How far along the normal of `stack` a place lies from its first slice.
double alongMm(const Stack& stack, const glm::dvec3& placeMm) {
    const ImagePlane& first = *stack.frames.front().plane;
    return glm::dot(placeMm - first.positionMm, first.normal());
}

double lengthMm(const Stack& stack) {
    return alongMm(stack, *stack.lastPositionMm);
}

bool shareFrameOfReference(const Stack& a, const Stack& b) {
    const std::string& uid = a.frames.front().frameOfReferenceUid;
    return !uid.empty() && uid == b.frames.front().frameOfReferenceUid;
}

}  // namespace

Text sideBeyond(const Stack& stack, StackEnd end) {
    const glm::dvec3 normal = stack.frames.front().plane->normal();
    const glm::dvec3 out = end == StackEnd::last ? normal : -normal;
    const glm::dvec3 size = glm::abs(out);
    if (size.z >= size.x && size.z >= size.y) return out.z > 0.0 ? Text("head") : Text("feet");
    if (size.y >= size.x) return out.y > 0.0 ? Text("back") : Text("front");
    return out.x > 0.0 ? Text("left") : Text("right");
}

double stepMm(const Stack& stack) {
    return stack.frames.size() < 2 ? 0.0 : lengthMm(stack) / double(stack.frames.size() - 1);
}

std::optional<Reach> reachOfParallel(const Stack& stack, const Stack& other) {
    constexpr double kParallel = 0.999;
    if (!stack.firstPositionMm || !other.firstPositionMm || !shareFrameOfReference(stack, other)) return {};
    const double cosine =
        glm::dot(stack.frames.front().plane->normal(), other.frames.front().plane->normal());
    if (std::abs(cosine) < kParallel) return {};
    const double a = alongMm(stack, *other.firstPositionMm);
    const double b = alongMm(stack, *other.lastPositionMm);
    return Reach{std::min(a, b), std::max(a, b)};
}

std::optional<Reach> reachOfLocalizer(const Stack& stack, const Stack& localizer) {
    constexpr double kAcross = 0.1;
    if (!stack.firstPositionMm || !shareFrameOfReference(stack, localizer)) return {};
    Reach reach{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (const Frame& frame : localizer.frames) {
        if (!frame.plane || !isUsable(*frame.plane)) continue;
        const ImagePlane& plane = *frame.plane;
        if (std::abs(glm::dot(plane.normal(), stack.frames.front().plane->normal())) > kAcross) continue;
        const glm::dvec3 row = plane.rowDirection * plane.columnSpacingMm * double(localizer.columns - 1);
        const glm::dvec3 column = plane.columnDirection * plane.rowSpacingMm * double(localizer.rows - 1);
        for (const glm::dvec3& corner : std::array{glm::dvec3(0.0), row, column, row + column}) {
            const double at = alongMm(stack, plane.positionMm + corner);
            reach = {std::min(reach.firstMm, at), std::max(reach.lastMm, at)};
        }
    }
    if (reach.firstMm > reach.lastMm) return {};
    return reach;
}

double beyondMm(const Stack& stack, const Reach& reach, StackEnd end) {
    return end == StackEnd::first ? -reach.firstMm : reach.lastMm - lengthMm(stack);
}

bool endsAlike(const Stack& stack, const Stack& other, const Reach& reach, StackEnd end) {
    constexpr double kSlices = 1.5;
    return std::abs(beyondMm(stack, reach, end)) <= kSlices * std::max(stepMm(stack), stepMm(other));
}

}  // namespace macula::dicom
