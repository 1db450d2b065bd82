#include "viewer/phases/phase_bar.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "viewer/menus/controls.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

constexpr double kUsualRate = 10.0;
constexpr double kMostRate = 30.0;

}  // namespace

PhaseBar::PhaseBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("phase-bar"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    play_ = addButton("phases-play", tr("Play"), tr("Play the phases on slices, or stop"));
    play_->setCheckable(true);
    connect(play_, &QToolButton::clicked, this, &PhaseBar::playToggled);
    phases_ = new QSlider(Qt::Horizontal, this);
    describe(*phases_, "phases-slider", tr("Phase"), tr("Which phase the slices show"));
    connect(phases_, &QSlider::valueChanged, this, &PhaseBar::phaseChosen);
    row->addWidget(phases_, 1);
    shown_ = new ElidingLabel(tr("Phase on slices"), this);
    shown_->setObjectName(QStringLiteral("phases-shown"));
    row->addWidget(shown_, 1);
    rate_ = new QDoubleSpinBox(this);
    describe(*rate_, "phases-rate", tr("Phases a second"), tr("How many phases are shown in a second"));
    rate_->setRange(0.5, kMostRate);
    rate_->setDecimals(1);
    rate_->setValue(kUsualRate);
    row->addWidget(rate_);
    note_ = new QLabel(this);
    makePlain(*note_, "phases-note");
    note_->setWordWrap(false);
    row->addWidget(note_);
    open_ = addButton("phases-open", tr("Open This Phase"),
                      tr("3D shows this phase too; measurements and changes are then those of this phase"));
    connect(open_, &QToolButton::clicked, this, &PhaseBar::openAsked);
    curve_ = addButton("phases-curve", tr("Curve over Phases…"),
                       tr("The mean within each ellipse, in each phase"));
    connect(curve_, &QToolButton::clicked, this, &PhaseBar::curveAsked);
    hide();
}

QToolButton* PhaseBar::addButton(const char* name, const QString& text, const QString& tip) {
    auto* button = new QToolButton(this);
    describe(*button, name, text, tip);
    button->setText(text);
    button->setFocusPolicy(Qt::TabFocus);
    layout()->addWidget(button);
    return button;
}

void PhaseBar::setPhases(int count) {
    const QSignalBlocker quiet(phases_);
    phases_->setRange(0, count - 1);
    setVisible(count > 1);
}

void PhaseBar::setShown(int phase, const QString& text) {
    const QSignalBlocker quiet(phases_);
    phases_->setValue(phase);
    shown_->setFullText(text);
}

void PhaseBar::setPlaying(bool plays) {
    play_->setChecked(plays);
    play_->setText(plays ? tr("Stop") : tr("Play"));
}

void PhaseBar::setNote(const QString& note) {
    note_->setText(note);
    note_->setVisible(!note.isEmpty());
}

void PhaseBar::setCanOpen(bool can) {
    open_->setEnabled(can);
}

double PhaseBar::perSecond() const {
    return rate_->value();
}

}  // namespace macula::viewer
