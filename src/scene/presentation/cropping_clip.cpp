#include "scene/presentation/cropping_clip.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/camera.h"
#include "scene/clip/edited_clip.h"
#include "scene/presentation/voxel_axes.h"

namespace macula::scene {

namespace {

// A plane that cuts off less than this cuts nothing.
constexpr double kNothingMm = 1e-6;

class Cutting {
  public:
    explicit Cutting(const Volume& volume) : volume_(volume), left_(volume.worldBox()) {}

    void cut(const Box& corners) {
        if (isAlongPatient(volume_)) {
            left_.low = glm::max(left_.low, glm::min(corners.low, corners.high));
            left_.high = glm::min(left_.high, glm::max(corners.low, corners.high));
            return;
        }
        // Along the voxels' axes, which may not even be at right angles (PS3.3 C.11.24).
        const glm::dmat4 voxelFromWorld = glm::inverse(volume_.worldFromVoxel());
        const glm::dvec3 a = transformPoint(voxelFromWorld, corners.low);
        const glm::dvec3 b = transformPoint(voxelFromWorld, corners.high);
        for (int axis = 0; axis < 3; ++axis) {
            // The gradient of the voxel coordinate in the world.
            const glm::dvec3 across(voxelFromWorld[0][axis], voxelFromWorld[1][axis],
                                    voxelFromWorld[2][axis]);
            const bool isLow = a[axis] <= b[axis];
            add(-across, isLow ? corners.low : corners.high);
            add(across, isLow ? corners.high : corners.low);
        }
    }
    void cut(const dicom::CroppingPlane& plane) { add(plane.outward, plane.outward * plane.offsetMm); }

    Result<std::optional<ClipPreset>> clip(const std::string& where) const {
        const auto refuse = [&](Text message) {
            return Error{ErrorCode::inputNotUsable, std::move(message), where,
                         Text("Choose another presentation state.")};
        };
        if (isEmpty_ || !glm::all(glm::lessThan(left_.low, left_.high)))
            return refuse(Text("The clip of the presentation state leaves nothing of this series."));
        if (planes_.size() > Clip::kMostPlanes)
            return refuse(Text("The clip of the presentation state is of more planes than six."));
        const Box all = volume_.worldBox();
        const glm::dvec3 size = all.high - all.low;
        const auto fraction = [&](const glm::dvec3& mm) { return (mm - all.low) / size; };
        ClipPreset preset{
            .name = "presentation-state", .title = "Presentation state", .clip = {}, .planesAt = {}};
        const double cutOffMm = std::max(largest(left_.low - all.low), largest(all.high - left_.high));
        if (cutOffMm > kNothingMm) {
            const glm::dvec3 low = fraction(left_.low);
            const glm::dvec3 high = fraction(left_.high);
            preset.clip.box = OrientedBox{.centreMm = 0.5 * (low + high), .halfSizeMm = 0.5 * (high - low)};
        }
        for (const auto& [outward, offsetMm] : planes_) {
            preset.clip.planes.push_back({.normal = -outward, .offsetMm = 0.0});
            preset.planesAt.push_back(
                fractionOnPlane(outward, offsetMm - glm::dot(outward, all.centre()), volume_));
        }
        if (!preset.clip.hasShape()) return std::optional<ClipPreset>();
        return std::optional<ClipPreset>(std::move(preset));
    }

  private:
    static double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

    void add(const glm::dvec3& outward, const glm::dvec3& pointMm) {
        const glm::dvec3 normal = glm::normalize(outward);
        const double offsetMm = glm::dot(normal, pointMm);
        bool cuts = false;
        bool leaves = false;
        for (const glm::dvec3& corner : voxelCorners()) {
            const double beyondMm = glm::dot(normal, corner) - offsetMm;
            cuts = cuts || beyondMm > kNothingMm;
            leaves = leaves || beyondMm < -kNothingMm;
        }
        isEmpty_ = isEmpty_ || !leaves;
        const dicom::CroppingPlane plane{.outward = normal, .offsetMm = offsetMm};
        if (cuts && std::ranges::find(planes_, plane) == planes_.end()) planes_.push_back(plane);
    }

    // The corners of the voxel grid; those of the world box differ if the volume is turned.
    std::vector<glm::dvec3> voxelCorners() const {
        const Box voxels{glm::dvec3(-0.5), glm::dvec3(volume_.size()) - 0.5};
        std::vector<glm::dvec3> corners;
        for (const glm::dvec3& corner : cornersOf(voxels))
            corners.push_back(transformPoint(volume_.worldFromVoxel(), corner));
        return corners;
    }

    const Volume& volume_;
    Box left_;
    std::vector<dicom::CroppingPlane> planes_;
    bool isEmpty_ = false;
};

}  // namespace

Result<std::optional<ClipPreset>> clipOf(const dicom::Cropping& cropping, const Volume& volume,
                                         const std::string& where) {
    Cutting cutting(volume);
    for (const Box& box : cropping.boxes) cutting.cut(box);
    for (const dicom::CroppingPlane& plane : cropping.planes) cutting.cut(plane);
    return cutting.clip(where);
}

}  // namespace macula::scene
