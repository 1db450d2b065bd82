#include "viewer/transfer/matter_fields.h"

#include <QFormLayout>
#include <QHBoxLayout>
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

SteepChoice::SteepChoice(QWidget* parent)
    : QWidget(parent), which_(new QComboBox(this)), steep_(new QPushButton(this)) {
    which_->setObjectName(QStringLiteral("transfer-side"));
    which_->addItems({tr("Flat"), tr("Steep")});
    which_->setAccessibleName(tr("Which curves are edited"));
    which_->setToolTip(tr("Curves of matter whose values change little around a place, or steeply"));
    steep_->setObjectName(QStringLiteral("transfer-steep"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(which_);
    row->addWidget(steep_);
    connect(which_, &QComboBox::currentIndexChanged, this, &SteepChoice::chosen);
    connect(steep_, &QPushButton::clicked, this, [this] { Q_EMIT steepWanted(!hasSteep_); });
    showCurves(false);
}

void SteepChoice::showCurves(bool hasSteep) {
    hasSteep_ = hasSteep;
    which_->setEnabled(hasSteep);
    if (!hasSteep) {
        const QSignalBlocker quiet(which_);
        which_->setCurrentIndex(0);
    }
    steep_->setText(hasSteep ? tr("Remove steep") : tr("Add steep"));
    steep_->setAccessibleName(hasSteep ? tr("Remove the curves of steep matter")
                                       : tr("Add curves for steep matter"));
    steep_->setToolTip(hasSteep ? tr("All matter has the curves of flat matter again; can be undone")
                                : tr("Where values change steeply, matter gets curves of its own"));
}

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
