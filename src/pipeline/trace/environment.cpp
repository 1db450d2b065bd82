#include "pipeline/trace/environment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace macula::trace {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr int kRigWidth = 512;
constexpr int kRigHeight = 256;
constexpr double kRimFraction = 0.25;  // of a soft light's radius, over which it fades

// Solid angle of one texel of a row, exact.
double texelSolidAngle(int row, int width, int height) {
    const double top = std::cos(kPi * row / height);
    const double bottom = std::cos(kPi * (row + 1) / height);
    return (top - bottom) * 2.0 * kPi / width;
}

double luminance(const glm::dvec3& c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

// Appends where each share of the unit interval begins; shares are proportional to `weights`, or even if all
// weights are 0.
void appendShares(std::vector<float>& begins, std::span<const double> weights) {
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0.0;
    for (const double weight : weights) {
        begins.push_back(static_cast<float>(std::min(sum, 1.0)));
        sum += total > 0.0 ? weight / total : 1.0 / double(weights.size());
    }
}

// The width of a share, from the stored floats, so that the pdf is that of the actual sampling.
double widthOfShare(std::span<const float> begins, std::size_t i) {
    return (i + 1 < begins.size() ? double(begins[i + 1]) : 1.0) - double(begins[i]);
}

// Resamples to newWidth x newHeight: each new texel is the mean, by solid angle, of the old ones it covers,
// in part or whole.
std::vector<glm::vec3> averagedDown(int width, int height, std::span<const glm::vec3> radiance, int newWidth,
                                    int newHeight) {
    std::vector<glm::vec3> result(std::size_t(newWidth) * std::size_t(newHeight));
    for (int y = 0; y < newHeight; ++y) {
        const double top = double(y) * height / newHeight;
        const double bottom = double(y + 1) * height / newHeight;
        for (int x = 0; x < newWidth; ++x) {
            const double left = double(x) * width / newWidth;
            const double right = double(x + 1) * width / newWidth;
            glm::dvec3 sum(0.0);
            double total = 0.0;
            for (int row = int(top); row < height && row < bottom; ++row) {
                // The part of the old row inside the new one, as solid angle per unit of azimuth.
                const double share = std::cos(kPi * std::max(top, double(row)) / height) -
                                     std::cos(kPi * std::min(bottom, row + 1.0) / height);
                for (int column = int(left); column < width && column < right; ++column) {
                    const double overlap = std::min(right, column + 1.0) - std::max(left, double(column));
                    const double weight = share * overlap;
                    sum += weight *
                           glm::dvec3(radiance[std::size_t(row) * std::size_t(width) + std::size_t(column)]);
                    total += weight;
                }
            }
            result[std::size_t(y) * std::size_t(newWidth) + std::size_t(x)] = sum / total;
        }
    }
    return result;
}

// Unit vector in the environment's frame.
glm::dvec3 directionOf(double azimuth, double elevation) {
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

double smoothFall(double angle, double radius) {
    const double inner = radius * (1.0 - kRimFraction);
    const double t = std::clamp((angle - inner) / (radius - inner), 0.0, 1.0);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

glm::dvec3 rigRadiance(const LightRig& rig, const glm::dvec3& direction) {
    const double y = direction.y;
    glm::dvec3 sum = y >= 0.0 ? glm::mix(rig.ambientHorizon, rig.ambientZenith, y)
                              : glm::mix(rig.ambientHorizon, rig.ambientNadir, -y);
    for (const SoftLight& light : rig.lights) {
        const glm::dvec3 centre =
            directionOf(glm::radians(light.azimuthDeg), glm::radians(light.elevationDeg));
        const double angle = std::acos(std::clamp(glm::dot(direction, centre), -1.0, 1.0));
        sum += light.radiance * smoothFall(angle, glm::radians(light.angularRadiusDeg)) * light.colour;
    }
    return sum;
}

}  // namespace

Result<Environment> Environment::fromImage(int width, int height, std::span<const glm::vec3> radiance,
                                           LightFrame frame) {
    const auto fail = [](Text message) {
        return Error{ErrorCode::inputNotUsable,
                     std::move(message),
                     {},
                     Text("Choose another environment, or a built-in light rig.")};
    };
    if (width < 1 || height < 1 || radiance.size() != std::size_t(width) * std::size_t(height)) {
        return fail(Text("The environment picture is empty."));
    }
    for (const glm::vec3& c : radiance) {
        if (!(c.r >= 0.0f && c.g >= 0.0f && c.b >= 0.0f && c.r <= kLargest && c.g <= kLargest &&
              c.b <= kLargest)) {
            return fail(Text("The environment picture has values that are negative or not finite."));
        }
    }
    if (width > kMaxWidth || height > kMaxWidth) {
        const double scale = double(kMaxWidth) / std::max(width, height);
        const int newWidth = std::max(1, static_cast<int>(width * scale));
        const int newHeight = std::max(1, static_cast<int>(height * scale));
        const std::vector<glm::vec3> smaller = averagedDown(width, height, radiance, newWidth, newHeight);
        return fromImage(newWidth, newHeight, smaller, frame);
    }

    Environment environment;
    environment.width_ = width;
    environment.height_ = height;
    environment.frame_ = frame;
    environment.texels_.resize(radiance.size());
    std::vector<double> power(radiance.size());
    for (int row = 0; row < height; ++row) {
        const double angle = texelSolidAngle(row, width, height);
        for (int column = 0; column < width; ++column) {
            const std::size_t i = std::size_t(row) * std::size_t(width) + std::size_t(column);
            power[i] = luminance(radiance[i]) * angle;
        }
    }
    const auto columns = std::size_t(width);
    std::vector<double> rows;
    for (int row = 0; row < height; ++row) {
        const auto first = power.begin() + std::ptrdiff_t(row) * width;
        rows.push_back(std::accumulate(first, first + width, 0.0));
    }
    std::vector<float>& begins = environment.cumulative_;
    appendShares(begins, rows);
    for (int row = 0; row < height; ++row)
        appendShares(begins, std::span(power).subspan(std::size_t(row) * columns, columns));
    const double allPower = std::accumulate(rows.begin(), rows.end(), 0.0);
    const bool isLit = allPower > 0.0;
    environment.meanLuminance_ = allPower / (4.0 * kPi);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const std::size_t row = i / columns;
        const std::span<const float> within =
            std::span<const float>(begins).subspan(rows.size() + row * columns, columns);
        const double share = widthOfShare(std::span<const float>(begins).first(rows.size()), row) *
                             widthOfShare(within, i % columns);
        const double pdf = isLit ? share / texelSolidAngle(int(row), width, height) : 0.0;
        environment.texels_[i] = {radiance[i], static_cast<float>(pdf)};
    }
    return environment;
}

Environment Environment::fromRig(const LightRig& rig) {
    std::vector<glm::vec3> radiance(std::size_t(kRigWidth) * std::size_t(kRigHeight));
    for (int row = 0; row < kRigHeight; ++row) {
        const double elevation = kPi * (0.5 - (row + 0.5) / kRigHeight);
        for (int column = 0; column < kRigWidth; ++column) {
            const double azimuth =
                -2.0 * kPi * ((column + 0.5) / kRigWidth - 0.5);  // columns grow towards -x
            radiance[std::size_t(row) * kRigWidth + std::size_t(column)] =
                glm::max(rigRadiance(rig, directionOf(azimuth, elevation)), glm::dvec3(0.0));
        }
    }
    return std::move(fromImage(kRigWidth, kRigHeight, radiance, rig.frame)).value();
}

Environment Environment::constant(const glm::vec3& radiance) {
    constexpr int kWidth = 4;
    constexpr int kHeight = 2;
    const std::vector<glm::vec3> sky(std::size_t(kWidth) * kHeight, radiance);
    return std::move(fromImage(kWidth, kHeight, sky)).value();
}

}  // namespace macula::trace
