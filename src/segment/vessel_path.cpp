#include "segment/vessel_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

#include "base/frames.h"

namespace macula::segment {

namespace {

constexpr double kMarginMm = 30.0;
constexpr double kWeight = 30.0;         // of a difference as large as the scale, against the length
constexpr double kMostDifference = 4.0;  // in scales: beyond, all values are equally unlike
constexpr double kSpacingMm = 3.0;       // of the points of the result
constexpr double kSmoothMm = 3.0;
constexpr int kCheckEvery = 4096;

struct VoxelBox {
    glm::ivec3 low{0};
    glm::ivec3 size{1};

    bool contains(const glm::ivec3& voxel) const {
        return glm::all(glm::greaterThanEqual(voxel, low)) && glm::all(glm::lessThan(voxel, low + size));
    }
    std::size_t index(const glm::ivec3& voxel) const {
        const glm::ivec3 at = voxel - low;
        return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
               std::size_t(at.x);
    }
    std::size_t count() const { return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z); }
};

std::array<glm::ivec3, 26> neighbours() {
    std::array<glm::ivec3, 26> all;
    std::size_t n = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x != 0 || y != 0 || z != 0) all.at(n++) = {x, y, z};
    return all;
}

// The mean of the 27 voxels around; NaN without any value.
double meanAround(const Volume& volume, const glm::ivec3& voxel) {
    double sum = 0.0;
    int values = 0;
    const glm::ivec3 low = glm::max(voxel - 1, glm::ivec3(0));
    const glm::ivec3 high = glm::min(voxel + 1, volume.size() - 1);
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) {
                const double value = volume.isPadding(i, j, k) ? std::nan("") : volume.value(i, j, k);
                if (!std::isfinite(value)) continue;
                sum += value;
                ++values;
            }
    return values > 0 ? sum / values : std::numeric_limits<double>::quiet_NaN();
}

// How unlike the vessel a value is: 0 for that of the place, 1 at the scale.
class Likeness {
  public:
    // The scale is half of the difference between the place and what is around it, as far as a vessel is
    // wide.
    Likeness(const Volume& volume, const glm::ivec3& from, const glm::ivec3& to) {
        const double a = meanAround(volume, from);
        const double b = meanAround(volume, to);
        usual_ = std::isnan(a) ? b : std::isnan(b) ? a : 0.5 * (a + b);
        double most = std::abs(a - b);
        for (const glm::ivec3& place : {from, to})
            for (const glm::ivec3& step : neighbours()) {
                const glm::ivec3 at = glm::clamp(place + 8 * step, glm::ivec3(0), volume.size() - 1);
                const double unlike = std::abs(meanAround(volume, at) - usual_);
                if (std::isfinite(unlike)) most = std::max(most, unlike);
            }
        scale_ = most > 0.0 ? 0.5 * most : 1.0;
    }

    double cost(double mean) const {
        const double unlike = std::abs(mean - usual_) / scale_;
        const double bounded = std::isnan(unlike) ? kMostDifference : std::min(unlike, kMostDifference);
        return 1.0 + kWeight * bounded * bounded;
    }
    double likeness(double mean) const {
        const double unlike = std::abs(mean - usual_) / scale_;
        return unlike < 1.0 ? 1.0 - unlike : 0.0;
    }

  private:
    double usual_ = 0.0;
    double scale_ = 1.0;
};

class Search {
  public:
    Search(const Volume& volume, const VoxelBox& box, const Likeness& likeness)
        : volume_(volume),
          box_(box),
          likeness_(likeness),
          costs_(box.count(), std::numeric_limits<float>::infinity()),
          means_(box.count(), std::numeric_limits<float>::infinity()),
          cameBy_(box.count(), kNone) {
        for (std::size_t n = 0; n < steps_.size(); ++n)
            lengths_.at(n) = glm::length(glm::dmat3(volume.worldFromVoxel()) * glm::dvec3(steps_.at(n)));
    }

