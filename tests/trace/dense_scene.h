// A volume as it is shown, point by point, in double: from the volume, the transfer function and the clip
// themselves. It shares with the tracers none of shaders/lib, no table and no bound; curves, extinction and
// the fovea are written anew here. What it does share: voxels and their places (base/volume.h), the axes of a
// camera (base/camera.h), and whether shapes of a clip show a point (shows, pipeline/volume/clip.h). Those
// have tests of their own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pipeline/trace/scene.h"
#include "trace/dense_cast.h"

namespace macula::scenes {

// Keeps references to what it is made of. Values from 0 to 1000.
class DenseScene {
  public:
    DenseScene(const Volume& volume, const TransferFunction& function, const Clip& clip,
               const trace::View& view, trace::Filter filter)
        : volume_(volume),
          function_(function),
          clip_(clip),
          view_(view),
          eye_(*basis(view.camera)),
          voxelFromWorld_(glm::inverse(volume.worldFromVoxel())),
          stochastic_(filter == trace::Filter::stochastic),
          fovea_(foveaOf(view)) {
        expectStraight(function.opacity);
        expectStraight(function.gradientOpacity);
        expectStraight(function.colour);
        EXPECT_EQ(function.colourSpace, ColourSpace::rgb);
        tabulate(function.opacity, function.colour, optics_);
        expectStraight(function.steep.opacity);
        expectStraight(function.steep.colour);
        if (!function.steep.opacity.empty()) tabulate(function.steep.opacity, function.steep.colour, steep_);
        const glm::ivec3 size = volume_.size();
        for (int k = 0; k < size.z; ++k) {
            for (int j = 0; j < size.y; ++j) {
                for (int i = 0; i < size.x; ++i) {
                    values_.push_back(volume_.value(i, j, k));
                    shown_.push_back(!clip_.mask || isShown(i, j, k) ? 1.0 : 0.0);
                }
            }
        }
        for (int n = 0; n < size.x * size.y * size.z; ++n) {
            const glm::dvec3 voxel(n % size.x, n / size.x % size.y, n / (size.x * size.y));
            const double ratio = glm::length(gradientPerMm(voxel)) / function.steep.gradientPerMm;
            steepParts_.push_back(ratio * ratio / (1.0 + ratio * ratio));
        }
    }

    // The eight voxels around a point, as what clamping leaves of them, and their weights.
    struct Around {
        std::array<std::size_t, 8> voxel;
        std::array<double, 8> weight;
    };
    struct Marched {
        double depth = 0.0;
        double firstMm = 0.0;  // where the first step was looked at
        double stepMm = 0.0;
        std::vector<double> depths;  // after each step
    };

    // Unit, world, through a point of the picture, 0 to 1 from its top left corner.
    glm::dvec3 eyeDirection(double x, double y) const {
        glm::dvec2 p = glm::dvec2(2.0 * x - 1.0, 1.0 - 2.0 * y) * fovea_.halfSize;
        if (fovea_.magnification > 1.0) {
            // Plain up to the radius; beyond, a parabola that ends on the border.
            const glm::dvec2 offset = p - fovea_.gaze;
            const double r = glm::length(offset);
            double seen = r / fovea_.magnification;
            if (r > fovea_.radius) {
                double border = 1e9;
                for (int axis = 0; axis < 2; ++axis) {
                    const double side =
                        (offset[axis] < 0.0 ? -1.0 : 1.0) * fovea_.halfSize[axis] - fovea_.gaze[axis];
                    if (std::abs(offset[axis]) > 1e-12) border = std::min(border, side / offset[axis] * r);
                }
                const double share = (r - fovea_.radius) / (border - fovea_.radius);
                seen += border * (1.0 - 1.0 / fovea_.magnification) * share * share;
            }
            p = fovea_.gaze + offset * (seen / std::max(r, 1e-12));
        }
        return glm::normalize(eye_.forward + eye_.right * p.x + eye_.up * p.y);
    }

    glm::dvec3 voxelOf(const glm::dvec3& mm) const { return transformPoint(voxelFromWorld_, mm); }
    Around around(const glm::dvec3& voxel) const {
        const glm::ivec3 size = volume_.size();
        const glm::dvec3 clamped = glm::clamp(voxel, glm::dvec3(0.0), glm::dvec3(size - 1));
        const glm::ivec3 low = glm::min(glm::ivec3(clamped), size - 2);
        const glm::dvec3 t = clamped - glm::dvec3(low);
        Around result{};
        for (int c = 0; c < 8; ++c) {
            const glm::ivec3 up(c & 1, c >> 1 & 1, c >> 2 & 1);
            const glm::ivec3 at = low + up;
            result.voxel[std::size_t(c)] = std::size_t((at.z * size.y + at.y) * size.x + at.x);
            result.weight[std::size_t(c)] =
                (up.x == 1 ? t.x : 1.0 - t.x) * (up.y == 1 ? t.y : 1.0 - t.y) * (up.z == 1 ? t.z : 1.0 - t.z);
        }
        return result;
    }
    static double blend(const Around& a, const std::vector<double>& of) {
        double sum = 0.0;
        for (std::size_t c = 0; c < 8; ++c) sum += a.weight[c] * of[a.voxel[c]];
        return sum;
    }
    double valueOf(const Around& a) const { return blend(a, values_); }
    // Central differences over a voxel to either side, world.
    glm::dvec3 gradientPerMm(const glm::dvec3& voxel) const {
        glm::dvec3 perVoxel(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = 1.0;
            perVoxel[axis] = 0.5 * (valueOf(around(voxel + step)) - valueOf(around(voxel - step)));
        }
        return glm::transpose(glm::dmat3(voxelFromWorld_)) * perVoxel;
    }

