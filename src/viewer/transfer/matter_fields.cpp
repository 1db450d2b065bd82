#include "viewer/transfer/matter_fields.h"

#include <QFormLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <string>

#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr int kDecimals = 3;
constexpr double kStep = 0.05;

// Whether the parameter has the unit of the values, per mm.
bool isGradient(const scene::MatterParameter& parameter) {
    return parameter.unit == "per mm";
}

// "Surface gradient": a label stands by itself, and begins a sentence.
QString labelOf(const scene::MatterParameter& parameter) {
    QString label = inWindowsLanguage(Text::of(parameter.label, {}));
    label[0] = label[0].toUpper();
    return label;
}

QString doesOf(const scene::MatterParameter& parameter) {
    return inWindowsLanguage(Text::of(parameter.does, {}));
}

}  // namespace

MatterFields::MatterFields(QWidget* parent) : QWidget(parent) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    for (const scene::MatterParameter& parameter : scene::matterParameters()) addRow(parameter);
    for (const Row& row : rows_) form->addRow(labelOf(*row.parameter), row.box);
    setUnit({}, 2, {});
    showMatter(TransferFunction{});
}

void MatterFields::addRow(const scene::MatterParameter& parameter) {
    auto* box = new QDoubleSpinBox(this);
    box->setObjectName(QStringLiteral("matter-") +
                       QString::fromUtf8(parameter.id.data(), int(parameter.id.size())));
    box->setAccessibleName(labelOf(parameter));
    box->setToolTip(doesOf(parameter));
    box->setKeyboardTracking(false);  // a half-typed number changes nothing
    if (isGradient(parameter)) {
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);  // some are about 0.01, some 1000
    } else {
        box->setDecimals(kDecimals);
        box->setSingleStep(kStep);
        box->setRange(parameter.low, parameter.high);
    }
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, &parameter](double value) {
        Q_EMIT changed(parameter, std::clamp(value / scaleOf(parameter), parameter.low, parameter.high));
    });
    connect(box, &QDoubleSpinBox::editingFinished, this, &MatterFields::ended);
    rows_.push_back({&parameter, box});
}

double MatterFields::scaleOf(const scene::MatterParameter& parameter) const {
    return isGradient(parameter) ? map_.scale : 1.0;
}

void MatterFields::setUnit(const QString& unit, int decimals, const scene::ValueMap& map) {
    map_ = map;
    for (const Row& row : rows_) {
        if (!isGradient(*row.parameter)) continue;
        const QSignalBlocker quiet(row.box);  // fewer decimals would round the value
        row.box->setDecimals(decimals);
        // The smallest number that the box can show; 0 is not a valid gradient.
        row.box->setRange(std::max(std::pow(10.0, -decimals), row.parameter->low * map.scale),
                          row.parameter->high * map.scale);
        row.box->setSuffix(unit.isEmpty() ? tr(" per mm") : tr(" %1/mm").arg(unit));
        row.box->setToolTip(
            QStringLiteral("%1 (%2)").arg(doesOf(*row.parameter), row.box->suffix().trimmed()));
    }
}

void MatterFields::showMatter(const TransferFunction& function) {
    for (const Row& row : rows_) {
        const QSignalBlocker quiet(row.box);
        row.box->setValue(row.parameter->get(function) * scaleOf(*row.parameter));
        if (row.parameter->id == "steepGradientPerMm") row.box->setEnabled(usesSteepCurves(function));
    }
}

}  // namespace macula::viewer
