// The truth about scattered light, in double: one part integrates along rays light that is scattered once,
// the other walks at random in the plainest way there is.
#pragma once

#include <numbers>
#include <random>

#include "trace/dense_coat.h"
#include "trace/dense_scene.h"
#include "trace/small_scenes.h"

namespace macula::scenes {

class DenseLight : DenseScene {
  public:
    // `gain` multiplies the light.
    DenseLight(const SmallScene& scene, trace::Filter filter, double gain)
        : DenseScene(*scene.volume, scene.function, scene.clip, scene.view, filter),
          sky_(scene.sky),
          coat_(scene.function.surface),
          gain_(gain),
          rotation_(glm::radians(scene.lightRotationDeg)) {
        double power = 0.0;
        for (int row = 0; row < sky_.height; ++row) {
            const double solidAngle = (edge(row) - edge(row + 1)) * 2.0 * std::numbers::pi / sky_.width;
            for (int column = 0; column < sky_.width; ++column) {
                const glm::dvec3 radiance(sky_.radiance[std::size_t(row * sky_.width + column)]);
                power += (radiance.r + radiance.g + radiance.b) * solidAngle;
                powers_.push_back(power);
            }
        }
    }

    // What the numbers of scatteredOnce() decide.
    enum Choice { kEyeStep, kDepth, kLight, kLightRow, kLightColumn, kLightStep };
    static constexpr int kVertices = 4;

    // Light scattered once, and coverage, of the eye ray through the point (x, y) of the picture, 0 to 1
    // each. Rays are marched in steps of `stepVoxels`; light is scattered at kVertices places, one in each
    // part of the opacity. number(vertex, choice) is in [0, 1).
    template <class Number>
    glm::dvec4 scatteredOnce(double x, double y, double stepVoxels, const Number& number) const {
        const glm::dvec3 direction = eyeDirection(x, y);
        const glm::dvec3 origin = view_.camera.positionMm;
        const Marched ray = march(origin, direction, false, stepVoxels, number(0, kEyeStep), true);
        const double coverage = -std::expm1(-ray.depth);
        glm::dvec3 light(0.0);
        for (int vertex = 0; vertex < kVertices && coverage > 0.0; ++vertex) {
            const double depth = -std::log1p(-coverage * (vertex + number(vertex, kDepth)) / kVertices);
            const auto next = std::upper_bound(ray.depths.begin(), ray.depths.end(), depth);
            if (next == ray.depths.end()) continue;  // rounding
            const auto step = double(next - ray.depths.begin());
            const glm::dvec3 point = origin + direction * (ray.firstMm + ray.stepMm * step);
            const Beam beam =
                towardsLight(number(vertex, kLight), number(vertex, kLightRow), number(vertex, kLightColumn));
            const Marched shadow =
                march(point, beam.direction, true, stepVoxels, number(vertex, kLightStep), false);
            const glm::dvec3 voxel = voxelOf(point);
            glm::dvec3 perSr(0.0);
            for (const auto& [gradient, weight] : gradientsAround(voxel))
                perSr += weight * scatteredPerSr(gradient, albedoAt(voxel), direction, beam.direction);
            light += perSr * beam.light * (std::exp(-shadow.depth) / kVertices);
        }
        return {coverage * gain_ * light, coverage};
    }

