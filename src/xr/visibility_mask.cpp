#include "xr/visibility_mask.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::xr {

namespace {

// The grid that finds how far the sides can be moved in.
constexpr int kGrid = 256;
constexpr double kMostTangent = 1e3;

bool isPlace(const glm::dvec2& p) {
    return std::abs(p.x) < kMostTangent && std::abs(p.y) < kMostTangent;  // false for NaN
}

// Extends [low, high] to the x at which the edge from p to q crosses the height y.
void meet(const glm::dvec2& p, const glm::dvec2& q, double y, double& low, double& high) {
    if ((p.y > y) == (q.y > y)) return;
    const double x = p.x + (q.x - p.x) * (y - p.y) / (q.y - p.y);
    low = std::min(low, x);
    high = std::max(high, x);
}

}  // namespace

VisibilityMask::VisibilityMask(std::vector<glm::dvec2> corners, std::span<const std::uint32_t> indices) {
    if (indices.size() % 3 != 0 || !std::all_of(corners.begin(), corners.end(), isPlace)) return;
    if (std::any_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= corners.size(); }))
        return;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        triangles_.push_back({corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]});
}

std::vector<VisibilityMask::Run> VisibilityMask::rowsOf(const Eye& eye, const glm::ivec2& sizePx) const {
    const std::size_t width = std::size_t(std::max(sizePx.x, 0));
    std::vector<Run> rows(std::size_t(std::max(sizePx.y, 0)), Run{0, int(width)});
    const double pitchX = (eye.right - eye.left) / sizePx.x;
    const double pitchY = (eye.up - eye.down) / sizePx.y;
    if (triangles_.empty() || !(pitchX > 0.0) || !(pitchY > 0.0)) return rows;
    std::vector<char> hidden(width);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double y = eye.up - (double(row) + 0.5) * pitchY;
        std::fill(hidden.begin(), hidden.end(), char(0));
        for (const Triangle& t : triangles_) {
            double low = std::numeric_limits<double>::infinity();
            double high = -low;
            meet(t.a, t.b, y, low, high);
            meet(t.b, t.c, y, low, high);
            meet(t.c, t.a, y, low, high);
            if (!(low <= high)) continue;
            // Hides the pixels whose centres lie between.
            const auto pixel = [&](double x) {
                return std::clamp((x - eye.left) / pitchX - 0.5, -1.0, double(width));
            };
            const auto first = static_cast<std::size_t>(std::max(std::ceil(pixel(low)), 0.0));
            const double last = std::floor(pixel(high));
            for (std::size_t i = first; double(i) <= last && i < width; ++i) hidden[i] = 1;
        }
        const auto begin = std::find(hidden.begin(), hidden.end(), char(0));
        if (begin == hidden.end()) {
            rows[row] = {};
            continue;
        }
        const auto end = std::find(hidden.rbegin(), hidden.rend(), char(0));
        rows[row] = {int(begin - hidden.begin()), int(hidden.rend() - end)};
    }
    return rows;
}

Eye VisibilityMask::visiblePartOf(const Eye& eye) const {
    if (triangles_.empty()) return eye;
    const std::vector<Run> rows = rowsOf(eye, glm::ivec2(kGrid));
    glm::ivec2 first(kGrid);
    glm::ivec2 end(0);
    for (int row = 0; row < kGrid; ++row) {
        const Run& run = rows[std::size_t(row)];
        if (run.first == run.end) continue;
        first = glm::min(first, glm::ivec2(run.first, row));
        end = glm::max(end, glm::ivec2(run.end, row + 1));
    }
    if (first.x >= end.x) return eye;  // an empty field must be an error of the headset
    // Cells were tested at their centres, so the neighbouring cells may be partly visible.
    first = glm::max(first - 1, glm::ivec2(0));
    end = glm::min(end + 1, glm::ivec2(kGrid));
    const double across = (eye.right - eye.left) / kGrid;
    const double down = (eye.up - eye.down) / kGrid;
    Eye part = eye;
    if (first.x > 0) part.left = eye.left + first.x * across;
    if (end.x < kGrid) part.right = eye.left + end.x * across;
    if (first.y > 0) part.up = eye.up - first.y * down;
    if (end.y < kGrid) part.down = eye.up - end.y * down;
    return part;
}

std::vector<VisiblePart> bandsOf(std::span<const VisibilityMask::Run> rows, int rowsOfBand) {
    std::vector<VisiblePart> bands;
    for (std::size_t begin = 0; begin < rows.size(); begin += std::size_t(rowsOfBand)) {
        const auto band = rows.subspan(begin, std::min(std::size_t(rowsOfBand), rows.size() - begin));
        VisibilityMask::Run all{std::numeric_limits<int>::max(), 0};
        for (const VisibilityMask::Run& run : band) {
            if (run.first == run.end) continue;
            all = {std::min(all.first, run.first), std::max(all.end, run.end)};
        }
        if (all.first >= all.end) continue;
        const VisiblePart part{{all.first, int(begin)}, {all.end - all.first, int(band.size())}};
        if (!bands.empty()) {
            VisiblePart& last = bands.back();
            if (last.firstPx.x == part.firstPx.x && last.sizePx.x == part.sizePx.x &&
                last.firstPx.y + last.sizePx.y == part.firstPx.y) {
                last.sizePx.y += part.sizePx.y;
                continue;
            }
        }
        bands.push_back(part);
    }
    return bands;
}

}  // namespace macula::xr
