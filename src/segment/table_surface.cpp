#include "segment/table_surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "base/parallel.h"
#include "segment/surface_profile.h"

namespace macula::segment {

namespace {

constexpr double kHalfWindowMm = 30.0;  // along the couch: a sheet stays where it is for twice this
constexpr double kPersistence = 0.7;    // share of the window that a block must be thin in
constexpr double kShortestMm = 20.0;    // a shorter scan does not show what stays in place
constexpr double kPieceMm = 40.0;       // width of a piece of sheet that counts
constexpr double kSheetMm = 120.0;      // width of all pieces on one side of the body
constexpr double kThinBeyondMm = 4.5;   // distance from anything thick beyond which a block is thin

// Which blocks across the couch hold something thin through most of a window around slice c.
class Persistence {
  public:
    Persistence(const Grid& grid, Mask thin) : grid_(grid), thin_(std::move(thin)), count_(grid.sliceSize()) {
        half_ = std::max(1, int(std::lround(kHalfWindowMm / grid.spacingMm.z)));
    }

    // Must be called for c = 0, 1, 2 ... in this order.
    Mask at(int c) {
        const int last = std::min(grid_.size.z - 1, c + half_);
        for (; added_ <= last; ++added_) change(added_, 1);
        if (c - half_ - 1 >= 0) change(c - half_ - 1, -1);
        const int length = last - std::max(0, c - half_) + 1;
        Mask mask(count_.size());
        for (std::size_t n = 0; n < mask.size(); ++n) mask[n] = count_[n] >= kPersistence * length ? 1 : 0;
        return mask;
    }

  private:
    void change(int c, int by) {
        const std::uint8_t* slice = thin_.data() + std::size_t(c) * grid_.sliceSize();
        for (std::size_t n = 0; n < count_.size(); ++n) count_[n] += slice[n] != 0 ? by : 0;
    }

    const Grid& grid_;
    Mask thin_;
    std::vector<int> count_;
    int half_ = 1;
    int added_ = 0;
};

// Removes pieces that are narrow in both directions; returns the summed widths of the others along a and b.
std::array<double, 2> keepWidePieces(const Grid& grid, Mask& mask) {
    std::array<double, 2> widths{0.0, 0.0};
    Mask seen(mask.size());
    std::vector<std::size_t> piece;
    const int na = grid.size.x;
    for (std::size_t seed = 0; seed < mask.size(); ++seed) {
        if (mask[seed] == 0 || seen[seed] != 0) continue;
        piece.assign(1, seed);
        seen[seed] = 1;
        glm::ivec2 low(std::numeric_limits<int>::max());
        glm::ivec2 high(-1);
        for (std::size_t next = 0; next < piece.size(); ++next) {
            const glm::ivec2 ab(int(piece[next]) % na, int(piece[next]) / na);
            low = glm::min(low, ab);
            high = glm::max(high, ab);
            for (int b = std::max(0, ab.y - 1); b <= std::min(grid.size.y - 1, ab.y + 1); ++b) {
                for (int a = std::max(0, ab.x - 1); a <= std::min(na - 1, ab.x + 1); ++a) {
                    const std::size_t at = std::size_t(b) * std::size_t(na) + std::size_t(a);
                    if (mask[at] == 0 || seen[at] != 0) continue;
                    seen[at] = 1;
                    piece.push_back(at);
                }
            }
        }
        const glm::dvec2 width = glm::dvec2(high - low + 1) * glm::dvec2(grid.spacingMm);
        if (std::max(width.x, width.y) < kPieceMm) {
            for (const std::size_t at : piece) mask[at] = 0;
            continue;
        }
        // Counts each piece along its longer side only: a piece that is also deep, as a ring around a limb,
        // is no sheet.
        widths[width.x >= width.y ? 0 : 1] += std::max(width.x, width.y);
    }
    return widths;
}

// One slice, seen along u (across the sheet) and v (through it), as arrays by u.
class Slice {
  public:
    Slice(const Grid& grid, bool uIsA, int c) : grid_(grid), uIsA_(uIsA), c_(c) {}
    int width() const { return uIsA_ ? grid_.size.x : grid_.size.y; }
    int height() const { return uIsA_ ? grid_.size.y : grid_.size.x; }
    double uMm() const { return uIsA_ ? grid_.spacingMm.x : grid_.spacingMm.y; }
    double vMm() const { return uIsA_ ? grid_.spacingMm.y : grid_.spacingMm.x; }
    std::size_t inSlice(int u, int v) const {
        return uIsA_ ? std::size_t(v) * std::size_t(grid_.size.x) + std::size_t(u)
                     : std::size_t(u) * std::size_t(grid_.size.x) + std::size_t(v);
    }
    std::size_t inGrid(int u, int v) const { return std::size_t(c_) * grid_.sliceSize() + inSlice(u, v); }

