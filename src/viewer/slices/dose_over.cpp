#include "viewer/slices/dose_over.h"

#include <QCoreApplication>
#include <QPen>
#include <cmath>
#include <utility>

#include "slices/contour_lines.h"
#include "study/dose/dose_field.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr double kLinePx = 1.6;
constexpr double kEdgePx = 3.2;
constexpr double kPercent = 100.0;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DoseOver)
};

QColor inkOf(const std::array<std::uint8_t, 3>& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

QString withUnit(double value, int digits, const QString& unit) {
    const QString number = withLocalNumbers(QString::number(value, 'g', digits));
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

QString percentText(double percent) {
    return Words::tr("%1 %").arg(withLocalNumbers(QString::number(percent, 'g', 4)));
}

}  // namespace

std::vector<IsodosePath> isodosePaths(const slices::SampledSlice& dose,
                                      const std::vector<scene::DoseLine>& lines,
                                      const std::function<bool()>& cancelled) {
    std::vector<IsodosePath> paths;
    for (const scene::DoseLine& line : lines) {
        IsodosePath each{.path = {}, .ink = inkOf(line.rgb)};
        for (const slices::ContourLine& contour : slices::contourLines(dose, line.value, cancelled)) {
            each.path.moveTo(contour.front().x, contour.front().y);
            for (std::size_t i = 1; i < contour.size(); ++i) each.path.lineTo(contour[i].x, contour[i].y);
        }
        if (!each.path.isEmpty()) paths.push_back(std::move(each));
    }
    return paths;
}

void paintIsodoses(QPainter& painter, const std::vector<IsodosePath>& paths, double pixelRatio) {
    if (paths.empty() || !(pixelRatio > 0.0)) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(1.0 / pixelRatio, 1.0 / pixelRatio);
    painter.setBrush(Qt::NoBrush);
    const auto stroke = [&](const QPainterPath& path, const QColor& ink, double widthPx) {
        painter.setPen(QPen(ink, widthPx * pixelRatio, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(path);
    };
    for (const IsodosePath& each : paths) stroke(each.path, QColor(0, 0, 0, 130), kEdgePx);
    // The highest last: where lines are close, its place matters most.
    for (auto each = paths.rbegin(); each != paths.rend(); ++each) stroke(each->path, each->ink, kLinePx);
    painter.restore();
}

QString referenceText(const study::DoseReference& reference, const QString& unit) {
    const QString value = withUnit(reference.value, 4, unit);
    switch (reference.of) {
        case study::DoseReference::Of::prescription:
            return Words::tr("%1 prescribed").arg(value);
        case study::DoseReference::Of::maximum:
            return Words::tr("%1, the highest dose").arg(value);
        case study::DoseReference::Of::choice:
            break;
    }
    return Words::tr("%1, as chosen").arg(value);
}

QString levelText(const scene::DoseLine& line, bool isInPercent, const QString& unit) {
    const QString dose = withUnit(line.value, 4, unit);
    if (!line.percent) return dose;
    const QString percent = percentText(*line.percent);
    return (isInPercent ? percent : dose) + QStringLiteral(" · ") + (isInPercent ? dose : percent);
}

std::vector<LegendLine> legendOf(const DoseOver& over, const QString& unit) {
    std::vector<LegendLine> legend;
    if (over.lines.empty()) return legend;
    if (over.reference)
        legend.push_back({Words::tr("100 % = %1").arg(referenceText(*over.reference, unit)), {}});
    for (const scene::DoseLine& line : over.lines)
        legend.push_back({levelText(line, true, unit), inkOf(line.rgb)});
    return legend;
}

QString doseText(const DoseOver& over, const std::shared_ptr<const Volume>& dose, const glm::dvec3& mm) {
    const std::optional<double> value = study::DoseField(dose).at(mm);
    if (!value) return Words::tr("Dose: none was computed here");
    const QString unit = harmless(QString::fromStdString(dose->unitName()));
    QString text = Words::tr("Dose: %1").arg(withUnit(*value, 4, unit));
    if (over.reference) {
        const double percent = kPercent * *value / over.reference->value;
        text = Words::tr("%1, %2 % of %3")
                   .arg(text, withLocalNumbers(QString::number(percent, 'f', 1)),
                        referenceText(*over.reference, unit));
    }
    return text;
}

}  // namespace macula::viewer
