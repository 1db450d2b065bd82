// The coat of a surface, from the papers that shaders/lib/scattering.glsl names, by angles and in double.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "pipeline/volume/transfer_function.h"

namespace macula::scenes {

class DenseCoat {
  public:
    explicit DenseCoat(const Surface& surface)
        : alpha2_(std::pow(surface.roughness, 4.0)), reflectance_(surface.reflectance) {
        // Between 33 cosines the albedo is linear in their root: that is how it is defined.
        for (int i = 0; i <= 32; ++i) albedo_.push_back(integrated(std::max(std::pow(i / 32.0, 2.0), 1e-4)));
        constexpr int kCosines = 4000;
        for (int i = 0; i < kCosines; ++i) {
            const double cosine = (i + 0.5) / kCosines;
            mean_ += albedo(cosine) * 2.0 * cosine / kCosines;
        }
    }

    double albedo(double cosine) const {
        const double at = 32.0 * std::sqrt(std::clamp(cosine, 0.0, 1.0));
        const auto low = std::size_t(std::min(at, 31.0));
        return albedo_[low] + (albedo_[low + 1] - albedo_[low]) * (at - double(low));
    }

    // Per steradian, with the cosine after: of what comes along `from` and goes along `to`, both unit, off a
    // surface with that body; 0 through it.
    glm::dvec3 perSr(const glm::dvec3& normal, const glm::dvec3& body, const glm::dvec3& from,
                     const glm::dvec3& to) const {
        const double in = std::acos(std::clamp(-glm::dot(from, normal), 0.0, 1.0));
        const double out = std::acos(std::clamp(glm::dot(to, normal), -1.0, 1.0));
        if (out >= std::numbers::pi / 2.0) return glm::dvec3(0.0);
        const glm::dvec3 half = glm::normalize(to - from);
        const double theta = std::acos(std::min(glm::dot(half, normal), 1.0));
        const double facets = alpha2_ / (std::numbers::pi * std::pow(std::cos(theta), 4.0) *
                                         std::pow(alpha2_ + std::pow(std::tan(theta), 2.0), 2.0));
        const double coat =
            facets * fresnel(glm::dot(half, to)) / ((1.0 + lambda(in) + lambda(out)) * 4.0 * std::cos(in));
        const double enters =
            (1.0 - albedo(std::cos(in))) * (1.0 - albedo(std::cos(out))) / std::max(1.0 - mean_, 1e-3);
        return glm::dvec3(coat) + body * (enters * std::cos(out) / std::numbers::pi);
    }

  private:
    double lambda(double angle) const {
        return (std::sqrt(1.0 + alpha2_ * std::pow(std::tan(angle), 2.0)) - 1.0) / 2.0;
    }
    double fresnel(double cosine) const {
        return reflectance_ + (1.0 - reflectance_) * std::pow(1.0 - cosine, 5.0);
    }
    // The integral over facets, as dense as there are, of what each sends out above the surface.
    double integrated(double cosine) const {
        const glm::dvec3 before(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
        constexpr int kSide = 200;
        double sum = 0.0;
        for (int i = 0; i < kSide; ++i) {
            const double u = (i + 0.5) / kSide;
            const double theta = std::atan(std::sqrt(alpha2_ * u / (1.0 - u)));
            for (int j = 0; j < kSide; ++j) {
                const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSide;
                const glm::dvec3 facet(std::sin(theta) * std::cos(turn), std::sin(theta) * std::sin(turn),
                                       std::cos(theta));
                const double seen = glm::dot(before, facet);
                const glm::dvec3 after = 2.0 * seen * facet - before;
                if (seen <= 0.0 || after.z <= 0.0) continue;
                sum += fresnel(seen) * seen / (cosine * facet.z) /
                       (1.0 + lambda(std::acos(cosine)) + lambda(std::acos(after.z)));
            }
        }
        return std::min(sum / (kSide * kSide), 1.0);
    }

    double alpha2_;
    double reflectance_;
    std::vector<double> albedo_;
    double mean_ = 0.0;
};

}  // namespace macula::scenes
