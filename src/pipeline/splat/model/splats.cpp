#include "pipeline/splat/model/splats.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/is_finite.h"

namespace macula::splat {

namespace {

// Whether the quaternion can be normalised: its inverse length must be finite too, which excludes a subnormal
// square.
bool isRotation(const glm::vec4& q) {
    return std::isnormal(glm::dot(q, q));
}

bool isGood(const Splats& splats, std::size_t i) {
    const std::size_t count = shCount(splats.shDegree);
    const auto first = splats.sh.begin() + static_cast<std::ptrdiff_t>(i * count);
    return isFinite(splats.position[i]) && isFinite(splats.logScale[i]) && isRotation(splats.rotation[i]) &&
           std::isfinite(splats.opacityLogit[i]) && isFinite(splats.dc[i]) &&
           std::all_of(first, first + static_cast<std::ptrdiff_t>(count),
                       [](const glm::vec3& sh) { return isFinite(sh); });
}

// Checks everything except the single splats.
Result<void> validateWhole(const Splats& splats) {
    if (splats.shDegree < 0 || splats.shDegree > kMaxShDegree)
        return Error{ErrorCode::inputNotUsable,
                     Text("The model has spherical harmonics of degree {}; 0 to {} are supported.",
                          splats.shDegree, kMaxShDegree),
                     {},
                     Text("Export it with a lower degree.")};
    const std::size_t count = splats.size();
    if (splats.logScale.size() != count || splats.rotation.size() != count ||
        splats.opacityLogit.size() != count || splats.dc.size() != count ||
        splats.sh.size() != count * shCount(splats.shDegree))
        return Error{
            ErrorCode::inputNotUsable,
            Text("The model is damaged: it does not have the same number of entries for all properties."),
            {},
            Text("Load or train it again.")};
    const glm::dvec3& o = splats.originMm;
    if (!std::isfinite(o.x) || !std::isfinite(o.y) || !std::isfinite(o.z))
        return Error{ErrorCode::inputNotUsable,
                     Text("The model's place in the patient is not a number."),
                     {},
                     Text("Load or train it again.")};
    return {};
}

// Clamps the value, and returns true if that changed it. NaN stays.
bool clampTo(float& value, float limit) {
    if (!(std::abs(value) > limit)) return false;
    value = std::copysign(limit, value);
    return true;
}

// The logarithm of the largest plausible standard deviation: a splat many times as large as the whole model
// covers every picture like fog, and comes from a damaged file. For models of few splats, or with all of them
// in one place, the splats' own size is the measure.
float largestLogScale(const Splats& splats) {
    constexpr double kTimesTheModel = 10.0;
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    std::vector<float> scales;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const glm::vec3& scale = splats.logScale[i];
        const float largest = std::max({scale.x, scale.y, scale.z});
        if (!isFinite(splats.position[i]) || !(largest <= kMaxLogScale)) continue;
        low = glm::min(low, glm::dvec3(splats.position[i]));
        high = glm::max(high, glm::dvec3(splats.position[i]));
        scales.push_back(largest);
    }
    if (scales.empty()) return kMaxLogScale;
    const auto middle = scales.begin() + static_cast<std::ptrdiff_t>((scales.size() - 1) / 2);
    std::nth_element(scales.begin(), middle, scales.end());
    const double extent = std::max(glm::length(high - low), std::exp(double{*middle}));
    return static_cast<float>(std::min(std::log(kTimesTheModel * extent), double{kMaxLogScale}));
}

}  // namespace

void Splats::resize(std::size_t count) {
    position.resize(count, glm::vec3(0.0f));
    logScale.resize(count, glm::vec3(0.0f));
    rotation.resize(count, glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
    opacityLogit.resize(count, 0.0f);
    dc.resize(count, glm::vec3(0.0f));
    sh.resize(count * shCount(shDegree), glm::vec3(0.0f));
}

void Splats::append(const Splats& from, std::size_t i) {
    position.push_back(from.position[i]);
    logScale.push_back(from.logScale[i]);
    rotation.push_back(from.rotation[i]);
    opacityLogit.push_back(from.opacityLogit[i]);
    dc.push_back(from.dc[i]);
    const std::size_t count = shCount(from.shDegree);
    for (std::size_t k = 0; k < count; ++k) sh.push_back(from.sh[i * count + k]);
}

void Splats::setShDegree(int degree) {
    MACULA_CHECK(degree >= 0 && degree <= kMaxShDegree);
    const std::size_t before = shCount(shDegree);
    const std::size_t after = shCount(degree);
    std::vector<glm::vec3> bands(size() * after, glm::vec3(0.0f));
    for (std::size_t i = 0; i < size(); ++i) {
        for (std::size_t k = 0; k < std::min(before, after); ++k) bands[i * after + k] = sh[i * before + k];
    }
    sh = std::move(bands);
    shDegree = degree;
}

Result<void> Splats::validate() const {
    MACULA_TRY_VOID(validateWhole(*this));
    std::size_t bad = 0;
    for (std::size_t i = 0; i < size(); ++i) bad += isGood(*this, i) ? 0 : 1;
    if (bad > 0)
        return Error{ErrorCode::inputNotUsable,
                     Text("{} of the {} splats of the model hold values that are not numbers.", bad, size()),
                     {},
                     Text("Export or train it again.")};
    return {};
}

Result<Repair> repair(Splats& splats) {
    MACULA_TRY_VOID(validateWhole(splats));
    Repair done;
    const float largest = largestLogScale(splats);
    const std::size_t coefficients = shCount(splats.shDegree);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const glm::vec3& scale = splats.logScale[i];
        const bool floods = std::max({scale.x, scale.y, scale.z}) > largest;
        bool clamped = clampTo(splats.opacityLogit[i], kMaxOpacityLogit);
        for (int axis = 0; axis < 3; ++axis) clamped |= clampTo(splats.logScale[i][axis], kMaxLogScale);
        if (floods || !isGood(splats, i)) {
            ++done.dropped;
            continue;
        }
        done.clamped += clamped ? 1 : 0;
        if (kept != i) {
            splats.position[kept] = splats.position[i];
            splats.logScale[kept] = splats.logScale[i];
            splats.rotation[kept] = splats.rotation[i];
            splats.opacityLogit[kept] = splats.opacityLogit[i];
            splats.dc[kept] = splats.dc[i];
            for (std::size_t k = 0; k < coefficients; ++k)
                splats.sh[kept * coefficients + k] = splats.sh[i * coefficients + k];
        }
        ++kept;
    }
    splats.resize(kept);
    return done;
}

Box boundingBox(const Splats& splats) {
    Box box{glm::dvec3(std::numeric_limits<double>::infinity()),
            glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (const glm::vec3& p : splats.position) {
        box.low = glm::min(box.low, splats.originMm + glm::dvec3(p));
        box.high = glm::max(box.high, splats.originMm + glm::dvec3(p));
    }
    return box;
}

}  // namespace macula::splat
