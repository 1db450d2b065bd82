#include "segment/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace macula::segment {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// The parabolas of the blocks of one line: squared distances along it, added to those from the passes along
// other axes.
class Envelope {
  public:
    Envelope(int blocks, double spacingMm)
        : spacingMm2_(spacingMm * spacingMm),
          squaredMm2_(std::size_t(blocks)),
          lowest_(std::size_t(blocks)) {}

    // Replaces the squared distances of a line by those of its envelope.
    void pass(double* first, std::size_t stride) {
        const int blocks = static_cast<int>(squaredMm2_.size());
        for (int at = 0; at < blocks; ++at) squaredMm2_[std::size_t(at)] = first[std::size_t(at) * stride];
        const std::size_t count = findLowest();
        if (count == 0) return;
        std::size_t n = 0;
        for (int at = 0; at < blocks; ++at) {
            while (n + 1 < count && lowest_[n + 1].from < at) ++n;
            const double away = at - lowest_[n].centre;
            first[std::size_t(at) * stride] =
                spacingMm2_ * away * away + squaredMm2_[std::size_t(lowest_[n].centre)];
        }
    }

  private:
    struct Parabola {
        int centre = 0;
        double from = -kFar;  // lowest from here, in blocks, to the beginning of the next one
    };

    // Puts the parabolas that are lowest somewhere into `lowest_`, in order; returns their number.
    std::size_t findLowest() {
        std::size_t count = 0;
        for (int at = 0; at < static_cast<int>(squaredMm2_.size()); ++at) {
            if (squaredMm2_[std::size_t(at)] == kFar) continue;
            double from = -kFar;
            for (; count > 0; --count) {
                from = crossing(lowest_[count - 1].centre, at);
                if (from > lowest_[count - 1].from) break;
            }
            lowest_[count] = {at, count == 0 ? -kFar : from};
            ++count;
        }
        return count;
    }

    double crossing(int left, int right) const {
        const double rise = squaredMm2_[std::size_t(right)] - squaredMm2_[std::size_t(left)];
        return 0.5 * (rise / (spacingMm2_ * (right - left)) + right + left);
    }

    double spacingMm2_;
    std::vector<double> squaredMm2_;
    std::vector<Parabola> lowest_;
};

}  // namespace

std::vector<float> distanceTo(const Grid& grid, const Mask& mask, const CancelToken& token) {
    const int na = grid.size.x, nb = grid.size.y, nc = grid.size.z;
    std::vector<double> mm2(mask.size());
    std::transform(mask.begin(), mask.end(), mm2.begin(),
                   [](std::uint8_t in) { return in != 0 ? 0.0 : kFar; });
    const auto along = [&](int blocks, double spacingMm, int lines, int sheets, auto firstOf,
                           std::size_t stride) {
        parallelFor(
            std::size_t(sheets),
            [&](std::size_t sheet) {
                Envelope envelope(blocks, spacingMm);
                for (int line = 0; line < lines; ++line)
                    envelope.pass(mm2.data() + firstOf(line, static_cast<int>(sheet)), stride);
            },
            token);
    };
    along(
        na, grid.spacingMm.x, nb, nc, [&](int b, int c) { return grid.index(0, b, c); }, 1);
    along(
        nb, grid.spacingMm.y, na, nc, [&](int a, int c) { return grid.index(a, 0, c); }, std::size_t(na));
    along(
        nc, grid.spacingMm.z, na, nb, [&](int a, int b) { return grid.index(a, b, 0); }, grid.sliceSize());
    std::vector<float> mm(mask.size());
    std::transform(mm2.begin(), mm2.end(), mm.begin(),
                   [](double squared) { return static_cast<float>(std::sqrt(squared)); });
    return mm;
}

Opened opened(const Grid& grid, const Mask& mask, double radiusMm) {
    Mask other(mask.size());
    std::transform(mask.begin(), mask.end(), other.begin(),
                   [](std::uint8_t in) { return std::uint8_t(in != 0 ? 0 : 1); });
    std::vector<float> depthMm = distanceTo(grid, other);
    const auto radius = static_cast<float>(radiusMm);
    std::transform(depthMm.begin(), depthMm.end(), other.begin(),
                   [&](float depth) { return std::uint8_t(depth > radius ? 1 : 0); });
    const std::vector<float> toCore = distanceTo(grid, other);
    for (std::size_t n = 0; n < mask.size(); ++n) other[n] = mask[n] != 0 && toCore[n] <= radius ? 1 : 0;
    return {std::move(other), std::move(depthMm)};
}

}  // namespace macula::segment
