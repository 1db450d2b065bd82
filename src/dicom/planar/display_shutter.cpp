#include "dicom/planar/display_shutter.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace macula::dicom {

namespace {

constexpr Tag kShape{0x0018, 0x1600};
constexpr Tag kLeft{0x0018, 0x1602};
constexpr Tag kRight{0x0018, 0x1604};
constexpr Tag kUpper{0x0018, 0x1606};
constexpr Tag kLower{0x0018, 0x1608};
constexpr Tag kCentre{0x0018, 0x1610};
constexpr Tag kRadius{0x0018, 0x1612};
constexpr Tag kVertices{0x0018, 0x1620};
constexpr Tag kPresentationValue{0x0018, 0x1622};
constexpr int kFarthest = 1 << 20;
constexpr std::size_t kMostVertices = 4096;

bool isNear(double value) {
    return std::isfinite(value) && std::abs(value) <= kFarthest;
}

std::optional<DisplayShutter::Rectangle> rectangleOf(const Dataset& header) {
    const auto left = header.integer(kLeft);
    const auto right = header.integer(kRight);
    const auto top = header.integer(kUpper);
    const auto bottom = header.integer(kLower);
    if (!left || !right || !top || !bottom || *left > *right || *top > *bottom) return {};
    return DisplayShutter::Rectangle{*left, *right, *top, *bottom};
}

std::optional<DisplayShutter::Circle> circleOf(const Dataset& header) {
    const auto centre = header.numbers(kCentre, 2);  // row, column
    const auto radius = header.integer(kRadius);
    if (!centre || !radius || *radius < 1 || *radius > kFarthest) return {};
    if (!isNear((*centre)[0]) || !isNear((*centre)[1])) return {};
    return DisplayShutter::Circle{{int((*centre)[1]), int((*centre)[0])}, *radius};
}

std::vector<glm::ivec2> polygonOf(const Dataset& header) {
    const std::vector<double> numbers = header.allNumbers(kVertices);  // row, column, and so on
    const bool isUsable = numbers.size() % 2 == 0 && numbers.size() >= 6 &&
                          numbers.size() / 2 <= kMostVertices && std::ranges::all_of(numbers, isNear);
    if (!isUsable) return {};
    std::vector<glm::ivec2> vertices;
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        vertices.emplace_back(int(numbers[i + 1]), int(numbers[i]));
    return vertices;
}

// Where the edges of the polygon cross the middle of a row, ascending: what lies between the first and the
// second, and so on, is inside (even-odd rule).
std::vector<double> crossingsOf(const std::vector<glm::ivec2>& polygon, double row) {
    std::vector<double> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 from(polygon[i]);
        const glm::dvec2 to(polygon[(i + 1) % polygon.size()]);
        if ((from.y <= row) == (to.y <= row)) continue;
        crossings.push_back(from.x + (row - from.y) / (to.y - from.y) * (to.x - from.x));
    }
    std::ranges::sort(crossings);
    return crossings;
}

bool isInside(const std::vector<double>& crossings, double column) {
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        if (column >= crossings[i] && column <= crossings[i + 1]) return true;
    return false;
}

// The pixels of one row.
class Row {
  public:
    Row(std::vector<bool>& hidden, int row, int columns)
        : hidden_(hidden), first_(std::size_t(row) * std::size_t(columns)), columns_(columns) {}

    // Hides all but the columns from `low` to `high`, which count from 1.
    void keep(double low, double high) {
        for (int i = 0; i < columns_; ++i)
            if (i + 1 < low || i + 1 > high) hide(i);
    }
    // What lies inside by either list.
    void keepInside(const std::vector<double>& above, const std::vector<double>& below) {
        for (int i = 0; i < columns_; ++i)
            if (!isInside(above, i + 1) && !isInside(below, i + 1)) hide(i);
    }

  private:
    void hide(int column) { hidden_[first_ + std::size_t(column)] = true; }

    std::vector<bool>& hidden_;
    std::size_t first_;
    int columns_;
};

}  // namespace

std::optional<DisplayShutter> readDisplayShutter(const Dataset& header) {
    DisplayShutter shutter;
    for (const std::string& shape : header.texts(kShape)) {
        if (shape == "RECTANGULAR") shutter.rectangle = rectangleOf(header);
        if (shape == "CIRCULAR") shutter.circle = circleOf(header);
        if (shape == "POLYGONAL") shutter.polygon = polygonOf(header);
    }
    if (!shutter.rectangle && !shutter.circle && shutter.polygon.empty()) return {};
    shutter.grey = static_cast<std::uint8_t>(header.word(kPresentationValue).value_or(0) >> 8);
    return shutter;
}

std::vector<bool> hiddenBy(const DisplayShutter& shutter, int columns, int rows, double heightOverWidth) {
    std::vector<bool> hidden(std::size_t(columns) * std::size_t(rows));
    for (int j = 0; j < rows; ++j) {
        Row row(hidden, j, columns);
        if (const auto& box = shutter.rectangle) {
            const bool isIn = j + 1 >= box->top && j + 1 <= box->bottom;
            row.keep(isIn ? box->left : 1.0, isIn ? box->right : 0.0);
        }
        if (const auto& circle = shutter.circle) {
            const double down = (j + 1 - circle->centre.y) * heightOverWidth;
            const double square = double(circle->radius) * circle->radius - down * down;
            const double half = square >= 0.0 ? std::sqrt(square) : 0.0;
            row.keep(square >= 0.0 ? circle->centre.x - half : 1.0,
                     square >= 0.0 ? circle->centre.x + half : 0.0);
        }
        // A little higher and a little lower: an edge along a row belongs to the polygon.
        constexpr double kLittle = 1e-6;
        if (!shutter.polygon.empty())
            row.keepInside(crossingsOf(shutter.polygon, j + 1 - kLittle),
                           crossingsOf(shutter.polygon, j + 1 + kLittle));
    }
    return hidden;
}

}  // namespace macula::dicom