    // The voxels on the way, both ends included; empty when cancelled.
    std::vector<glm::ivec3> way(const glm::ivec3& from, const glm::ivec3& to, const CancelToken& token) {
        const auto least = [&](const glm::ivec3& voxel) {
            return glm::length(glm::dmat3(volume_.worldFromVoxel()) * glm::dvec3(to - voxel));
        };
        costs_[box_.index(from)] = 0.0f;
        queue_.push({.total = float(least(from)), .voxel = from});
        for (int n = 0; !queue_.empty(); ++n) {
            if (n % kCheckEvery == 0 && token.cancelled()) return {};
            const Open open = queue_.top();
            queue_.pop();
            if (open.voxel == to) return backFrom(to, from);
            const double cost = costs_[box_.index(open.voxel)];
            if (open.total > float(cost + least(open.voxel)) * 1.00001f) continue;  // found cheaper since
            for (std::size_t s = 0; s < steps_.size(); ++s) {
                const glm::ivec3 next = open.voxel + steps_.at(s);
                if (!box_.contains(next)) continue;
                const std::size_t index = box_.index(next);
                const auto reached = float(cost + lengths_.at(s) * likeness_.cost(mean(next, index)));
                if (!(reached < costs_[index])) continue;
                costs_[index] = reached;
                cameBy_[index] = std::uint8_t(s);
                queue_.push({.total = reached + float(least(next)), .voxel = next});
            }
        }
        return {};
    }

  private:
    static constexpr std::uint8_t kNone = 255;
    struct Open {
        float total = 0.0f;
        glm::ivec3 voxel{0};
        bool operator<(const Open& other) const { return total > other.total; }  // the least on top
    };

    double mean(const glm::ivec3& voxel, std::size_t index) {
        if (std::isinf(means_[index])) means_[index] = float(meanAround(volume_, voxel));
        return means_[index];
    }

    std::vector<glm::ivec3> backFrom(const glm::ivec3& to, const glm::ivec3& from) const {
        std::vector<glm::ivec3> way{to};
        while (way.back() != from) way.push_back(way.back() - steps_.at(cameBy_[box_.index(way.back())]));
        std::ranges::reverse(way);
        return way;
    }

    const Volume& volume_;
    VoxelBox box_;
    const Likeness& likeness_;
    std::array<glm::ivec3, 26> steps_ = neighbours();
    std::array<double, 26> lengths_{};
    std::vector<float> costs_;
    std::vector<float> means_;  // infinite: not known yet
    std::vector<std::uint8_t> cameBy_;
    std::priority_queue<Open> queue_;
};

// The point moved to the middle of the values like the vessel's around it, some times.
glm::dvec3 centred(const Volume& volume, const Likeness& likeness, const glm::dvec3& start) {
    constexpr int kReach = 3;
    constexpr int kRounds = 4;
    glm::dvec3 voxel = start;
    for (int round = 0; round < kRounds; ++round) {
        glm::dvec3 sum(0.0);
        double weight = 0.0;
        const glm::ivec3 middle(glm::round(voxel));
        const glm::ivec3 low = glm::max(middle - kReach, glm::ivec3(0));
        const glm::ivec3 high = glm::min(middle + kReach, volume.size() - 1);
        for (int k = low.z; k <= high.z; ++k)
            for (int j = low.y; j <= high.y; ++j)
                for (int i = low.x; i <= high.x; ++i) {
                    const double like = likeness.likeness(meanAround(volume, {i, j, k}));
                    sum += like * glm::dvec3(i, j, k);
                    weight += like;
                }
        if (!(weight > 0.0)) break;
        voxel = glm::mix(voxel, sum / weight, 0.5);
    }
    return voxel;
}