    // Light of a path that scatters up to `bounces` times, and whether it met matter: flights through matter
    // made uniform by collisions that change nothing, at each vertex one look towards a light, seen or not.
    glm::dvec4 walked(double x, double y, int bounces, std::mt19937_64& engine) const {
        const auto random = [&] { return double(engine() >> 11) * 0x1p-53; };
        glm::dvec3 direction = eyeDirection(x, y);
        glm::dvec3 point = view_.camera.positionMm;
        glm::dvec3 throughput(1.0);
        glm::dvec4 sum(0.0);
        for (int vertex = 0; vertex < bounces; ++vertex) {
            if (!fly(point, direction, vertex > 0, random)) return sum;
            sum.a = 1.0;
            const glm::dvec3 albedo = albedoSeen(voxelOf(point), random);
            const glm::dvec3 near = gradientNear(voxelOf(point), random);
            const Beam beam = towardsLight(random(), random(), random());
            glm::dvec3 towards = point;
            if (!fly(towards, beam.direction, true, random))
                sum += glm::dvec4(
                    throughput * beam.light * gain_ * scatteredPerSr(near, albedo, direction, beam.direction),
                    0.0);
            if (function_.surface.weight > 0.0) {
                // Anywhere, weighed with what goes there.
                const glm::dvec3 way = anywhere(random);
                throughput *= 4.0 * std::numbers::pi * scatteredPerSr(near, albedo, direction, way);
                direction = way;
            } else {
                throughput *= albedo;
                direction = scattered(direction, random);
            }
        }
        return sum;
    }

  private:
    struct Beam {
        glm::dvec3 direction;  // towards the light, world
        glm::dvec3 light;      // radiance divided by the probability per steradian
    };

    double edge(int row) const { return std::cos(std::numbers::pi * row / sky_.height); }

    // To the next collision. False when the ray leaves first.
    template <class Random>
    bool fly(glm::dvec3& pointMm, const glm::dvec3& direction, bool light, Random&& random) const {
        const glm::dvec2 span = inside(pointMm, direction);
        const bool seesAll = light && clip_.removedCastsShadow;
        double at = span.x;
        while (true) {
            at -= std::log1p(-random()) / most_;
            if (at >= span.y) return false;
            const glm::dvec3 mm = pointMm + direction * at;
            const glm::dvec3 voxel = voxelOf(mm);
            const Around a = around(voxel);
            if (!seesAll && isHidden(mm, a)) continue;
            if (random() * most_ >= extinctionAt(voxel, a)) continue;
            pointMm = mm;
            return true;
        }
    }

    double phase(double cosine) const {
        const double g = function_.anisotropy;
        return (1.0 - g * g) / (4.0 * std::numbers::pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
    }
    template <class Random>
    static glm::dvec3 anywhere(Random&& random) {
        const double z = 2.0 * random() - 1.0;
        const double azimuth = 2.0 * std::numbers::pi * random();
        const double radius = std::sqrt(1.0 - z * z);
        return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
    }
    // Half the differences between the two neighbours of a voxel along each axis, each taken where `across`
    // is along the other two, per mm; beyond the outer voxels they go on.
    glm::dvec3 gradientOf(const glm::ivec3& voxel, const glm::ivec3& across) const {
        const glm::ivec3 last = volume_.size() - 1;
        glm::dvec3 perVoxel;
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 at = across;
            const auto valueBeyond = [&](int step) {
                at[axis] = voxel[axis] + step;
                const glm::ivec3 there = glm::clamp(at, glm::ivec3(0), last);
                return volume_.value(there.x, there.y, there.z);
            };
            perVoxel[axis] = 0.5 * (valueBeyond(1) - valueBeyond(-1));
        }
        return glm::transpose(glm::dmat3(voxelFromWorld_)) * perVoxel;
    }
    glm::dvec3 heldInside(const glm::dvec3& voxel) const {
        return glm::clamp(voxel, glm::dvec3(0.0), glm::dvec3(volume_.size() - 1));
    }
    // One of the eight voxels around by its weight, and across a voxel before, there, or beside, with weights
    // of 1/6, 4/6 and 1/6 along each axis: all 216, with their weights.
    std::vector<std::pair<glm::dvec3, double>> gradientsAround(const glm::dvec3& voxel) const {
        if (function_.surface.weight == 0.0) return {{glm::dvec3(0.0), 1.0}};
        const glm::dvec3 inside = heldInside(voxel);
        const glm::ivec3 low(inside);
        std::vector<std::pair<glm::dvec3, double>> all;
        for (int n = 0; n < 216; ++n) {
            const glm::ivec3 cases(n % 6, n / 6 % 6, n / 36);
            const glm::ivec3 up = cases / 3;
            const glm::ivec3 beside = cases % 3 - 1;
            double weight = 1.0;
            for (int axis = 0; axis < 3; ++axis) {
                const double f = inside[axis] - low[axis];
                weight *= (up[axis] == 0 ? 1.0 - f : f) * (beside[axis] == 0 ? 4.0 : 1.0) / 6.0;
            }
            if (weight > 0.0) all.emplace_back(gradientOf(low + up, low + up + beside), weight);
        }
        return all;
    }
    // One of them by chance.
    template <class Random>
    glm::dvec3 gradientNear(const glm::dvec3& voxel, Random&& random) const {
        const glm::dvec3 inside = heldInside(voxel);
        glm::ivec3 chosen(0);
        glm::ivec3 across(0);
        for (int axis = 0; axis < 3; ++axis) {
            chosen[axis] = int(inside[axis] + random());
            const double chance = 6.0 * random();
            across[axis] = chosen[axis] + (chance < 1.0 ? -1 : chance < 2.0 ? 1 : 0);
        }
        return gradientOf(chosen, across);
    }

