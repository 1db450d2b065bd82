#include "slices/contour_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace macula::slices {

namespace {

constexpr std::size_t kCorners = 4;

// A side between two neighbouring pixels: 2 * (index of the left or upper one), plus 1 if it goes down.
using Side = std::int64_t;

// Joins the pieces of all squares. A piece runs from side to side with the high values on one hand, so each
// side begins at most one piece and ends at most one.
class Lines {
  public:
    Lines(const SampledSlice& slice, double level)
        : values_(slice.values), width_(slice.sizePx.x), level_(level) {}

    void addSquare(int x, int y) {
        const std::int64_t first = std::int64_t(y) * width_ + x;
        // Clockwise from the upper left; side n follows corner n.
        const std::array<std::int64_t, kCorners> corners{first, first + 1, first + width_ + 1,
                                                         first + width_};
        std::array<double, kCorners> values{};
        unsigned high = 0;
        for (std::size_t n = 0; n < kCorners; ++n) {
            values[n] = values_[std::size_t(corners[n])];
            if (std::isnan(values[n])) return;
            high |= values[n] >= level_ ? 1u << n : 0u;
        }
        if (high == 0 || high == 15) return;
        const std::array<Side, kCorners> sides{2 * first, 2 * (first + 1) + 1, 2 * (first + width_),
                                               2 * first + 1};
        const bool isSaddle = high == 5 || high == 10;
        const bool joinsHigh = isSaddle && saddleOf(values) >= level_;
        for (std::size_t n = 0; n < kCorners; ++n) {
            const bool isHigh = (high >> n & 1u) != 0;
            const bool nextIsHigh = (high >> (n + 1) % kCorners & 1u) != 0;
            if (!isHigh || nextIsHigh) continue;
            next_[sides[n]] = sides[endOf(n, high, isSaddle, joinsHigh)];
        }
    }

    std::vector<ContourLine> take() {
        std::vector<ContourLine> lines;
        std::vector<Side> begins;
        std::unordered_map<Side, int> isEnd;
        for (const auto& [from, to] : next_) isEnd[to] = 1;
        for (const auto& [from, to] : next_)
            if (isEnd.find(from) == isEnd.end()) begins.push_back(from);
        std::ranges::sort(begins);  // the order of an unordered map is nobody's
        for (const Side side : begins) addLine(side, lines);
        std::vector<Side> closed;
        for (const auto& [from, to] : next_) closed.push_back(from);
        std::ranges::sort(closed);
        for (const Side side : closed)
            if (next_.find(side) != next_.end()) addLine(side, lines);
        return lines;
    }

  private:
    // The side at which the piece ends that begins after the high corner `n`.
    static std::size_t endOf(std::size_t n, unsigned high, bool isSaddle, bool joinsHigh) {
        if (isSaddle) return (n + (joinsHigh ? 1 : 3)) % kCorners;
        std::size_t end = (n + 1) % kCorners;
        while ((high >> (end + 1) % kCorners & 1u) == 0) end = (end + 1) % kCorners;
        return end;
    }

    // Of the bilinear surface through the corners; they alternate, so that the divisor is not 0.
    static double saddleOf(const std::array<double, kCorners>& v) {
        const double divisor = v[0] + v[2] - v[1] - v[3];
        return (v[0] * v[2] - v[1] * v[3]) / divisor;
    }

    glm::dvec2 pointOn(Side side) const {
        const std::int64_t first = side / 2;
        const bool isDown = side % 2 != 0;
        const double a = values_[std::size_t(first)];
        const double b = values_[std::size_t(first + (isDown ? width_ : 1))];
        const double share = (level_ - a) / (b - a);
        const double along = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5;
        const std::int64_t row = first / width_;
        const glm::dvec2 corner(double(first - row * width_) + 0.5, double(row) + 0.5);
        return isDown ? corner + glm::dvec2(0.0, along) : corner + glm::dvec2(along, 0.0);
    }

    void addLine(Side side, std::vector<ContourLine>& lines) {
        ContourLine line{pointOn(side)};
        for (auto piece = next_.find(side); piece != next_.end(); piece = next_.find(side)) {
            side = piece->second;
            next_.erase(piece);
            if (const glm::dvec2 point = pointOn(side); point != line.back()) line.push_back(point);
        }
        if (line.size() > 1) lines.push_back(std::move(line));
    }

    const std::vector<float>& values_;
    std::int64_t width_;
    double level_;
    std::unordered_map<Side, Side> next_;  // where the piece ends that begins at a side
};

}  // namespace

std::vector<ContourLine> contourLines(const SampledSlice& slice, double level,
                                      const std::function<bool()>& cancelled) {
    const glm::ivec2 size = slice.sizePx;
    const bool isWhole =
        size.x > 1 && size.y > 1 && slice.values.size() == std::size_t(size.x) * std::size_t(size.y);
    if (!isWhole || !std::isfinite(level)) return {};
    Lines lines(slice, level);
    for (int y = 0; y + 1 < size.y; ++y) {
        if (cancelled && cancelled()) return {};
        for (int x = 0; x + 1 < size.x; ++x) lines.addSquare(x, y);
    }
    return lines.take();
}

}  // namespace macula::slices