    bool isMasked(const Around& a) const { return clip_.mask && blend(a, shown_) < 0.5; }
    bool isHidden(const glm::dvec3& mm, const Around& a) const {
        return (clip_.hasShape() && !shows(clip_, mm)) || isMasked(a);
    }

    // Per mm. What is drawn from single voxels blends what they do.
    double extinctionAt(const glm::dvec3& voxel, const Around& a) const {
        return matterAt(voxel, a).extinction;
    }
    // Of what scatters there.
    glm::dvec3 albedoAt(const glm::dvec3& voxel) const { return matterAt(voxel, around(voxel)).albedo; }
    // The same by chance: one of the matters that may have scattered.
    template <class Random>
    glm::dvec3 albedoSeen(const glm::dvec3& voxel, Random&& random) const {
        const Around a = around(voxel);
        const Parts parts = partsAt(voxel, a);
        double total = 0.0;
        for (int i = 0; i < parts.count; ++i) total += parts.of[std::size_t(i)].extinction;
        double left = random() * total;
        for (int i = 0; i < parts.count; ++i) {
            left -= parts.of[std::size_t(i)].extinction;
            if (left < 0.0) return parts.of[std::size_t(i)].albedo;
        }
        return parts.of[std::size_t(parts.count - 1)].albedo;
    }

    // Where a ray is inside of the volume, mm.
    glm::dvec2 inside(const glm::dvec3& originMm, const glm::dvec3& direction) const {
        const glm::dvec3 origin = voxelOf(originMm);
        const glm::dvec3 along = transformVector(voxelFromWorld_, direction);
        glm::dvec2 span(0.0, 1e9);
        for (int axis = 0; axis < 3; ++axis) {
            const double slope = std::abs(along[axis]) < 1e-12 ? 1e-12 : along[axis];
            const double a = (-0.5 - origin[axis]) / slope;
            const double b = (volume_.size()[axis] - 0.5 - origin[axis]) / slope;
            span = {std::max(span.x, std::min(a, b)), std::min(span.y, std::max(a, b))};
        }
        return span;
    }

    Marched march(const glm::dvec3& originMm, const glm::dvec3& direction, bool light, double stepVoxels,
                  double jitter, bool keep) const {
        Marched result;
        const glm::dvec2 span = inside(originMm, direction);
        if (span.y <= span.x) return result;
        const glm::dvec3 along = transformVector(voxelFromWorld_, direction);
        const double voxelsPerMm = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
        const int steps = std::max(4, int(std::ceil((span.y - span.x) * voxelsPerMm / stepVoxels)));
        const bool seesAll = light && clip_.removedCastsShadow;
        result.stepMm = (span.y - span.x) / steps;
        result.firstMm = span.x + jitter * result.stepMm;
        for (int i = 0; i < steps; ++i) {
            const glm::dvec3 mm = originMm + direction * (result.firstMm + i * result.stepMm);
            const glm::dvec3 voxel = voxelOf(mm);
            const Around a = around(voxel);
            if (seesAll || !isHidden(mm, a)) result.depth += extinctionAt(voxel, a) * result.stepMm;
            if (keep) result.depths.push_back(result.depth);
        }
        return result;
    }

  protected:
    struct Optics {
        double extinction = 0.0;
        glm::dvec3 albedo{0.0};
    };
    struct Fovea {
        glm::dvec2 halfSize;  // of the picture, at distance 1, as all of it
        glm::dvec2 gaze{0.0};
        double magnification = 1.0;
        double radius = 0.0;  // of what is magnified, in the picture as it is stored
    };

    static Fovea foveaOf(const trace::View& view) {
        const double half = std::tan(glm::radians(view.camera.verticalFovDeg) / 2.0);
        Fovea fovea{.halfSize = {half * view.width / view.height, half}};
        if (!view.foveation) return fovea;
        fovea.gaze = view.foveation->gaze * fovea.halfSize;
        fovea.magnification = view.foveation->magnification;
        fovea.radius = fovea.magnification * std::tan(glm::radians(view.foveation->fieldDeg) / 2.0);
        // Fields that have no room are made smaller; there is no such rule here.
        const glm::dvec2 room = fovea.halfSize - glm::abs(fovea.gaze);
        EXPECT_LT(fovea.radius, 0.8 * std::min(room.x, room.y));
        return fovea;
    }

