#include "viewer/overlay/slice_texts.h"

#include <QCoreApplication>
#include <cmath>
#include <string>

#include "slices/interpolated.h"
#include "study/open/image_numbers.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

using slices::Orientation;

QString letters(const glm::dvec3& direction) {
    return QString::fromStdString(orientationLetters(direction));
}

constexpr double kLeastTurnDeg = 0.05;  // less is written as 0.0

// Avoids an exponent for numbers that are readable without it.
QString numberText(double value) {
    return QString::number(value, 'g', std::abs(value) < 1e9 && value == std::round(value) ? 10 : 6);
}

}  // namespace

QString nameOf(Orientation orientation) {
    switch (orientation) {
        case Orientation::axial:
            return QCoreApplication::translate("Slices", "Axial");
        case Orientation::coronal:
            return QCoreApplication::translate("Slices", "Coronal");
        case Orientation::sagittal:
            break;
    }
    return QCoreApplication::translate("Slices", "Sagittal");
}

QColor colourOf(Orientation orientation) {
    switch (orientation) {
        case Orientation::axial:
            return {255, 96, 84};
        case Orientation::coronal:
            return {110, 214, 110};
        case Orientation::sagittal:
            break;
    }
    return {246, 220, 74};
}

Orientation verticalOf(Orientation orientation) {
    return orientation == Orientation::sagittal ? Orientation::coronal : Orientation::sagittal;
}

Orientation horizontalOf(Orientation orientation) {
    return orientation == Orientation::axial ? Orientation::coronal : Orientation::axial;
}

scene::EdgeLetters edgeLetters(const slices::SlicePlane& plane) {
    return {.left = orientationLetters(-plane.right),
            .right = orientationLetters(plane.right),
            .top = orientationLetters(-plane.down),
            .bottom = orientationLetters(plane.down)};
}

QString degreesText(double deg) {
    return withLocalNumbers(QString::number(deg, 'f', 1)) + QStringLiteral("°");
}

QString planeText(Orientation orientation, const SliceSteps& steps, int slice) {
    const slices::SlicePlane plane = steps.plane(slice, glm::dvec3(0.0));
    const double position = glm::dot(plane.centreMm, plane.normal());
    QString text = nameOf(orientation);
    if (steps.turnedDeg() >= kLeastTurnDeg) {
        text = QCoreApplication::translate("Slices", "%1, turned by %2")
                   .arg(text, degreesText(steps.turnedDeg()));
    } else if (!steps.areStraight()) {
        text = QCoreApplication::translate("Slices", "%1, oblique").arg(text);
    }
    return QCoreApplication::translate("Slices", "%1 %2 %3 mm")
        .arg(text, letters(position < 0.0 ? -plane.normal() : plane.normal()),
             withLocalNumbers(QString::number(std::abs(position), 'f', 1)));
}

QString withNumbers(const QString& text, int slice, int count, std::optional<int> imageNumber) {
    const QString numbered =
        QCoreApplication::translate("Slices", "%1, slice %2 of %3").arg(text).arg(slice + 1).arg(count);
    if (!imageNumber) return numbered;
    return QCoreApplication::translate("Slices", "%1, image %2").arg(numbered).arg(*imageNumber);
}

QString positionText(Orientation orientation, const SliceSteps& steps, int slice,
                     std::optional<int> imageNumber) {
    const QString text = planeText(orientation, steps, slice);
    return steps.areAcquired() ? withNumbers(text, slice, steps.count(), imageNumber) : text;
}

std::optional<int> imageNumber(const study::OpenedStudy& study, const SliceSteps& steps, int slice) {
    return steps.areAcquired() ? imageNumber(study, slice) : std::nullopt;
}

std::optional<int> imageNumber(const study::OpenedStudy& study, int slice) {
    const std::vector<int>& numbers = study.imageNumbers;
    if (slice < 0 || std::size_t(slice) >= numbers.size() || study::countAsSlices(numbers) ||
        numbers[std::size_t(slice)] < 1)
        return {};
    return numbers[std::size_t(slice)];
}

QString slabText(const slices::Slab& slab) {
    if (!(slab.thicknessMm > 0.0)) return {};
    const QString thickness = withLocalNumbers(QString::number(slab.thicknessMm));
    switch (slab.projection) {
        case slices::Projection::maximum:
            return QCoreApplication::translate("Slices", "MIP %1 mm").arg(thickness);
        case slices::Projection::minimum:
            return QCoreApplication::translate("Slices", "MinIP %1 mm").arg(thickness);
        case slices::Projection::mean:
            break;
    }
    return QCoreApplication::translate("Slices", "Mean %1 mm").arg(thickness);
}

QString pointText(const glm::dvec3& mm) {
    const auto along = [](double value, const char* positive, const char* negative) {
        return QString::fromLatin1(value < 0.0 ? negative : positive) + QLatin1Char(' ') +
               withLocalNumbers(QString::number(std::abs(value), 'f', 1));
    };
    return QCoreApplication::translate("Slices", "%1 %2 %3 mm")
        .arg(along(mm.x, "L", "R"), along(mm.y, "P", "A"), along(mm.z, "S", "I"));
}

QString probeText(const Volume& volume, const glm::dvec3& mm) {
    const std::optional<slices::Probe> probe = slices::probe(volume, mm);
    if (!probe) return QCoreApplication::translate("Slices", "Outside, %1").arg(pointText(mm));
    QString value = QCoreApplication::translate("Slices", "Padding");
    if (!probe->isPadding) {
        value = withLocalNumbers(numberText(probe->value));
        if (!volume.unitName().empty())
            value += QLatin1Char(' ') + harmless(QString::fromStdString(volume.unitName()));
    }
    if (probe->isInterpolated) value = QCoreApplication::translate("Slices", "%1, interpolated,").arg(value);
    return QCoreApplication::translate("Slices", "%1 at (%2, %3, %4), %5")
        .arg(value, QString::number(probe->voxel.x), QString::number(probe->voxel.y),
             QString::number(probe->voxel.z), pointText(mm));
}

QString notCalibrated(const QString& text) {
    return QCoreApplication::translate("Slices", "%1, not calibrated").arg(text);
}

QString sizeText(const QString& size, bool isCalibrated) {
    return isCalibrated ? size : notCalibrated(QStringLiteral("≈ ") + size);
}

bool isInterpolated(const Volume& volume, const SliceSteps& steps, int slice) {
    return steps.areAcquired() && slices::isInterpolated(volume, slice);
}

}  // namespace macula::viewer