// A mean over the neighbourhood of each point, and points kSpacingMm apart; the ends stay.
std::vector<glm::dvec3> smoothed(const std::vector<glm::dvec3>& wayMm) {
    std::vector<double> atMm(wayMm.size(), 0.0);
    for (std::size_t i = 1; i < wayMm.size(); ++i)
        atMm[i] = atMm[i - 1] + glm::distance(wayMm[i - 1], wayMm[i]);
    std::vector<glm::dvec3> points{wayMm.front()};
    const auto count = std::size_t(std::floor(atMm.back() / kSpacingMm));
    for (std::size_t n = 1; n < count; ++n) {
        const double wanted = atMm.back() * double(n) / double(count);
        glm::dvec3 sum(0.0);
        double weight = 0.0;
        for (std::size_t i = 0; i < wayMm.size(); ++i) {
            const double near = 1.0 - std::abs(atMm[i] - wanted) / kSmoothMm;
            if (near <= 0.0) continue;
            sum += near * wayMm[i];
            weight += near;
        }
        if (weight > 0.0) points.push_back(sum / weight);
    }
    points.push_back(wayMm.back());
    return points;
}

Error tooFar() {
    return {.code = ErrorCode::usage,
            .message = Text("The places are too far apart to look for a way between them."),
            .where = {},
            .hint = Text("Set a place between them.")};
}

Result<std::vector<glm::dvec3>> between(const Volume& volume, const glm::ivec3& from, const glm::ivec3& to,
                                        const CancelToken& token) {
    const glm::dmat3 world(volume.worldFromVoxel());
    glm::ivec3 margin;
    for (int axis = 0; axis < 3; ++axis)
        margin[axis] = int(std::ceil(std::min(kMarginMm / glm::length(world[axis]), 1e6)));
    VoxelBox box{.low = glm::max(glm::min(from, to) - margin, glm::ivec3(0))};
    box.size = glm::min(glm::max(from, to) + margin + 1, volume.size()) - box.low;
    if (box.count() > kMostSearchedVoxels) return tooFar();
    const Likeness likeness(volume, from, to);
    const std::vector<glm::ivec3> way = Search(volume, box, likeness).way(from, to, token);
    if (way.empty())
        return Error{.code = ErrorCode::cancelled,
                     .message = Text("Looking for the way of the vessel was cancelled."),
                     .where = {},
                     .hint = {}};
    std::vector<glm::dvec3> mm;
    for (const glm::ivec3& voxel : way) {
        const bool isEnd = voxel == from || voxel == to;
        const glm::dvec3 at = isEnd ? glm::dvec3(voxel) : centred(volume, likeness, glm::dvec3(voxel));
        mm.push_back(transformPoint(volume.worldFromVoxel(), at));
    }
    return smoothed(mm);
}

}  // namespace

Result<std::vector<glm::dvec3>> vesselPath(const Volume& volume, std::span<const glm::dvec3> placesMm,
                                           const CancelToken& token) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    std::vector<glm::ivec3> places;
    for (const glm::dvec3& mm : placesMm) {
        const glm::dvec3 voxel = glm::round(transformPoint(voxelFromWorld, mm));
        const bool isInside = glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.0))) &&
                              glm::all(glm::lessThan(voxel, glm::dvec3(volume.size())));
        if (isInside && (places.empty() || glm::ivec3(voxel) != places.back())) places.emplace_back(voxel);
    }
    if (places.size() < 2)
        return Error{.code = ErrorCode::usage,
                     .message = Text("A way needs two places in the volume."),
                     .where = {},
                     .hint = Text("Set a place at each end of the vessel with the curve tool.")};
    std::vector<glm::dvec3> wayMm;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        Result<std::vector<glm::dvec3>> part = between(volume, places[i], places[i + 1], token);
        if (!part) return part.error();
        wayMm.insert(wayMm.end(), part->begin() + (wayMm.empty() ? 0 : 1), part->end());
    }
    return wayMm;
}

}  // namespace macula::segment