    template <class Point>
    static void expectStraight(const std::vector<Point>& curve) {
        for (const Point& point : curve) EXPECT_TRUE(point.midpoint == 0.5 && point.sharpness == 0.0);
    }
    // Straight lines between points, level beyond them.
    template <class Point, class Height>
    static Height heightAt(const std::vector<Point>& curve, double at, Height Point::*height) {
        if (at <= curve.front().value) return curve.front().*height;
        for (std::size_t i = 1; i < curve.size(); ++i) {
            const Point& a = curve[i - 1];
            const Point& b = curve[i];
            if (at < b.value)
                return a.*height + (b.*height - a.*height) * ((at - a.value) / (b.value - a.value));
        }
        return curve.back().*height;
    }
    // By whole values, linear between them. A layer as thick as the unit distance lets 1 - opacity through,
    // at density 1. No opacity is above 0.999 (docs/numerical-limits.md).
    void tabulate(const std::vector<OpacityPoint>& opacities, const std::vector<ColourPoint>& colours,
                  std::vector<Optics>& table) {
        for (int value = 0; value <= 1001; ++value) {
            const double opacity = std::min(heightAt(opacities, value, &OpacityPoint::opacity), 0.999);
            const glm::dvec3 encoded = heightAt(colours, value, &ColourPoint::colour);
            table.push_back({std::log(1.0 / (1.0 - opacity)) * function_.density / function_.unitDistanceMm,
                             function_.albedo *
                                 glm::dvec3(linearOf(encoded.r), linearOf(encoded.g), linearOf(encoded.b))});
            most_ = std::max(most_, table.back().extinction);
        }
    }

    // What is at a point, in parts: flat and steep matter, of the value there or of each voxel around.
    struct Parts {
        std::array<Optics, 16> of;
        int count = 0;
    };
    Parts partsAt(const glm::dvec3& voxel, const Around& a) const {
        const double gradient = gradientOpacity(voxel);
        const double steep = steep_.empty() ? 0.0 : blend(a, steepParts_);
        Parts parts;
        const auto add = [&](const std::vector<Optics>& table, double value, double share) {
            parts.of[std::size_t(parts.count++)] = {share * thinned(extinctionOf(table, value), gradient),
                                                    table[std::size_t(value + 0.5)].albedo};
        };
        const auto addBoth = [&](double value, double share) {
            add(optics_, value, share * (1.0 - steep));
            if (!steep_.empty()) add(steep_, value, share * steep);
        };
        if (!stochastic_) addBoth(blend(a, values_), 1.0);
        for (std::size_t c = 0; stochastic_ && c < 8; ++c) addBoth(values_[a.voxel[c]], a.weight[c]);
        return parts;
    }
    Optics matterAt(const glm::dvec3& voxel, const Around& a) const {
        Optics sum;
        glm::dvec3 first(0.0);
        const Parts parts = partsAt(voxel, a);
        for (int i = 0; i < parts.count; ++i) {
            const Optics& part = parts.of[std::size_t(i)];
            sum.extinction += part.extinction;
            sum.albedo += part.extinction * part.albedo;
            first = part.albedo;
        }
        sum.albedo = sum.extinction > 0.0 ? sum.albedo / sum.extinction : first;
        return sum;
    }

    bool isShown(int i, int j, int k) const {
        const std::uint16_t label = clip_.mask->labels->label(i, j, k);
        const auto& numbers = clip_.mask->numbers;
        const bool in = std::find(numbers.begin(), numbers.end(), label) != numbers.end();
        return in == (clip_.mask->keep == Keep::inside);
    }
    static double extinctionOf(const std::vector<Optics>& table, double value) {
        const auto low = std::size_t(value);
        const double t = value - double(low);
        return table[low].extinction * (1.0 - t) + table[low + 1].extinction * t;
    }

    double gradientOpacity(const glm::dvec3& voxel) const {
        if (function_.gradientOpacity.empty()) return 1.0;
        const glm::dvec3 spacing = volume_.spacingMm();
        return heightAt(function_.gradientOpacity,
                        glm::length(gradientPerMm(voxel)) * (spacing.x + spacing.y + spacing.z) / 3.0,
                        &OpacityPoint::opacity);
    }

    // Opacities of a layer multiply.
    double thinned(double extinction, double gradientOpacity) const {
        if (gradientOpacity == 1.0) return extinction;
        const double unitMm = function_.unitDistanceMm / function_.density;
        return -std::log1p(gradientOpacity * std::expm1(-extinction * unitMm)) / unitMm;
    }

    const Volume& volume_;
    const TransferFunction& function_;
    const Clip& clip_;
    const trace::View& view_;
    CameraBasis eye_;
    glm::dmat4 voxelFromWorld_;
    bool stochastic_;
    Fovea fovea_;
    std::vector<Optics> optics_;
    std::vector<Optics> steep_;  // of steep matter; empty: it has no curves of its own
    std::vector<double> steepParts_;
    std::vector<double> values_;
    std::vector<double> shown_;
    double most_ = 0.0;
};

}  // namespace macula::scenes
