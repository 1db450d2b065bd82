// Which part of a volume is shown. World frame: patient LPS, mm.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/frames.h"
#include "base/label_map.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula {

enum class Keep { inside, outside };

class JsonNode;
using BoxCorners = std::array<glm::dvec3, 8>;

// A shape of a clip. kKey names it in JSON and in digests; kHasKeep says whether a person chooses what is
// kept, its inside or its outside. Each has a line in forEachPart below, and its functions in clip_shapes/.
template <class T>
concept ClipShape = std::equality_comparable<T> && requires(const T& shape) {
    { T::kKey } -> std::convertible_to<std::string_view>;
    { T::kHasKeep } -> std::convertible_to<bool>;
    { shape.numbers() } -> std::same_as<std::vector<double>>;  // all that it is made of
    { shape.check() } -> std::same_as<Result<void>>;           // as validate does
};

// Also a shape of which a clip has one. In a preset its numbers are fractions of a volume's box.
template <class T>
concept SingleClipShape = ClipShape<T> && requires(T& changed, const Box& volume, const JsonNode& node) {
    changed.toMm(volume);
    changed.toFractions(volume);
    { T::read(node) } -> std::same_as<T>;  // without "keep"
    static_cast<nlohmann::ordered_json (T::*)() const>(&T::json);
};

struct OrientedBox {
    static constexpr std::string_view kKey = "box";
    static constexpr bool kHasKeep = true;

    glm::dvec3 centreMm{0.0};
    glm::dmat3 axes{1.0};  // columns: orthonormal
    glm::dvec3 halfSizeMm{1.0};

    bool operator==(const OrientedBox&) const = default;

    std::vector<double> numbers() const;
    Result<void> check() const;
    void toMm(const Box& volume);
    void toFractions(const Box& volume);
    static OrientedBox read(const JsonNode& node);
    nlohmann::ordered_json json() const;
};

// The points with dot(normal, p) >= offsetMm, which a clip keeps; normal is a unit vector.
struct HalfSpace {
    static constexpr std::string_view kKey = "plane";
    static constexpr bool kHasKeep = false;

    glm::dvec3 normal{0.0, 1.0, 0.0};
    double offsetMm = 0.0;

    bool operator==(const HalfSpace&) const = default;

    std::vector<double> numbers() const;
    Result<void> check() const;
    bool contains(const glm::dvec3& pointMm) const { return glm::dot(normal, pointMm) >= offsetMm; }
};

// One of the eight octants around a point, in the direction `towards`, whose components are 1 or -1 (L, P and
// S are positive). A clip removes it.
struct Octant {
    static constexpr std::string_view kKey = "cut";
    static constexpr bool kHasKeep = false;

    glm::dvec3 pointMm{0.0};
    glm::dvec3 towards{1.0, -1.0, 1.0};

    bool operator==(const Octant&) const = default;

    std::vector<double> numbers() const;
    Result<void> check() const;
    void toMm(const Box& volume);
    void toFractions(const Box& volume);
    static Octant read(const JsonNode& node);
    nlohmann::ordered_json json() const;
};

struct Ball {
    static constexpr std::string_view kKey = "ball";
    static constexpr bool kHasKeep = true;

    glm::dvec3 centreMm{0.0};
    double radiusMm = 1.0;

    bool operator==(const Ball&) const = default;

    std::vector<double> numbers() const;
    Result<void> check() const;
    void toMm(const Box& volume);
    void toFractions(const Box& volume);
    static Ball read(const JsonNode& node);
    nlohmann::ordered_json json() const;
};

// The half-spaces whose intersection is the shape.
std::array<HalfSpace, 6> sidesOf(const OrientedBox& box);
std::array<HalfSpace, 3> sidesOf(const Octant& octant);
inline std::array<HalfSpace, 1> sidesOf(const HalfSpace& plane) {
    return {plane};
}

// A shape contains its border too. Of a box in any frame, by its corners in the world, it contains all or
// nothing; conservative: either may be false although it does.
bool contains(const Ball& ball, const glm::dvec3& pointMm);
bool containsAll(const Ball& ball, const BoxCorners& corners);
bool containsNone(const Ball& ball, const BoxCorners& corners);

