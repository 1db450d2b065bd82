#include "scene/drawing/first_matter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "pipeline/trace/look.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/volume_fit.h"
#include "scene/camera/picture_rays.h"
#include "slices/voxel_grid.h"

namespace macula::scene {

namespace {

constexpr double kStepOfVoxel = 1.0 / 3.0;
constexpr double kMostSteps = 8192.0;
constexpr double kLeastLoss = 0.02;  // of the light: thinner matter does not count as pointed at

// A part of the ray, in mm from its origin.
struct Span {
    double begin;
    double end;
};

// The part of the ray within the volume.
std::optional<Span> spanIn(const Volume& volume, const PictureRay& ray) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const glm::dvec3 origin = transformPoint(voxelFromWorld, ray.originMm);
    const glm::dvec3 direction = transformVector(voxelFromWorld, ray.direction);
    Span span{0.0, std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = (-0.5 - origin[axis]) / direction[axis];
        const double high = (volume.size()[axis] - 0.5 - origin[axis]) / direction[axis];
        if (std::isnan(low) || std::isnan(high)) return std::nullopt;  // along a face
        span.begin = std::max(span.begin, std::min(low, high));
        span.end = std::min(span.end, std::max(low, high));
    }
    if (!(span.begin < span.end) || !std::isfinite(span.end)) return std::nullopt;
    return span;
}

bool isMasked(const Mask& mask, const glm::dmat4& labelFromWorld, const glm::dvec3& pointMm) {
    const glm::ivec3 at = glm::ivec3(glm::round(transformPoint(labelFromWorld, pointMm)));
    const glm::ivec3 size = mask.bits ? mask.bits->size : mask.labels->size();
    const bool isInside =
        glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, size));
    if (mask.bits) return !(isInside && mask.bits->shows(at.x, at.y, at.z));
    const std::uint16_t label = isInside ? mask.labels->label(at.x, at.y, at.z) : std::uint16_t{0};
    const bool belongs =
        mask.numbers.empty() ? label != 0 : std::ranges::find(mask.numbers, label) != mask.numbers.end();
    return belongs != (mask.keep == Keep::inside);
}

class Matter {
  public:
    Matter(const Volume& volume, const Drawing& drawing)
        : volume_(volume),
          voxels_(voxelsOf(volume)),
          clip_(drawing.clip.get()),
          voxelFromWorld_(glm::inverse(volume.worldFromVoxel())) {
        if (clip_ != nullptr && clip_->mask)
            labelFromWorld_ =
                clip_->mask->bits ? voxelFromWorld_ : glm::inverse(clip_->mask->labels->worldFromVoxel());
        if (drawing.additions && drawing.additions->second)
            second_.emplace(*drawing.additions->second, volume);
        if (drawing.additions && drawing.additions->tints) tints_ = &*drawing.additions->tints;
    }

    bool isShown(const glm::dvec3& pointMm) const {
        if (clip_ == nullptr) return true;
        return shows(*clip_, pointMm) && !(clip_->mask && isMasked(*clip_->mask, labelFromWorld_, pointMm));
    }

    // As slices show it: linear between the voxels that are not padding; NaN where all are.
    double valueAt(const glm::dvec3& pointMm) const {
        const glm::dvec3 at = transformPoint(voxelFromWorld_, pointMm);
        return std::visit([&](const auto& voxels) { return voxels.linear(at); }, voxels_);
    }

    // The mean of the three spacings, by which VTK measures gradients.
    double edgeMm() const {
        const glm::dvec3 spacing = volume_.spacingMm();
        return (spacing.x + spacing.y + spacing.z) / 3.0;
    }

    // The gradient in units per voxel of mean edge, as TransferFunction::gradientOpacity needs it.
    double gradientAt(const glm::dvec3& pointMm) const {
        const double edge = edgeMm();
        glm::dvec3 gradient(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = 0.5 * edge;
            gradient[axis] = valueAt(pointMm + step) - valueAt(pointMm - step);
        }
        const double length = glm::length(gradient);
        return std::isfinite(length) ? length : 0.0;
    }

    // The extinction of a second volume in the same picture, per mm.
    double secondExtinctionAt(const glm::dvec3& pointMm) const {
        return second_ ? second_->at(transformPoint(voxelFromWorld_, pointMm)) : 0.0;
    }

    // The share of the extinction that the segment of the nearest voxel leaves.
    double segmentOpacityAt(const glm::dvec3& pointMm) const {
        if (tints_ == nullptr) return 1.0;
        const TintBox& box = *tints_->box;
        const glm::ivec3 at = glm::ivec3(glm::round(transformPoint(voxelFromWorld_, pointMm))) - box.low;
        if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, box.size)))
            return 1.0;
        const std::uint8_t colour =
            box.voxels[(std::size_t(at.z) * std::size_t(box.size.y) + std::size_t(at.y)) *
                           std::size_t(box.size.x) +
                       std::size_t(at.x)];
        return colour == 0 ? 1.0 : double(tints_->colours[std::size_t(colour) - 1].opacity);
    }

  private:
    using Voxels =
        std::variant<slices::VoxelGrid<slices::StoredVoxels>, slices::VoxelGrid<slices::FloatVoxels>>;

    static Voxels voxelsOf(const Volume& volume) {
        if (volume.format() == VoxelFormat::stored16) return slices::VoxelGrid<slices::StoredVoxels>(volume);
        return slices::VoxelGrid<slices::FloatVoxels>(volume);
    }

    const Volume& volume_;
    Voxels voxels_;
    const Clip* clip_;
    std::optional<SecondExtinction> second_;
    const SegmentTints* tints_ = nullptr;  // of the drawing
    glm::dmat4 voxelFromWorld_;
    glm::dmat4 labelFromWorld_{1.0};
};

