#include "viewer/phases/phase_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "viewer/menus/controls.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

constexpr double kUsualRate = 10.0;
constexpr double kMostRate = 30.0;
constexpr double kLeastReach = 1e-9;
constexpr double kMostReach = 1e9;

}  // namespace

PhaseBar::PhaseBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("phase-bar"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 2, 4, 2);
    column->setSpacing(2);
    column->addLayout(makeFirstRow());
    column->addLayout(makeSecondRow());
    hide();
}

QHBoxLayout* PhaseBar::makeFirstRow() {
    auto* row = new QHBoxLayout;
    play_ = addButton(*row, "phases-play", tr("Play"), tr("Play the phases, or stop"));
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
    open_ = addButton(*row, "phases-open", tr("Open This Phase"),
                      tr("Measurements and changes are then those of this phase, and 3D shows it too"));
    connect(open_, &QToolButton::clicked, this, &PhaseBar::openAsked);
    return row;
}

QHBoxLayout* PhaseBar::makeSecondRow() {
    auto* row = new QHBoxLayout;
    in3d_ = new QCheckBox(tr("3D Too"), this);
    describe(*in3d_, "phases-3d", tr("3D too"), tr("3D shows the phase of the slices, and plays it"));
    connect(in3d_, &QCheckBox::toggled, this, &PhaseBar::in3dToggled);
    row->addWidget(in3d_);
    learns_ = new QCheckBox(tr("Learn Phases"), this);
    describe(
        *learns_, "phases-learn", tr("Learn phases"),
        tr("While the 3D picture rests, a preview of each phase is learnt and stored; learnt phases play "
           "without being traced"));
    learns_->setChecked(true);
    learns_->setEnabled(false);
    connect(learns_, &QCheckBox::toggled, this, &PhaseBar::learningToggled);
    row->addWidget(learns_);
    noteOn3d_ = new QLabel(this);
    makePlain(*noteOn3d_, "phases-3d-note");
    noteOn3d_->setWordWrap(false);
    row->addWidget(noteOn3d_);
    row->addStretch(1);
    reference_ = new QComboBox(this);
    describe(
        *reference_, "phases-difference", tr("Values or difference"),
        tr("Whether slices show the values of the phase, or how they differ from those of another phase"));
    connect(reference_, &QComboBox::currentIndexChanged, this,
            [this](int index) { Q_EMIT referenceChosen(index - 1); });
    row->addWidget(reference_);
    reach_ = new QDoubleSpinBox(this);
    describe(*reach_, "phases-reach", tr("Largest difference with a colour of its own"),
             tr("Differences beyond this have the same colour"));
    reach_->setDecimals(9);  // a range is rounded to them
    reach_->setRange(kLeastReach, kMostReach);
    reach_->setPrefix(QStringLiteral("± "));
    reach_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    reach_->hide();
    connect(reach_, &QDoubleSpinBox::valueChanged, this, &PhaseBar::reachChosen);
    row->addWidget(reach_);
    curve_ = addButton(*row, "phases-curve", tr("Curve over Phases…"),
                       tr("The mean within each ellipse, in each phase"));
    connect(curve_, &QToolButton::clicked, this, &PhaseBar::curveAsked);
    return row;
}

QToolButton* PhaseBar::addButton(QHBoxLayout& row, const char* name, const QString& text,
                                 const QString& tip) {
    auto* button = new QToolButton(this);
    describe(*button, name, text, tip);
    button->setText(text);
    button->setFocusPolicy(Qt::TabFocus);
    row.addWidget(button);
    return button;
}

void PhaseBar::setPhases(int count) {
    const QSignalBlocker quiet(phases_);
    phases_->setRange(0, count - 1);
    const QSignalBlocker quietToo(reference_);
    reference_->clear();
    reference_->addItem(tr("Values"));
    for (int phase = 1; phase <= count; ++phase) reference_->addItem(tr("Difference to phase %1").arg(phase));
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

void PhaseBar::setIn3d(bool on) {
    const QSignalBlocker quiet(in3d_);
    in3d_->setChecked(on);
    learns_->setEnabled(on);
}

void PhaseBar::setNoteOn3d(const QString& note) {
    noteOn3d_->setText(note);
    noteOn3d_->setVisible(!note.isEmpty());
}

void PhaseBar::setReference(int phase) {
    const QSignalBlocker quiet(reference_);
    reference_->setCurrentIndex(phase + 1);
    reach_->setVisible(phase >= 0);
}

void PhaseBar::setReach(double reach, const QString& unit) {
    const QSignalBlocker quiet(reach_);
    // Three digits, as small as values may be.
    reach_->setDecimals(std::clamp(2 - int(std::floor(std::log10(std::max(reach, kLeastReach)))), 0, 9));
    reach_->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
    reach_->setValue(reach);
}

double PhaseBar::perSecond() const {
    return rate_->value();
}

}  // namespace macula::viewer
