#include "scene/camera/usual_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/check.h"

namespace macula::scene {

namespace {

constexpr std::array<std::pair<ViewReason, std::string_view>, 4> kNames{
    {{ViewReason::headByCode, "head-by-code"},
     {ViewReason::headByShape, "head-by-shape"},
     {ViewReason::shortScan, "short-scan"},
     {ViewReason::body, "body"}}};

// Codes of PS3.16 Annex L. The neck is not among them: a portrait would not show it.
constexpr std::array<std::string_view, 15> kOfHead{"BRAIN",    "EAR",   "EYE",   "FACE",     "HEAD",
                                                   "HEADNECK", "IAC",   "JAW",   "MANDIBLE", "MAXILLA",
                                                   "NOSE",     "ORBIT", "SINUS", "SKULL",    "TMJ"};

// A head is 120 to 260 mm long along each axis. Between the percentiles an ellipsoid has 0.88 of its length.
constexpr double kLeastHeadMm = 105.0;
constexpr double kMostHeadMm = 260.0;
constexpr double kMostCutAside = 0.1;      // a head touches no side of the volume, except by its holder
constexpr double kLeastPortraitMm = 60.0;  // a lower slab of a head is a thin band like any other
constexpr double kShort = 0.5;

constexpr double kMatterHu = -300.0;
constexpr double kPercentile = 0.01;

// Samples about this many voxels along each axis of the grid.
constexpr int kAlongAxis = 48;

struct Sample {
    glm::dvec3 placeMm{0.0};
    double value = 0.0;
    bool isAside = false;  // at one of the sides of the volume that are not above or below
};

// The axis of the grid that is nearest to the patient's superior-inferior axis.
int longAxis(const Volume& volume) {
    int best = 0;
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = std::abs(glm::normalize(glm::dvec3(volume.worldFromVoxel()[axis])).z);
        if (along > most) most = along, best = axis;
    }
    return best;
}

std::vector<Sample> samplesOf(const Volume& volume) {
    const glm::ivec3 size = volume.size();
    const glm::ivec3 step = glm::max(size / kAlongAxis, glm::ivec3(1));
    const int upright = longAxis(volume);
    std::vector<Sample> samples;
    for (int k = 0; k < size.z; k += step.z) {
        for (int j = 0; j < size.y; j += step.y) {
            for (int i = 0; i < size.x; i += step.x) {
                if (volume.isPadding(i, j, k)) continue;
                const glm::ivec3 at(i, j, k);
                bool isAside = false;
                for (int axis = 0; axis < 3; ++axis)
                    isAside = isAside || (axis != upright &&
                                          (at[axis] < step[axis] || at[axis] + step[axis] >= size[axis]));
                samples.push_back({transformPoint(volume.worldFromVoxel(), glm::dvec3(at)),
                                   volume.value(i, j, k), isAside});
            }
        }
    }
    return samples;
}

// The value above which a voxel is matter; nothing if values cannot tell matter from air.
std::optional<double> leastOfMatter(const Volume& volume, const std::vector<Sample>& samples) {
    if (volume.unit() == Unit::hounsfield) return kMatterHu;
    if (volume.unit() != Unit::raw || samples.empty()) return std::nullopt;
    double sum = 0.0;
    for (const Sample& sample : samples) sum += sample.value;
    return sum / double(samples.size());
}

double reachMm(const std::vector<Sample>& matter, int axis) {
    std::vector<double> places;
    places.reserve(matter.size());
    for (const Sample& sample : matter) places.push_back(sample.placeMm[axis]);
    const auto low = places.begin() + std::ptrdiff_t(kPercentile * double(places.size()));
    const auto high = places.end() - 1 - (low - places.begin());
    std::nth_element(places.begin(), low, places.end());
    const double lowest = *low;
    std::nth_element(low, high, places.end());
    return *high - lowest;
}

bool isAsLargeAsHead(const Volume& volume) {
    const auto extent = matterExtent(volume);
    if (!extent || extent->cutAside > kMostCutAside) return false;
    const auto isWithin = [](double mm) { return mm >= kLeastHeadMm && mm <= kMostHeadMm; };
    return isWithin(extent->sizeMm.x) && isWithin(extent->sizeMm.y) && isWithin(extent->sizeMm.z);
}

}  // namespace

std::string_view nameOf(ViewReason reason) {
    const auto* const found = std::ranges::find(kNames, reason, &decltype(kNames)::value_type::first);
    MACULA_CHECK(found != kNames.end());
    return found->second;
}

bool isOfHead(std::string_view bodyPart) {
    std::string code;
    for (const char c : bodyPart) {
        if (c >= 'a' && c <= 'z') code += char(c - 'a' + 'A');
        if (c >= 'A' && c <= 'Z') code += c;
    }
    return std::ranges::find(kOfHead, code) != kOfHead.end();
}

std::optional<MatterExtent> matterExtent(const Volume& volume) {
    std::vector<Sample> samples = samplesOf(volume);
    const auto least = leastOfMatter(volume, samples);
    if (!least) return std::nullopt;
    const auto aside = std::ranges::count_if(samples, &Sample::isAside);
    std::erase_if(samples, [&](const Sample& sample) { return !(sample.value > *least); });
    if (samples.empty()) return std::nullopt;
    const auto cut = std::ranges::count_if(samples, &Sample::isAside);
    MatterExtent extent;
    for (int axis = 0; axis < 3; ++axis) extent.sizeMm[axis] = reachMm(samples, axis);
    extent.cutAside = double(cut) / double(std::max<std::ptrdiff_t>(aside, 1));
    return extent;
}

bool isShort(const Volume& volume) {
    const Box box = volume.worldBox();
    const glm::dvec3 size = box.high - box.low;
    return size.z < kShort * std::max(size.x, size.y);
}

UsualView usualView(const Volume& volume) {
    const Box box = volume.worldBox();
    if (isOfHead(volume.bodyPart()) && box.high.z - box.low.z >= kLeastPortraitMm)
        return {ViewDirection::threeQuarter, ViewReason::headByCode};
    if (volume.bodyPart().empty() && isAsLargeAsHead(volume))
        return {ViewDirection::threeQuarter, ViewReason::headByShape};
    if (isShort(volume)) return {ViewDirection::oblique, ViewReason::shortScan};
    return {ViewDirection::turned, ViewReason::body};
}

ViewDirection firstDirection(std::optional<ViewDirection> asked, const Volume& volume) {
    return asked ? *asked : usualView(volume).from;
}

Text sentenceOf(const UsualView& view) {
    switch (view.why) {
        case ViewReason::headByCode:
            return Text("The head is seen from the front and above, as the images say that it is one.");
        case ViewReason::headByShape:
            return Text(
                "It is seen from the front and above, as a head is: what was scanned is as large as one.");
        case ViewReason::shortScan:
            return Text("The scan is seen obliquely from above: it is less than half as high as it is wide.");
        case ViewReason::body:
            return Text("The patient is seen from the front, slightly turned.");
    }
    return {};
}

}  // namespace macula::scene
