#include "study/planar/image_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/csv.h"
#include "base/sha256.h"

namespace macula::study {

namespace {

using Kind = ImageMeasurement::Kind;
using Unit = ImageScale::Unit;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kSameScale = 1e-6;  // relative, of numbers that writers round

bool isAbove0(double value) {
    return std::isfinite(value) && value > 0.0;
}

bool isSame(double a, double b) {
    return std::abs(a - b) <= kSameScale * std::max(std::abs(a), std::abs(b));
}

bool isSameScale(const dicom::UltrasoundRegion& a, const dicom::UltrasoundRegion& b) {
    return a.unitX == b.unitX && a.unitY == b.unitY && isSame(std::abs(a.perColumn), std::abs(b.perColumn)) &&
           isSame(std::abs(a.perRow), std::abs(b.perRow));
}

bool overlap(const dicom::UltrasoundRegion& a, const dicom::UltrasoundRegion& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

double areaOf(const dicom::UltrasoundRegion& region) {
    return (double(region.right) - region.left) * (double(region.bottom) - region.top);
}

// Where regions overlap, one of high priority counts, then the smaller one. Null: none.
const dicom::UltrasoundRegion* regionAt(const std::vector<dicom::UltrasoundRegion>& regions,
                                        const glm::dvec2& point) {
    const dicom::UltrasoundRegion* best = nullptr;
    for (const dicom::UltrasoundRegion& region : regions) {
        if (!region.holds(point.x, point.y)) continue;
        const bool isBetter = best == nullptr || (best->isLowPriority && !region.isLowPriority) ||
                              (best->isLowPriority == region.isLowPriority && areaOf(region) < areaOf(*best));
        if (isBetter) best = &region;
    }
    return best;
}

const char* nameOf(Unit unit) {
    switch (unit) {
        case Unit::millimetres:
            return "mm";
        case Unit::seconds:
            return "s";
        case Unit::hertz:
            return "Hz";
        case Unit::centimetresPerSecond:
            return "cm/s";
        case Unit::percent:
            return "%";
        case Unit::decibels:
            return "dB";
        case Unit::degrees:
            return "°";
        case Unit::none:
        case Unit::other:
            break;
    }
    return "px";
}

bool isKnown(Unit unit) {
    return unit != Unit::none && unit != Unit::other;
}

// Lengths in one unit, also of pixels without a size that are higher than wide.
glm::dvec2 evenScale(const ImageScale& scale, const dicom::PlanarHeader& header) {
    return isKnown(scale.unitX) ? glm::dvec2(scale.perColumn, scale.perRow)
                                : glm::dvec2(1.0, header.pixelHeightOverWidth);
}

double lengthOf(const glm::dvec2& vector) {
    const double length = std::hypot(vector.x, vector.y);
    return std::isfinite(length) ? length : kNaN;
}

double angleDeg(const glm::dvec2& a, const glm::dvec2& b) {
    if (!(lengthOf(a) > 0.0) || !(lengthOf(b) > 0.0)) return kNaN;
    return std::abs(glm::degrees(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b))));
}

Text basisOf(const ImageScale& scale) {
    using Of = dicom::PixelSize::Of;
    using Calibration = dicom::PixelSize::Calibration;
    if (scale.of == ImageScale::Of::outside) return Text("outside the regions of ultrasound");
    if (scale.of == ImageScale::Of::different) return Text("across two regions of ultrasound");
    if (!scale.size) return {};
    switch (scale.size->of) {
        case Of::detector:
            return Text("at the detector");
        case Of::estimate:
            return Text("at the object by magnification {:.3g}", scale.size->magnification);
        case Of::film:
            return Text("the size of the film alone is known");
        case Of::object:
        case Of::regions:
            break;
    }
    if (scale.size->calibration == Calibration::geometry) return Text("calibrated by geometry");
    if (scale.size->calibration == Calibration::fiducial) return Text("calibrated by a fiducial");
    return {};
}

std::vector<Quantity> lengthsOf(const ImageScale& scale, const dicom::PlanarHeader& header,
                                const glm::dvec2& by) {
    if (scale.isEven()) return {{lengthOf(by * evenScale(scale, header)), nameOf(scale.unitX)}};
    const double across = std::abs(by.x) * (isKnown(scale.unitX) ? scale.perColumn : 1.0);
    const double down = std::abs(by.y) * (isKnown(scale.unitY) ? scale.perRow : 1.0);
    return {{across, nameOf(scale.unitX)}, {down, nameOf(scale.unitY)}};
}

// Welford's sums, as of ellipses on slices.
class Sums {
  public:
    void add(double value) {
        if (!std::isfinite(value)) return;
        ++values_.pixels;
        const double before = value - values_.mean;
        values_.mean += before / double(values_.pixels);
        squares_ += before * (value - values_.mean);
        values_.low = values_.pixels == 1 ? value : std::min(values_.low, value);
        values_.high = values_.pixels == 1 ? value : std::max(values_.high, value);
    }
    std::optional<PixelValues> result() const {
        if (values_.pixels == 0) return {};
        PixelValues values = values_;
        values.deviation = values.pixels > 1 ? std::sqrt(squares_ / double(values.pixels - 1)) : kNaN;
        return values;
    }

