// Frames and affine maths. World is patient LPS in millimetres: +x to the patient's Left, +y to Posterior, +z
// to Superior (DICOM PS3.3 C.7.6.2.1.1). Voxel coordinates (i, j, k) = (column, row, slice) are continuous,
// with integers at voxel centres. A transform named bFromA takes coordinates in frame a to frame b.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>

namespace macula {

// Box in any frame. Empty when low > high in some axis.
struct Box {
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};

    glm::dvec3 centre() const { return 0.5 * (low + high); }
    double diagonal() const { return glm::length(high - low); }
};

// Bit n of the index is set at the high end of axis n.
std::array<glm::dvec3, 8> cornersOf(const Box& box);

inline glm::dvec3 transformPoint(const glm::dmat4& bFromA, const glm::dvec3& point) {
    return glm::dvec3(bFromA * glm::dvec4(point, 1.0));
}

inline glm::dvec3 transformVector(const glm::dmat4& bFromA, const glm::dvec3& vector) {
    return glm::dmat3(bFromA) * vector;
}

// The affine transform that maps the unit vectors to these columns, and (0, 0, 0) to `origin`.
glm::dmat4 affine(const glm::dvec3& columnI, const glm::dvec3& columnJ, const glm::dvec3& columnK,
                  const glm::dvec3& origin);

// True if all entries are finite and the three axes span a volume, whatever their lengths.
bool isInvertibleAffine(const glm::dmat4& transform);

// The anatomical letters of a direction in LPS, largest component first, for components above 0.0001: "L",
// "PS", "RAI".
std::string orientationLetters(const glm::dvec3& directionLps);

// The direction from which a patient is seen. `anterior` looks from in front of the patient: the patient's
// left is then on the right side of the picture, as in every radiological display. The last three also look
// from the front, but somewhat from the patient's left and from above (obliquenessOf): `oblique` suits a thin
// stack of slices, `threeQuarter` a head, as in a portrait, and `turned` a body, whose contents then show
// depth.
enum class ViewDirection {
    anterior,
    posterior,
    left,
    right,
    superior,
    inferior,
    oblique,
    threeQuarter,
    turned
};

struct Obliqueness {
    double azimuthDeg = 0.0;    // towards the patient's left
    double elevationDeg = 0.0;  // upwards
};
// The angles of the last three directions; zero for all others.
constexpr Obliqueness obliquenessOf(ViewDirection from) {
    if (from == ViewDirection::oblique) return {25.0, 35.0};
    if (from == ViewDirection::threeQuarter) return {35.0, 15.0};
    if (from == ViewDirection::turned) return {20.0, 8.0};
    return {};
}

}  // namespace macula
