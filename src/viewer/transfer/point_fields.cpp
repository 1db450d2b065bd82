#include "viewer/transfer/point_fields.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QSignalBlocker>

#include "presets/vtk_curve.h"
#include "viewer/transfer/encoded_colour.h"

namespace macula::viewer {

namespace {

constexpr int kOpacityDecimals = 3;
constexpr double kOpacityStep = 0.01;
constexpr int kSwatchPx = 16;

}  // namespace

PointFields::PointFields(QWidget* parent)
    : QWidget(parent),
      value_(new QDoubleSpinBox(this)),
      opacity_(new QDoubleSpinBox(this)),
      colour_(new QPushButton(this)) {
    value_->setObjectName(QStringLiteral("transfer-value"));
    value_->setAccessibleName(tr("Value of the selected point"));
    value_->setRange(-presets::kLargestValue, presets::kLargestValue);
    value_->setKeyboardTracking(false);  // a half-typed number changes nothing
    opacity_->setObjectName(QStringLiteral("transfer-opacity"));
    opacity_->setAccessibleName(tr("Opacity of the selected point, 0 to 1"));
    opacity_->setRange(0.0, 1.0);
    opacity_->setDecimals(kOpacityDecimals);
    opacity_->setSingleStep(kOpacityStep);
    opacity_->setKeyboardTracking(false);
    colour_->setObjectName(QStringLiteral("transfer-colour"));
    colour_->setText(tr("Colour…"));
    colour_->setAccessibleName(tr("Colour of the selected point"));
    colour_->setToolTip(tr("Choose the colour of the selected colour point (sRGB)"));
    connect(value_, &QDoubleSpinBox::valueChanged, this, &PointFields::valueChanged);
    connect(opacity_, &QDoubleSpinBox::valueChanged, this, &PointFields::opacityChanged);
    connect(value_, &QDoubleSpinBox::editingFinished, this, &PointFields::ended);
    connect(opacity_, &QDoubleSpinBox::editingFinished, this, &PointFields::ended);
    connect(colour_, &QPushButton::clicked, this, &PointFields::askColour);

    auto* valueLabel = new QLabel(tr("Value"), this);
    valueLabel->setBuddy(value_);
    auto* opacityLabel = new QLabel(tr("Opacity"), this);
    opacityLabel->setBuddy(opacity_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(valueLabel);
    row->addWidget(value_, 1);
    row->addWidget(opacityLabel);
    row->addWidget(opacity_);
    row->addWidget(colour_);
    setUnit({}, 2);
    setUnitDistance(1.0);
    showPoint(std::nullopt);
}

void PointFields::setUnit(const QString& unit, int decimals) {
    const QSignalBlocker quiet(value_);  // fewer decimals would round the value
    value_->setDecimals(decimals);
    value_->setSuffix(unit.isEmpty() ? QString() : QStringLiteral(" ") + unit);
    value_->setToolTip(unit.isEmpty() ? tr("Value of the selected point, in the scanner's own numbers")
                                      : tr("Value of the selected point, in %1").arg(unit));
}

void PointFields::setUnitDistance(double mm) {
    opacity_->setToolTip(tr("Opacity of the selected point, 0 to 1, of a layer %1 mm thick")
                             .arg(QLocale().toString(mm, 'g', 4)));
}

void PointFields::setStep(double units) {
    value_->setSingleStep(units);
}

void PointFields::showPoint(const std::optional<Point>& point) {
    const QSignalBlocker quietValue(value_);
    const QSignalBlocker quietOpacity(opacity_);
    shown_ = point;
    value_->setEnabled(point.has_value());
    value_->setValue(point ? point->value : 0.0);
    opacity_->setEnabled(point && point->opacity);
    opacity_->setValue(point ? point->opacity.value_or(0.0) : 0.0);
    showColour(point ? point->colour : std::nullopt);
}

void PointFields::showColour(const std::optional<glm::dvec3>& colour) {
    colour_->setEnabled(colour.has_value());
    if (!colour) {
        colour_->setIcon({});
        return;
    }
    const double ratio = devicePixelRatioF();
    QPixmap swatch(QSize(kSwatchPx, kSwatchPx) * ratio);
    swatch.setDevicePixelRatio(ratio);
    swatch.fill(colourOf(*colour));
    colour_->setIcon(QIcon(swatch));
}

void PointFields::askColour() {
    if (!shown_ || !shown_->colour) return;
    if (dialog_) return dialog_->raise();
    const glm::dvec3 before = *shown_->colour;
    dialog_ = new QColorDialog(colourOf(before), this);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    dialog_->setWindowTitle(tr("Colour of the point"));
    connect(dialog_, &QColorDialog::currentColorChanged, this, [this](const QColor& colour) {
        if (colour.isValid()) Q_EMIT colourChanged(encodedFrom(colour));
    });
    // Restores the exact colour: the dialog has only 16 bits.
    connect(dialog_, &QDialog::rejected, this, [this, before] { Q_EMIT colourChanged(before); });
    connect(dialog_, &QDialog::finished, this, [this] {
        dialog_ = nullptr;  // it is deleted a little later
        Q_EMIT ended();
    });
    dialog_->open();
}

void PointFields::dropDialog() {
    if (!dialog_) return;
    dialog_->disconnect(this);
    dialog_->close();
    dialog_ = nullptr;
    Q_EMIT ended();
}

}  // namespace macula::viewer