    // From the direction of travel `from` to `to`, with that gradient: a cloud, and in its part a surface, of
    // which the papers named in shaders/lib/scattering.glsl tell the film, by angles.
    glm::dvec3 scatteredPerSr(const glm::dvec3& gradient, const glm::dvec3& albedo, const glm::dvec3& from,
                              const glm::dvec3& to) const {
        const glm::dvec3 cloud = albedo * phase(glm::dot(from, to));
        const Surface& surface = function_.surface;
        if (surface.weight == 0.0) return cloud;
        const double steep = std::pow(glm::length(gradient) / surface.gradientPerMm, 2.0);
        if (steep == 0.0) return cloud;
        const double share = surface.weight * steep / (1.0 + steep);
        const glm::dvec3 normal = glm::normalize(glm::dot(gradient, from) > 0.0 ? -gradient : gradient);
        return (1.0 - share) * cloud + share * coat_.perSr(normal, albedo, from, to);
    }

    // By rejection from directions of all kinds: no inversion to be wrong in.
    template <class Random>
    glm::dvec3 scattered(const glm::dvec3& direction, Random&& random) const {
        const double highest = phase(function_.anisotropy < 0.0 ? -1.0 : 1.0);
        while (true) {
            const glm::dvec3 way = anywhere(random);
            if (random() * highest < phase(glm::dot(way, direction))) return way;
        }
    }

    // A texel of the sky by what it gives, and a direction in it.
    Beam towardsLight(double which, double u, double v) const {
        const auto chosen = std::upper_bound(powers_.begin(), powers_.end() - 1, which * powers_.back());
        const int texel = int(chosen - powers_.begin());
        const int row = texel / sky_.width;
        const int column = texel % sky_.width;
        // As a panorama seen from inside: the middle looks along z, columns grow towards -x.
        const double up = edge(row) + (edge(row + 1) - edge(row)) * u;
        const double azimuth = rotation_ - 2.0 * std::numbers::pi * ((column + v) / sky_.width - 0.5);
        const double level = std::sqrt(std::max(0.0, 1.0 - up * up));
        const glm::dvec3 local(level * std::sin(azimuth), up, level * std::cos(azimuth));
        Beam beam{};
        beam.direction = sky_.frame == trace::LightFrame::camera
                             ? eye_.right * local.x + eye_.up * local.y - eye_.forward * local.z
                             : glm::dvec3(local.x, -local.z, local.y);  // left, superior, anterior
        const double power =
            powers_[std::size_t(texel)] - (texel == 0 ? 0.0 : powers_[std::size_t(texel - 1)]);
        const double solidAngle = (edge(row) - edge(row + 1)) * 2.0 * std::numbers::pi / sky_.width;
        beam.light = glm::dvec3(sky_.radiance[std::size_t(texel)]) * (solidAngle * powers_.back() / power);
        return beam;
    }

    const Sky& sky_;
    DenseCoat coat_;
    double gain_;
    double rotation_;
    std::vector<double> powers_;  // up to and with each texel
};

}  // namespace macula::scenes