  private:
    const Grid& grid_;
    bool uIsA_;
    int c_;
};

// The nearest and farthest v of the body in each column; nearest > farthest where there is none.
std::vector<SurfaceBody> bodyOf(const Slice& slice, const Mask& body) {
    std::vector<SurfaceBody> columns(std::size_t(slice.width()),
                                     {std::numeric_limits<int>::max(), std::numeric_limits<int>::min()});
    for (int u = 0; u < slice.width(); ++u) {
        SurfaceBody& column = columns[std::size_t(u)];
        for (int v = 0; v < slice.height(); ++v) {
            if (body[slice.inGrid(u, v)] == 0) continue;
            column.low = std::min(column.low, v);
            column.high = std::max(column.high, v);
        }
    }
    return columns;
}

// The middle of the body along v; `fallback` if there is no body.
double middleOf(const std::vector<SurfaceBody>& columns, double fallback) {
    double sum = 0.0;
    int count = 0;
    for (const SurfaceBody& column : columns) {
        if (column.low > column.high) continue;
        sum += 0.5 * (column.low + column.high);
        ++count;
    }
    return count > 0 ? sum / count : fallback;
}

}  // namespace

TableSurface findTableSurface(const Grid& grid, const Mask& solid, const Mask& body,
                              const std::vector<float>& toThickMm, const CancelToken& token) {
    TableSurface surface;
    if (grid.size.z * grid.spacingMm.z < kShortestMm) return surface;

    Mask thin(grid.count());
    for (std::size_t n = 0; n < thin.size(); ++n)
        thin[n] = solid[n] != 0 && toThickMm[n] > float(kThinBeyondMm) ? 1 : 0;
    Persistence persistence(grid, std::move(thin));
    std::vector<Mask> sheets;
    std::array<double, 2> widths{0.0, 0.0};
    for (int c = 0; c < grid.size.z; ++c) {
        sheets.push_back(persistence.at(c));
        const auto of = keepWidePieces(grid, sheets.back());
        widths[0] += of[0];
        widths[1] += of[1];
    }
    if (widths[0] + widths[1] <= 0.0) return surface;
    const bool uIsA = widths[0] >= widths[1];

    surface.beyond.resize(grid.count());
    std::vector<std::vector<SurfaceBody>> bodies;
    double middle = 0.0;
    for (int c = 0; c < grid.size.z; ++c) {
        const Slice slice(grid, uIsA, c);
        bodies.push_back(bodyOf(slice, body));
        middle += middleOf(bodies.back(), 0.5 * slice.height()) / grid.size.z;
    }
    std::atomic<int> slices{0};
    std::atomic<int> touching{0};
    parallelFor(
        std::size_t(grid.size.z),
        [&](std::size_t c) {
            const Slice slice(grid, uIsA, int(c));
            bool seen = false;
            bool touched = false;
            for (const int side : {1, -1}) {
                SurfaceProfile profile(slice.uMm(), slice.vMm(), side, bodies[c],
                                       middleOf(bodies[c], middle));
                for (int u = 0; u < slice.width(); ++u) {
                    for (int v = 0; v < slice.height(); ++v) {
                        if (sheets[c][slice.inSlice(u, v)] != 0) profile.add(u, v);
                    }
                }
                if (profile.widthMm() < kSheetMm) continue;
                profile.bridgeGaps();
                seen = true;
                touched = touched || profile.touchesBody();
                for (int u = 0; u < slice.width(); ++u) {
                    const std::optional<int> top = profile.top(u);
                    if (!top) continue;
                    for (int v = *top; v >= 0 && v < slice.height(); v += side)
                        surface.beyond[slice.inGrid(u, v)] = 1;
                }
            }
            slices += seen ? 1 : 0;
            touching += touched ? 1 : 0;
        },
        token);
    surface.slices = slices;
    surface.touchingSlices = touching;
    return surface;
}

}  // namespace macula::segment
