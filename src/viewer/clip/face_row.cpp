#include "viewer/clip/face_row.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "viewer/clip/wheel_guard.h"

namespace macula::viewer {

namespace {

constexpr double kMostSteps = 10000.0;
constexpr int kStepsOfAPage = 10;
constexpr int kArrowsPx = 30;

}  // namespace

QString sideText(scene::Face face) {
    constexpr std::array kSides{QT_TRANSLATE_NOOP("Clip", "right"),    QT_TRANSLATE_NOOP("Clip", "left"),
                                QT_TRANSLATE_NOOP("Clip", "anterior"), QT_TRANSLATE_NOOP("Clip", "posterior"),
                                QT_TRANSLATE_NOOP("Clip", "inferior"), QT_TRANSLATE_NOOP("Clip", "superior")};
    return QCoreApplication::translate("Clip", kSides.at(std::size_t(face)));
}

FaceRow::FaceRow(scene::Face face, QWidget* parent)
    : QWidget(parent),
      face_(face),
      letter_(new QLabel(QString(QLatin1Char(scene::letterOf(face))), this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      number_(new PatientMmBox(scene::axisOf(face), this)),
      open_(new QToolButton(this)) {
    const std::string_view side = nameOf(face);
    const QString name = QString::fromLatin1(side.data(), qsizetype(side.size()));
    slider_->setObjectName(QStringLiteral("clip-slider-") + name);
    number_->setObjectName(QStringLiteral("clip-mm-") + name);
    open_->setObjectName(QStringLiteral("clip-open-") + name);
    slider_->setAccessibleName(tr("Clip face, %1, slider").arg(sideText(face)));
    number_->setAccessibleName(tr("Clip face, %1, in mm").arg(sideText(face)));
    open_->setAccessibleName(tr("Open the clip face, %1").arg(sideText(face)));
    open_->setText(QStringLiteral("↺"));
    open_->setFocusPolicy(Qt::StrongFocus);
    open_->setAutoRaise(true);
    letter_->setBuddy(number_);
    letter_->setFixedWidth(letter_->fontMetrics().horizontalAdvance(QLatin1Char('W')));

    // The same width for all six, whatever their numbers, because they are in one column.
    number_->setMinimumWidth(number_->fontMetrics().horizontalAdvance(QStringLiteral("W 1000.0 mm")) +
                             kArrowsPx);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(letter_);
    row->addWidget(slider_, 1);
    row->addWidget(number_);
    row->addWidget(open_);

    connect(slider_, &QSlider::sliderPressed, this, &FaceRow::moveBegan);
    connect(slider_, &QSlider::valueChanged, this, [this] { Q_EMIT moved(mmOfSlider()); });
    connect(slider_, &QSlider::sliderReleased, this, &FaceRow::moveEnded);
    connect(number_, &QDoubleSpinBox::valueChanged, this, &FaceRow::moved);
    connect(number_, &QDoubleSpinBox::editingFinished, this, &FaceRow::moveEnded);
    connect(open_, &QToolButton::clicked, this, &FaceRow::openAsked);
    auto* guard = new WheelGuard(this);
    for (QWidget* part : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_)}) {
        guard->watch(*part);
        part->installEventFilter(this);
    }
    setUsable(true, {});
}

void FaceRow::setRangeMm(double lowMm, double highMm, double stepMm) {
    lowMm_ = lowMm;
    highMm_ = highMm;
    const double steps = std::round((highMm - lowMm) / stepMm);
    const int decimals = decimalsForMm(stepMm);
    const double unit = std::pow(10.0, -decimals);
    const QSignalBlocker ofSlider(slider_);
    const QSignalBlocker ofNumber(number_);
    slider_->setRange(0, int(std::clamp(steps, 1.0, kMostSteps)));
    slider_->setPageStep(std::max(1, slider_->maximum() / kStepsOfAPage));
    number_->setDecimals(decimals);
    // Rounded outwards, so that a face typed at the limit leaves the whole volume visible.
    number_->setRange(std::floor(lowMm / unit) * unit, std::ceil(highMm / unit) * unit);
    number_->setSingleStep(std::max(unit, stepMm));
}

void FaceRow::showMm(double mm) {
    const QSignalBlocker ofSlider(slider_);
    const QSignalBlocker ofNumber(number_);
    const double fraction = std::clamp((mm - lowMm_) / (highMm_ - lowMm_), 0.0, 1.0);
    slider_->setValue(int(std::lround(fraction * slider_->maximum())));
    number_->setValue(mm);
}

// The ends are exact, so that a face pulled to the end of the slider is open.
double FaceRow::mmOfSlider() const {
    if (slider_->value() == slider_->maximum()) return highMm_;
    return lowMm_ + (highMm_ - lowMm_) * slider_->value() / slider_->maximum();
}

void FaceRow::setUsable(bool usable, const QString& whyNot) {
    for (QWidget* part :
         {static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_), static_cast<QWidget*>(open_)})
        part->setEnabled(usable);
    const QString face = sideText(face_);
    const QString what = tr("Where the %1 face of what is shown is, in mm of the patient (LPS)").arg(face);
    slider_->setToolTip(usable ? what : whyNot);
    number_->setToolTip(usable ? what : whyNot);
    letter_->setToolTip(usable ? what : whyNot);
    open_->setToolTip(usable ? tr("Show all of the volume on the %1 side again").arg(face) : whyNot);
}

// The changes of one key press or one click are one undo step.
bool FaceRow::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyRelease:
            if (!static_cast<QKeyEvent*>(event)->isAutoRepeat()) Q_EMIT moveEnded();
            break;
        case QEvent::MouseButtonRelease:
        case QEvent::FocusOut:
            Q_EMIT moveEnded();
            break;
        default:
            break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace macula::viewer