  private:
    PixelValues values_;
    double squares_ = 0.0;
};

std::optional<PixelValues> valuesIn(const glm::dvec2& centre, const glm::dvec2& radii,
                                    const dicom::PlanarFrame& pixels) {
    if (pixels.isColour() || !isAbove0(radii.x) || !isAbove0(radii.y)) return {};
    const auto clamped = [](double at, int count) { return int(std::clamp(at, 0.0, double(count))); };
    const auto valueAt = [&](int i, int j) {
        return double{pixels.values[std::size_t(j) * std::size_t(pixels.columns) + std::size_t(i)]};
    };
    Sums sums;
    std::size_t inside = 0;
    const int lastRow = clamped(centre.y + radii.y + 1.0, pixels.rows);
    const int lastColumn = clamped(centre.x + radii.x + 1.0, pixels.columns);
    for (int j = clamped(centre.y - radii.y - 1.0, pixels.rows); j < lastRow; ++j)
        for (int i = clamped(centre.x - radii.x - 1.0, pixels.columns); i < lastColumn; ++i) {
            const glm::dvec2 by = (glm::dvec2(i + 0.5, j + 0.5) - centre) / radii;
            if (!(glm::dot(by, by) <= 1.0)) continue;
            ++inside;
            sums.add(valueAt(i, j));
        }
    const bool isOverImage =
        centre.x >= 0.0 && centre.y >= 0.0 && centre.x < pixels.columns && centre.y < pixels.rows;
    if (inside == 0 && isOverImage) sums.add(valueAt(int(centre.x), int(centre.y)));
    return sums.result();
}

// Decimals so that the largest of the numbers has three significant digits.
int decimalsFor(double largest) {
    if (!isAbove0(std::abs(largest))) return 0;
    return int(std::clamp(2.0 - std::floor(std::log10(std::abs(largest))), 0.0, 9.0));
}

std::string digits(double value, int decimals) {
    if (!std::isfinite(value)) return "–";
    constexpr double kLongest = 1e7;
    return std::abs(value) >= kLongest ? fmt::format("{:.4g}", value)
                                       : fmt::format("{:.{}f}", value, decimals);
}

std::string textOf(const Quantity& quantity) {
    if (!std::isfinite(quantity.value)) return "–";
    const bool isAngle = quantity.unit == "°";
    const bool isLength = quantity.unit == "mm" || quantity.unit == "px" || isAngle;
    return digits(quantity.value, isLength ? 1 : decimalsFor(quantity.value)) + (isAngle ? "" : " ") +
           quantity.unit;
}

std::string textOf(const PixelValues& values) {
    const int decimals = decimalsFor(std::max(std::abs(values.low), std::abs(values.high)));
    std::string text = digits(values.mean, decimals);
    if (values.pixels > 1) text += " ± " + digits(values.deviation, decimals);
    // "min" and "max" are the same in all languages of the window.
    return text + ", min " + digits(values.low, decimals) + ", max " + digits(values.high, decimals);
}

std::string numberField(double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string();
}

}  // namespace

std::string imageKey(std::string_view sopInstanceUid) {
    return sha256Hex(sopInstanceUid);
}

std::string_view kindOf(const ImageMeasurement& measurement) {
    switch (measurement.kind) {
        case Kind::distance:
            return "distance";
        case Kind::angle:
            return "angle";
        case Kind::ellipse:
            return "ellipse";
        case Kind::cobb:
            return "cobb angle";
    }
    return {};
}

std::size_t pointsOf(Kind kind) {
    if (kind == Kind::angle) return 3;
    return kind == Kind::cobb ? 4 : 2;
}

ImageScale scaleOver(const dicom::PlanarHeader& header, std::span<const glm::dvec2> points) {
    ImageScale scale;
    if (header.regions.empty()) {
        scale.size = header.pixelSize;
        if (!scale.size) return scale;
        scale.of = ImageScale::Of::pixels;
        if (scale.size->of == dicom::PixelSize::Of::film) return scale;
        scale.unitX = scale.unitY = Unit::millimetres;
        scale.perColumn = scale.size->columnMm;
        scale.perRow = scale.size->rowMm;
        return scale;
    }
    const dicom::UltrasoundRegion* shared = nullptr;
    for (const glm::dvec2& point : points) {
        const dicom::UltrasoundRegion* own = regionAt(header.regions, point);
        if (own == nullptr) {
            scale.of = ImageScale::Of::outside;
            return scale;
        }
        // Two regions of one scale are two pictures side by side, unless one lies over the other.
        if (shared != nullptr && own != shared && (!isSameScale(*own, *shared) || !overlap(*own, *shared))) {
            scale.of = ImageScale::Of::different;
            return scale;
        }
        if (shared == nullptr) shared = own;
    }
    if (shared == nullptr) return scale;
    scale.of = ImageScale::Of::region;
    scale.perColumn = std::abs(shared->perColumn);
    scale.perRow = std::abs(shared->perRow);
    // A direction without a usable step is measured in pixels.
    scale.unitX = isAbove0(scale.perColumn) && isKnown(shared->unitX) ? shared->unitX : Unit::none;
    scale.unitY = isAbove0(scale.perRow) && isKnown(shared->unitY) ? shared->unitY : Unit::none;
    return scale;
}

