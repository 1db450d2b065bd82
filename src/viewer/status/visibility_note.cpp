#include "viewer/status/visibility_note.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "pipeline/trace/look.h"
#include "scene/drawing/projection_windows.h"
#include "viewer/language/window_language.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

namespace {

constexpr int kMostNamed = 5;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Visibility)
};

// The curve is monotonic between points, so its largest value in a range is at a point or at an end of the
// range.
bool showsAnyOf(const TransferFunction& preset, const ValueRange& values) {
    if (preset.fitToVolume) return true;      // its curve is fitted to the volume's values
    if (preset.opacity.empty()) return true;  // no curve: reported as another error
    if (usesSteepCurves(preset)) {
        TransferFunction steep = withCurvesSwapped(preset);
        steep.steep = {};
        if (showsAnyOf(steep, values)) return true;
    }
    if (opacityAt(preset, values.low) > 0.0 || opacityAt(preset, values.high) > 0.0) return true;
    return std::any_of(preset.opacity.begin(), preset.opacity.end(), [&](const OpacityPoint& point) {
        return point.value >= values.low && point.value <= values.high && point.opacity > 0.0;
    });
}

bool isFor(const TransferFunction& preset, const Volume& volume) {
    const auto& made = preset.modalities;
    return suits(preset, volume.unit()) &&
           (made.empty() || std::find(made.begin(), made.end(), volume.modality()) != made.end());
}

QString valuesText(const ValueRange& values, const Volume& volume) {
    return Words::tr("its values are %1 to %2 %3")
        .arg(values.low, 0, 'g', 6)
        .arg(values.high, 0, 'g', 6)
        .arg(QString::fromStdString(volume.unitName()))
        .trimmed();
}

QString windowNote(const DisplayWindow& window, const ValueRange& values, const Volume& volume) {
    const bool isBelow = values.high <= window.center - 0.5 * window.width;
    const bool isAbove = values.low >= window.center + 0.5 * window.width;
    if (!isBelow && !isAbove) return {};
    return Words::tr("All of this volume is %1 in the window %2: %3.")
        .arg(isBelow ? Words::tr("black") : Words::tr("white"),
             withLocalNumbers(QString::fromStdString(scene::windowText(window, volume.unitName()))),
             valuesText(values, volume));
}

}  // namespace

QString visibilityNote(const scene::Drawing& drawing, const Volume& volume,
                       const scene::Catalogue& catalogue) {
    const std::optional<ValueRange>& values = volume.valueRange();
    if (!values) return Words::tr("This volume has no values: all of it is padding.");
    if (trace::isProjection(drawing.settings.look))
        return drawing.settings.window ? windowNote(*drawing.settings.window, *values, volume) : QString();
    if (!drawing.transferFunction || showsAnyOf(*drawing.transferFunction, *values)) return {};
    QString note = Words::tr("Nothing of this volume can be seen with the preset %1: %2.")
                       .arg(titleOr(drawing.transferFunction->title, drawing.transferFunction->name),
                            valuesText(*values, volume));
    QStringList others;
    for (const auto& preset : catalogue.presets) {
        if (isFor(*preset, volume) && showsAnyOf(*preset, *values))
            others << titleOr(preset->title, preset->name);
    }
    const QString more = others.size() > kMostNamed ? QStringLiteral("…") : QString();
    if (!others.isEmpty())
        note += Words::tr(" Presets that show something of it: %1.")
                    .arg(others.mid(0, kMostNamed).join(QStringLiteral(", ")) + more);
    return note;
}

}  // namespace macula::viewer
