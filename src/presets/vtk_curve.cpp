#include "presets/vtk_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parsing.h"

namespace macula::presets {

namespace {

constexpr std::string_view kSpace = " \t\r\n";

}  // namespace

std::optional<std::vector<double>> numbersFrom(std::string_view text, std::size_t most) {
    std::vector<double> numbers;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::string_view word = text.substr(0, text.find_first_of(kSpace));
        const std::optional<double> number = finiteNumber(word);
        if (!number || numbers.size() == most) return std::nullopt;
        numbers.push_back(*number);
        text.remove_prefix(word.size());
    }
    return numbers;
}

namespace {

double clampedFraction(double height, bool& clamped) {
    const double inside = std::clamp(height, 0.0, 1.0);
    clamped = clamped || inside != height;
    return inside;
}

template <class Point>
bool sameHeight(Point a, const Point& b) {
    a.value = b.value;
    return a == b;
}

// The next larger double; from 0 the smallest normal one.
double nextAbove(double value) {
    if (value == 0.0) return std::numeric_limits<double>::min();
    return std::nextafter(value, std::numeric_limits<double>::infinity());
}

// Moves up each point (sorted by value) that has the value of an earlier one but differs from it.
template <class Point>
void separate(std::vector<Point>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point& before = points[i - 1];
        points[i].value = std::max(points[i].value, before.value);  // `before` may have moved beyond this one
        if (points[i].value == before.value && !sameHeight(points[i], before))
            points[i].value = nextAbove(before.value);
    }
}

template <class Point>
void sortPoints(std::vector<Point>& points, bool keepSteps) {
    std::stable_sort(points.begin(), points.end(),
                     [](const Point& a, const Point& b) { return a.value < b.value; });
    if (keepSteps) return separate(points);
    const auto kept = std::unique(points.rbegin(), points.rend(),
                                  [](const Point& a, const Point& b) { return a.value == b.value; });
    points.erase(points.begin(), kept.base());
}

// The numbers of a curve, without their leading count.
Result<std::vector<double>> readNumbers(std::string_view text, std::size_t perPoint, const Text& what,
                                        const std::string& where) {
    const auto fail = [&](Text why) {
        return Error{ErrorCode::inputNotUsable, Text("The {} of the preset {}.", what, std::move(why)), where,
                     Text("Save the preset again in the program that it comes from.")};
    };
    std::optional<std::vector<double>> numbers = numbersFrom(text, 1 + perPoint * kMostPoints);
    if (!numbers) return fail(Text("has something in it that is no usable number, or too many of them"));
    if (numbers->empty()) return fail(Text("is empty"));
    const auto count = static_cast<double>(numbers->size() - 1);
    if (numbers->front() != count)
        return fail(Text("should have {:g} numbers and has {:g}", numbers->front(), count));
    numbers->erase(numbers->begin());
    if (numbers->empty()) return fail(Text("has no points"));
    if (numbers->size() % perPoint != 0) return fail(Text("is not made of groups of {}", perPoint));
    double last = -kLargestValue;
    for (std::size_t i = 0; i < numbers->size(); i += perPoint) {
        const double value = (*numbers)[i];
        if (std::abs(value) > kLargestValue) return fail(Text("has a value that is too large"));
        if (value < last) return fail(Text("is not sorted: {:g} comes after {:g}", value, last));
        last = value;
    }
    return std::move(*numbers);
}

}  // namespace

Result<std::vector<OpacityPoint>> opacityFromText(std::string_view text, const Text& what,
                                                  const std::string& where, bool& clamped) {
    MACULA_TRY(const std::vector<double> numbers, readNumbers(text, 2, what, where));
    std::vector<OpacityPoint> points;
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        points.push_back({numbers[i], clampedFraction(numbers[i + 1], clamped)});
    separate(points);
    return points;
}

Result<std::vector<ColourPoint>> colourFromText(std::string_view text, const Text& what,
                                                const std::string& where, bool& clamped) {
    MACULA_TRY(const std::vector<double> numbers, readNumbers(text, 4, what, where));
    std::vector<ColourPoint> points;
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
        points.push_back({numbers[i],
                          {clampedFraction(numbers[i + 1], clamped), clampedFraction(numbers[i + 2], clamped),
                           clampedFraction(numbers[i + 3], clamped)}});
    }
    separate(points);
    return points;
}

void sortAsAdded(std::vector<OpacityPoint>& points, bool keepSteps) {
    sortPoints(points, keepSteps);
}

void sortAsAdded(std::vector<ColourPoint>& points, bool keepSteps) {
    sortPoints(points, keepSteps);
}

}  // namespace macula::presets
