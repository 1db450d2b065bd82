#include "viewer/quality/quality_control.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWidgetAction>
#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::viewer {

namespace {

constexpr int kPanelWidthPx = 340;
constexpr double kUsualFrameMs = 60.0;  // automatic quality is near the stop with this frame time
constexpr double kAsFast = 1.0;         // slowness before the machine is measured

QString millisecondsText(double ms) {
    if (ms >= 1000.0) return QualityControl::tr("%L1 s").arg(ms / 1000.0, 0, 'f', 1);
    return QualityControl::tr("%L1 ms").arg(ms < 10.0 ? ms : std::round(ms), 0, 'f', ms < 10.0 ? 1 : 0);
}

}  // namespace

QualityControl::QualityControl(live::QualityFront front, QWidget* parent)
    : QToolButton(parent), front_(std::move(front)), view_({.sizePx = front_.sizePx}) {
    setObjectName(QStringLiteral("quality"));
    setAutoRaise(true);
    setPopupMode(QToolButton::InstantPopup);
    setAccessibleName(tr("Quality of frames in motion"));
    makePanel();
    showStop();
}

void QualityControl::makePanel() {
    auto* panel = new QWidget;
    panel->setMinimumWidth(kPanelWidthPx);
    slider_ = new QSlider(Qt::Horizontal, panel);
    slider_->setObjectName(QStringLiteral("quality-slider"));
    slider_->setRange(0, int(front_.stops.size()) - 1);
    slider_->setPageStep(1);
    slider_->setTickPosition(QSlider::TicksBelow);
    slider_->setTickInterval(1);
    slider_->setAccessibleName(tr("Quality of frames in motion, from fast to accurate"));
    slider_->setToolTip(
        tr("How much of a frame is traced while a hand moves. At rest the picture always becomes final."));
    automatic_ = new QCheckBox(tr("&Automatic"), panel);
    automatic_->setObjectName(QStringLiteral("quality-automatic"));
    automatic_->setToolTip(tr("As much as there is time for, without a choice"));
    words_ = new QLabel(panel);
    words_->setObjectName(QStringLiteral("quality-words"));
    words_->setWordWrap(true);
    words_->setTextFormat(Qt::PlainText);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { setStop(std::size_t(value)); });
    connect(automatic_, &QCheckBox::toggled, this,
            [this](bool on) { setStop(on ? std::nullopt : std::optional(nearestStop())); });
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Fast"), panel));
    row->addWidget(slider_, 1);
    row->addWidget(new QLabel(tr("Accurate"), panel));
    auto* column = new QVBoxLayout(panel);
    column->addLayout(row);
    column->addWidget(automatic_);
    column->addWidget(words_);
    auto* menu = new QMenu(this);
    auto* action = new QWidgetAction(menu);
    action->setDefaultWidget(panel);
    menu->addAction(action);
    setMenu(menu);
}

void QualityControl::setSlowness(std::optional<double> slowness) {
    if (slowness && !(*slowness > 0.0 && std::isfinite(*slowness))) slowness.reset();
    slowness_ = slowness;
    showStop();
    tell();
}

void QualityControl::setView(const live::WindowView& view) {
    if (view == view_ || view.sizePx.x < 1 || view.sizePx.y < 1) return;
    view_ = view;
    showStop();
    tell();
}

void QualityControl::setBounces(int bounces) {
    if (std::exchange(bounces_, bounces) != bounces) showStop();
}

void QualityControl::setStop(std::optional<std::size_t> stop) {
    if (stop) stop = std::min(*stop, front_.stops.size() - 1);
    if (stop == stop_) return;
    stop_ = stop;
    showStop();
    tell();
}

void QualityControl::step(int by) {
    const auto from = std::ptrdiff_t(stop_.value_or(nearestStop()));
    const auto last = std::ptrdiff_t(front_.stops.size()) - 1;
    setStop(std::size_t(std::clamp<std::ptrdiff_t>(from + by, 0, last)));
}

std::size_t QualityControl::nearestStop() const {
    return live::stopOf(front_, view_, slowness_.value_or(kAsFast), kUsualFrameMs);
}

void QualityControl::showStop() {
    const std::size_t at = stop_.value_or(nearestStop());
    {
        const QSignalBlocker quietSlider(slider_);
        const QSignalBlocker quietBox(automatic_);
        slider_->setValue(int(at));
        automatic_->setChecked(!stop_);
    }
    setText(stop_ ? tr("Quality %1/%2").arg(at + 1).arg(front_.stops.size()) : tr("Quality: automatic"));
    const QString words = stop_ ? wordsOf(front_.stops[at])
                                : tr("Automatic: as much as there is time for. Move the slider to choose.");
    words_->setText(words);
    setToolTip(tr("Quality of frames in motion. %1").arg(words));
}

// A frame's time and errors at this stop; and the bounces of their measurement, if the picture has others.
QString QualityControl::wordsOf(const live::FrontPoint& stop) const {
    QString words;
    if (slowness_) {
        words = tr("About %1 a frame on this machine.")
                    .arg(millisecondsText(live::costOf(front_, stop, view_, *slowness_).ms()));
    } else {
        words = tr("How long a frame takes here is being measured.");
    }
    words += QLatin1Char(' ') + tr("Expected error (FLIP, 0 is none): %L1 where you look, %L2 in all.")
                                    .arg(stop.fovealFlip, 0, 'f', 3)
                                    .arg(stop.flip, 0, 'f', 3);
    if (bounces_ > 0 && bounces_ != front_.bounces)
        words += QLatin1Char(' ') +
                 tr("It was measured with %1 bounces of light; the picture has %2 at every stop.")
                     .arg(front_.bounces)
                     .arg(bounces_);
    return words;
}

void QualityControl::tell() {
    live::LiveQuality now;
    if (stop_) {
        const live::FrontPoint& stop = front_.stops[*stop_];
        now = live::liveQualityOf(stop, live::costOf(front_, stop, view_, slowness_.value_or(kAsFast)));
    }
    if (now == told_) return;
    told_ = now;
    Q_EMIT changed(now);
}

}  // namespace macula::viewer
