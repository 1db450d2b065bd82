// A ball, removed or kept.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/is_finite.h"
#include "scene/clip/edit_steps.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/handles_on_slice.h"

namespace macula::scene {

namespace {

constexpr double kMostRadius = 10.0;  // the limit of the JSON, in shortest sides of the volume
constexpr int kSides = 128;           // of the polygon that is a circle on a slice
constexpr int kDots = 40;

}  // namespace

ValueRange ballRadiiMm(const Volume& volume) {
    const Box all = volume.worldBox();
    const glm::dvec3 size = all.high - all.low;
    const glm::dvec3 spacing = volume.spacingMm();
    const double most = std::min(kMostRadius * std::min({size.x, size.y, size.z}), all.diagonal());
    return {.low = std::min(0.5 * std::min({spacing.x, spacing.y, spacing.z}), most), .high = most};
}

Result<OptionalClip> withBallRemoved(const OptionalClip& clip, const glm::dvec3& centreMm, double radiusMm,
                                     const Volume& volume) {
    if (!isFinite(centreMm)) return notANumber();
    const ValueRange radii = ballRadiiMm(volume);
    if (!(radii.low <= radiusMm && radiusMm <= radii.high))
        return refused(Text("A ball of that size is not possible here."),
                       Text("Give a radius from {:.4g} to {:.4g} mm.", radii.low, radii.high));
    const Box all = volume.worldBox();
    if (!isWithin(all, centreMm))
        return refused(Text("The ball would be outside of the volume."),
                       Text("Move the cross-hair into the volume."));
    const glm::dvec3 size = all.high - all.low;
    ClipPreset next = clip.value_or(ClipPreset{});
    next.clip.ball = Ball{.centreMm = fractionOf(volume, centreMm),
                          .radiusMm = std::min(radiusMm / std::min({size.x, size.y, size.z}), kMostRadius)};
    next.clip.ofBall = Keep::outside;
    return own(std::move(next), volume);
}

Result<OptionalClip> withBallAt(const OptionalClip& clip, const glm::dvec3& centreMm, double radiusMm,
                                const Volume& volume) {
    if (!isFinite(centreMm) || !std::isfinite(radiusMm)) return notANumber();
    if (!clip || !clip->clip.ball) return notThere();
    const ValueRange radii = ballRadiiMm(volume);
    const Box all = volume.worldBox();
    const glm::dvec3 size = all.high - all.low;
    ClipPreset next = *clip;
    next.clip.ball = Ball{
        .centreMm = fractionOf(volume, glm::clamp(centreMm, all.low, all.high)),
        .radiusMm = std::min(std::clamp(radiusMm, radii.low, radii.high) / std::min({size.x, size.y, size.z}),
                             kMostRadius)};
    return own(std::move(next), volume);
}

namespace {

using Kind = ClipHandle::Kind;

class ShownBall : public ShownShape {
  public:
    ShownBall(const Ball& ball, Keep keep) : ball_(ball), keep_(keep) {}