MeasuredImage measured(const ImageMeasurement& measurement, const dicom::PlanarHeader& header,
                       const dicom::PlanarFrame* pixels) {
    const std::vector<glm::dvec2>& p = measurement.points;
    MeasuredImage result;
    if (p.size() != pointsOf(measurement.kind)) return result;
    std::vector<glm::dvec2> places = p;
    if (measurement.kind == Kind::ellipse) {  // the other corners of its box
        places.emplace_back(p[0].x, p[1].y);
        places.emplace_back(p[1].x, p[0].y);
    }
    const ImageScale scale = scaleOver(header, places);
    const glm::dvec2 even = evenScale(scale, header);
    if (measurement.kind == Kind::distance) {
        result.quantities = lengthsOf(scale, header, p[1] - p[0]);
        result.basis = basisOf(scale);
    } else if (measurement.kind == Kind::ellipse) {
        const glm::dvec2 radii = 0.5 * glm::abs(p[1] - p[0]);
        const glm::dvec2 sized = radii * (scale.isEven() ? even : glm::dvec2(1.0));
        const bool isMm = scale.isEven() && scale.unitX == Unit::millimetres;
        const double area = std::numbers::pi * sized.x * sized.y;
        // An area across two units, or in a unit that is no length, says nothing.
        const bool hasArea = isMm || (scale.isEven() && !isKnown(scale.unitX));
        result.quantities = {{hasArea ? area : kNaN, isMm ? "mm²" : "px²"}};
        if (hasArea) result.basis = basisOf(scale);
        if (pixels != nullptr) result.values = valuesIn(0.5 * (p[0] + p[1]), radii, *pixels);
    } else {
        const bool isCobb = measurement.kind == Kind::cobb;
        const glm::dvec2 a = (isCobb ? p[1] - p[0] : p[0] - p[1]) * even;
        const glm::dvec2 b = (isCobb ? p[3] - p[2] : p[2] - p[1]) * even;
        double angle = scale.isEven() ? angleDeg(a, b) : kNaN;
        constexpr double kHalfTurn = 180.0;
        if (isCobb) angle = std::min(angle, kHalfTurn - angle);
        result.quantities = {{angle, "°"}};
        if (!scale.isEven()) result.basis = Text("rows and columns have different units here");
    }
    return result;
}

Text textOf(const MeasuredImage& measured) {
    std::vector<Text> parts;
    if (measured.values) parts.push_back(Text("{}", textOf(*measured.values)));
    for (const Quantity& quantity : measured.quantities) parts.push_back(Text("{}", textOf(quantity)));
    parts.push_back(measured.basis);
    return Text::joined(std::move(parts), ", ");
}

std::string csvOf(std::span<const ListedImageMeasurement> measurements) {
    std::string csv =
        "kind,label,image,frame,points,value,unit,second_value,second_unit,basis,mean,deviation,min,max,"
        "pixels\r\n";
    for (const ListedImageMeasurement& each : measurements) {
        const MeasuredImage& measured = each.measured;
        std::string points;
        for (const glm::dvec2& p : each.measurement.points)
            points += fmt::format("{}{:.3f} {:.3f}", points.empty() ? "" : "; ", p.x, p.y);
        csv += fmt::format("{},{},{},{},{}", kindOf(each.measurement), csvWords(each.measurement.label),
                           each.imageNumber, each.measurement.frame + 1, points);
        for (std::size_t i = 0; i < 2; ++i) {
            const bool has = i < measured.quantities.size();
            csv += has ? fmt::format(",{},{}", numberField(measured.quantities[i].value),
                                     measured.quantities[i].unit)
                       : std::string(",,");
        }
        csv += "," + csvWords(measured.basis.english());
        if (const auto& v = measured.values)
            csv += fmt::format(",{},{},{},{},{}", numberField(v->mean), numberField(v->deviation),
                               numberField(v->low), numberField(v->high), v->pixels);
        else
            csv += ",,,,,";
        csv += "\r\n";
    }
    return csv;
}

}  // namespace macula::study
