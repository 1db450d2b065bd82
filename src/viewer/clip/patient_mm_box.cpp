#include "viewer/clip/patient_mm_box.h"

#include <algorithm>
#include <cmath>

#include "scene/clip/kept_box.h"

namespace macula::viewer {

namespace {

QChar letterOf(int axis, bool high) {
    return QLatin1Char(scene::letterOf(scene::faceOf(axis, high)));
}

constexpr int kMostDecimals = 6;

}  // namespace

int decimalsForMm(double stepMm) {
    return std::clamp(1 - int(std::ceil(std::log10(stepMm))), 1, kMostDecimals);
}

QString patientText(int axis, double mm, int decimals, const QLocale& locale) {
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    const QString number = plain.toString(std::abs(mm), 'f', decimals);
    const double unit = std::pow(10.0, -decimals);
    if (!(std::abs(mm) >= 0.5 * unit)) return number;  // on neither side
    return QStringLiteral("%1 %2").arg(letterOf(axis, mm > 0.0)).arg(number);
}

std::optional<double> patientMm(int axis, const QString& text, const QLocale& locale) {
    QString number = text.trimmed();
    if (number.endsWith(QLatin1String("mm"), Qt::CaseInsensitive)) number.chop(2);
    number = number.trimmed();
    std::optional<double> side;
    for (const bool high : {false, true}) {
        const QString letter = letterOf(axis, high);
        if (number.startsWith(letter, Qt::CaseInsensitive)) {
            number.remove(0, 1);
        } else if (number.endsWith(letter, Qt::CaseInsensitive)) {
            number.chop(1);
        } else {
            continue;
        }
        side = high ? 1.0 : -1.0;
        number = number.trimmed();
        break;
    }
    bool isNumber = false;
    const double mm = locale.toDouble(number, &isNumber);
    if (!isNumber || !std::isfinite(mm)) return std::nullopt;
    if (!side) return mm;
    if (std::signbit(mm)) return std::nullopt;  // "R -45" may mean either side
    return *side * mm;
}

PatientMmBox::PatientMmBox(int axis, QWidget* parent) : QDoubleSpinBox(parent), axis_(axis) {
    setSuffix(tr(" mm"));
    setKeyboardTracking(false);
    setAccelerated(true);
}

QString PatientMmBox::textFromValue(double mm) const {
    return patientText(axis_, mm, decimals(), locale());
}

double PatientMmBox::valueFromText(const QString& text) const {
    return patientMm(axis_, text, locale()).value_or(value());
}

// Other text may become a coordinate while a person types; if it never does, entering it restores the old
// value.
QValidator::State PatientMmBox::validate(QString& text, int& /*position*/) const {
    return patientMm(axis_, text, locale()) ? QValidator::Acceptable : QValidator::Intermediate;
}

}  // namespace macula::viewer