    Text remark() const override {
        return keep_ == Keep::outside ? Text("A ball is removed.") : Text("Only a ball is kept.");
    }
    std::vector<Contour> removedOn(const slices::SliceFrame& frame) const override {
        std::vector<Contour> contours;
        Contour circle = circleOn(frame);
        if (keep_ == Keep::inside) {
            contours.push_back(pictureOf(frame));
            // Reversed, so that within the circle the windings of picture and circle cancel out.
            std::ranges::reverse(circle);
        }
        if (!circle.empty()) contours.push_back(std::move(circle));
        return contours;
    }
    Contour lineOn(const slices::SliceFrame& frame, const Contour&) const override {
        return closedLine(circleOn(frame));
    }
    std::vector<glm::dvec3> dots(const PictureRays& rays, const Box&) const override {
        std::vector<glm::dvec3> dots;
        for (int i = 0; i < kDots; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / kDots;
            dots.push_back(ball_.centreMm + ball_.radiusMm * (std::cos(turn) * rays.axes().right +
                                                              std::sin(turn) * rays.axes().up));
        }
        return dots;
    }
    std::vector<PlacedHandle> handles(const Box&) const override {
        const glm::dvec3 left(1.0, 0.0, 0.0);
        return {{.handle = {.kind = Kind::ballCentre}, .atMm = ball_.centreMm, .along = {}},
                {.handle = {.kind = Kind::ballRadius},
                 .atMm = ball_.centreMm + ball_.radiusMm * left,
                 .along = left,
                 .aroundMm = ball_.centreMm}};
    }
    void addHandles(HandlesOnSlice& slice) const override {
        const slices::SlicePlane& plane = slice.frame().plane;
        const double radiusMm = radiusOn(slice.frame());
        if (!(radiusMm > 0.0)) return;
        const glm::dvec3 centre = ball_.centreMm - slice.frame().distanceMm(ball_.centreMm) * plane.normal();
        slice.addPoint({.kind = Kind::ballCentre}, centre, glm::dvec3(0.0));
        slice.addPoint({.kind = Kind::ballRadius}, centre + radiusMm * plane.right, plane.right);
    }
    Result<OptionalClip> withHandleAt(const OptionalClip& clip, const ClipHandle& handle,
                                      const glm::dvec3& mm, const Volume& volume) const override {
        if (handle.kind == Kind::ballCentre) return withBallAt(clip, mm, ball_.radiusMm, volume);
        return withBallAt(clip, ball_.centreMm, glm::length(mm - ball_.centreMm), volume);
    }
    Result<OptionalClip> turnedInsideOut(ClipPreset clip, const Volume& volume) const override {
        clip.clip.ofBall = keep_ == Keep::inside ? Keep::outside : Keep::inside;
        return own(std::move(clip), volume);
    }
    std::optional<PanelTool> panelTool() const override {
        return PanelTool{
            .key = Ball::kKey,
            .sizeKey = "radius",
            .button = Text("Remove a ball"),
            .whatItDoes = Text("Removes a ball around the cross-hair; it takes the place of another ball"),
            .size = Text("Radius of the ball"),
            .whatSizeIs = Text("From its centre, in mm"),
            .firstMm = 20.0,
            .sizesMm = ballRadiiMm,
            .removed = withBallRemoved};
    }
    std::optional<HandTool> handTool() const override {
        const auto remove = [](Clip& clip, const glm::dvec3& centreMm, double halfMm) {
            clip.ball = Ball{.centreMm = centreMm, .radiusMm = halfMm};
            clip.ofBall = Keep::outside;
        };
        return HandTool{
            .key = Ball::kKey, .name = Text("ball"), .place = 1, .isRound = true, .remove = remove};
    }

  private:
    // Of the circle on a slice; 0 if the slice misses the ball.
    double radiusOn(const slices::SliceFrame& frame) const {
        const double offMm = frame.distanceMm(ball_.centreMm);
        const double radius2 = ball_.radiusMm * ball_.radiusMm - offMm * offMm;
        return radius2 > 0.0 ? std::sqrt(radius2) : 0.0;
    }
    Contour circleOn(const slices::SliceFrame& frame) const {
        const double radiusMm = radiusOn(frame);
        if (!(radiusMm > 0.0)) return {};
        const double radiusPx = radiusMm / frame.mmPerPixel;
        const glm::dvec2 centre = frame.pictureFromWorld(ball_.centreMm);
        Contour circle;
        for (int side = 0; side < kSides; ++side) {
            const double turn = 2.0 * std::numbers::pi * side / kSides;
            circle.push_back(centre + radiusPx * glm::dvec2(std::cos(turn), std::sin(turn)));
        }
        return circle;
    }

    Ball ball_;
    Keep keep_;
};

}  // namespace

ShownShapePtr shown(const Ball& ball, Keep keep, std::size_t) {
    return std::make_unique<ShownBall>(ball, keep);
}

}  // namespace macula::scene