struct Walk {
    PictureRay ray;
    Span span;
    double stepMm;

    std::size_t steps() const { return std::size_t(std::ceil((span.end - span.begin) / stepMm)); }
    glm::dvec3 at(std::size_t step) const {
        return ray.originMm + (span.begin + (double(step) + 0.5) * stepMm) * ray.direction;
    }
};

std::optional<glm::dvec3> extremeAlong(const Walk& walk, const Matter& matter, bool isMaximum) {
    std::optional<glm::dvec3> found;
    double best = 0.0;
    for (std::size_t i = 0; i < walk.steps(); ++i) {
        const glm::dvec3 point = walk.at(i);
        const double value = matter.valueAt(point);
        if (std::isnan(value) || !matter.isShown(point)) continue;
        if (found && (isMaximum ? value <= best : value >= best)) continue;
        best = value;
        found = point;
    }
    return found;
}

// A face of the clip is opaque where its window is above black, or where faces also show black.
bool isGreyFace(const Clip* clip, double value) {
    return clip != nullptr && clip->greyFaces && clip->hasShape() &&
           (clip->facesBelowWindowAreBlack || value > clip->greyFaces->center - 0.5 * clip->greyFaces->width);
}

std::optional<glm::dvec3> matterAlong(const Walk& walk, const Matter& matter, const Volume& volume,
                                      const Drawing& drawing) {
    const TransferFunction function = fitted(*drawing.transferFunction, volume);
    const TransferFunction steep = withCurvesSwapped(function);
    const bool usesSteep = usesSteepCurves(function);
    const bool usesGradient = usesGradientOpacity(function);
    std::vector<double> depths{0.0};  // optical depth after each number of steps
    bool wasHidden = false;
    for (std::size_t i = 0; i < walk.steps(); ++i) {
        const glm::dvec3 point = walk.at(i);
        const bool isShown = matter.isShown(point);
        const double value = isShown ? matter.valueAt(point) : std::numeric_limits<double>::quiet_NaN();
        double extinction = 0.0;
        if (!std::isnan(value)) {
            if (wasHidden && isGreyFace(drawing.clip.get(), value)) return point;
            extinction = extinctionPerMm(function, value);
            if (usesSteep)
                extinction = std::lerp(extinction, extinctionPerMm(steep, value),
                                       steepPartAt(function, matter.gradientAt(point) / matter.edgeMm()));
            if (extinction > 0.0 && usesGradient)
                extinction *= gradientOpacityAt(function, matter.gradientAt(point));
            if (extinction > 0.0) extinction *= matter.segmentOpacityAt(point);
        }
        if (isShown) extinction += matter.secondExtinctionAt(point);
        wasHidden = !isShown;
        depths.push_back(depths.back() + extinction * walk.stepMm);
    }
    const double lost = -std::expm1(-depths.back());
    if (lost < kLeastLoss) return std::nullopt;
    const auto half = std::ranges::lower_bound(depths, -std::log1p(-0.5 * lost));
    return walk.at(std::size_t(half - depths.begin()) - 1);
}

}  // namespace

std::optional<glm::dvec3> firstMatterMm(const Volume& volume, const Drawing& drawing, const Camera& camera,
                                        const glm::dvec2& place, double aspectWidthOverHeight) {
    const auto rays = PictureRays::of(standingBefore(camera, volume.worldBox()), aspectWidthOverHeight);
    if (!rays || !std::isfinite(place.x) || !std::isfinite(place.y)) return std::nullopt;
    const PictureRay ray = rays->through(place);
    const auto span = spanIn(volume, ray);
    if (!span) return std::nullopt;
    const glm::dvec3 spacing = volume.spacingMm();
    const double wanted = kStepOfVoxel * std::min({spacing.x, spacing.y, spacing.z});
    const Walk walk{ray, *span, std::max(wanted, (span->end - span->begin) / kMostSteps)};
    const Matter matter(volume, drawing);
    switch (drawing.settings.look) {
        case trace::Look::mip:
            return extremeAlong(walk, matter, true);
        case trace::Look::minip:
            return extremeAlong(walk, matter, false);
        case trace::Look::average:
            return std::nullopt;
        case trace::Look::cinematic:
        case trace::Look::clear:
        case trace::Look::dvr:
            break;
    }
    return drawing.transferFunction ? matterAlong(walk, matter, volume, drawing) : std::nullopt;
}

}  // namespace macula::scene