template <class Shape>
concept HasSides = requires(const Shape& shape) {
    sidesOf(shape);
};
bool contains(const HasSides auto& shape, const glm::dvec3& pointMm) {
    return std::ranges::all_of(sidesOf(shape), [&](const HalfSpace& side) { return side.contains(pointMm); });
}
bool containsAll(const HasSides auto& shape, const BoxCorners& corners) {
    return std::ranges::all_of(corners, [&, sides = sidesOf(shape)](const glm::dvec3& corner) {
        return std::ranges::all_of(sides, [&](const HalfSpace& side) { return side.contains(corner); });
    });
}
bool containsNone(const HasSides auto& shape, const BoxCorners& corners) {
    return std::ranges::any_of(sidesOf(shape), [&](const HalfSpace& side) {  // all corners are beyond one
        return std::ranges::none_of(corners, [&](const glm::dvec3& corner) { return side.contains(corner); });
    });
}

struct MaskBits;

// Shows voxels by the segment that they belong to. If the map has another grid than the volume, the nearest
// label counts; voxels outside its grid belong to no segment.
struct Mask {
    std::shared_ptr<const LabelMap> labels = {};
    std::vector<std::uint16_t> numbers = {};  // of segments; empty: all but 0
    Keep keep = Keep::inside;
    // Replaces the three members above: which voxels are shown, of exactly this volume.
    std::shared_ptr<const MaskBits> bits = {};
    // For the remarks of a picture, what the mask hides: "table left out". No patient data.
    Text remark = {};

    bool operator==(const Mask&) const = default;
};

// A point is shown if all parts together show it.
struct Clip {
    static constexpr std::size_t kMostPlanes = 6;

    std::optional<OrientedBox> box;
    Keep ofBox = Keep::inside;
    std::vector<HalfSpace> planes;  // at most kMostPlanes
    std::optional<Octant> cut;      // the octant that is removed
    std::optional<Ball> ball;
    Keep ofBall = Keep::inside;
    std::optional<Mask> mask;

    // Removed matter is hidden only from the eye; it casts shadow and reflects light as before.
    bool removedCastsShadow = false;
    // The faces of the clip show grey values through this window, opaque above its low end.
    std::optional<DisplayWindow> greyFaces;
    // At and below that end faces are black; if false, clear, and show what lies behind.
    bool facesBelowWindowAreBlack = false;

    bool hasShape() const;
    bool isNothing() const { return !hasShape() && !mask; }

    bool operator==(const Clip&) const = default;  // labels and bits: same objects
};

// The one list of shapes, in the order in which they are written. Calls visit(part, keep): `part` is an
// optional shape of the clip, or its planes; `keep` can be assigned to if the shape has one.
template <class AnyClip, class Visit>
void forEachPart(AnyClip& clip, const Visit& visit) {
    visit(clip.box, clip.ofBox);
    visit(clip.planes, Keep::inside);
    visit(clip.cut, Keep::outside);
    visit(clip.ball, clip.ofBall);
}

// Calls visit(shape, keep) for each shape that the clip has.
template <class AnyClip, class Visit>
void forEachShape(AnyClip& clip, const Visit& visit) {
    forEachPart(clip, [&](auto& part, Keep keep) {
        if constexpr (requires { part.has_value(); }) {
            static_assert(SingleClipShape<typename std::remove_cvref_t<decltype(part)>::value_type>);
            if (part) visit(*part, keep);
        } else {
            for (auto& plane : part) visit(plane, keep);
        }
    });
}

// Fails with usage if a number is not finite, a size is not positive, axes are not orthonormal to 1e-6, or
// there are too many planes.
Result<void> validate(const Clip& clip);

// Whether the shape shows nothing of this box, given in any coordinate frame; ignores the mask. Conservative:
// may return false although nothing is shown.
bool removesAll(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame);

// Whether the shape shows all of this box. Conservative likewise; ignores the mask.
bool removesNothing(const Clip& clip, const glm::dmat4& worldFromFrame, const Box& boxInFrame);

// Whether the shapes show the point; ignores the mask.
bool shows(const Clip& clip, const glm::dvec3& pointMm);

// A clip in fractions of a volume's box, as a clip of that volume, and back. Planes and cut faces stay as
// they are.
void shapesToMm(Clip& clip, const Box& volume);
void shapesToFractions(Clip& clip, const Box& volume);

}  // namespace macula
