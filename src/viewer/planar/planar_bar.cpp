#include "viewer/planar/planar_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <array>
#include <cstddef>

#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr std::array kSpeeds{0.25, 0.5, 1.0, 2.0};
constexpr int kAsRecorded = 2;
constexpr int kLettersOfDisplay = 14;

}  // namespace

PlanarBar::PlanarBar(QWidget* parent)
    : QWidget(parent),
      play_(new QToolButton),
      places_(new QSlider(Qt::Horizontal)),
      speed_(new QComboBox),
      displays_(new QComboBox) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    describe(*play_, "play-images", tr("Play"), tr("Play the frames of the image in a loop; Space"));
    play_->setText(tr("Play"));
    play_->setCheckable(true);
    describe(*speed_, "play-speed", tr("Speed"), tr("How fast the frames are played"));
    speed_->addItems(
        {QStringLiteral("¼ ×"), QStringLiteral("½ ×"), QStringLiteral("1 ×"), QStringLiteral("2 ×")});
    speed_->setCurrentIndex(kAsRecorded);
    describe(*places_, "images-place", tr("Image"), tr("Which image is shown; the wheel steps through them"));
    describe(*displays_, "images-window", tr("Window"), tr("The windows and tables of the file"));
    displays_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    displays_->setMinimumContentsLength(kLettersOfDisplay);
    row->addWidget(play_);
    row->addWidget(speed_);
    row->addWidget(places_, 1);
    row->addWidget(displays_);
    invert_ = addButton("invert-image", tr("Invert"), tr("Show bright values dark; I"));
    invert_->setCheckable(true);
    QToolButton* turn = addButton("turn-image", tr("Turn"), tr("Turn the picture by 90° clockwise; R"));
    QToolButton* mirror = addButton("mirror-image", tr("Mirror"), tr("Exchange left and right; M"));
    QToolButton* fit = addButton("fit-image", tr("Fit"), tr("Show the whole picture; F"));
    back_ = addButton("images-back", tr("Back"), tr("Back to the volume that is open; Esc"));
    connect(play_, &QToolButton::toggled, this, &PlanarBar::playToggled);
    connect(places_, &QSlider::valueChanged, this, &PlanarBar::placeChosen);
    connect(displays_, &QComboBox::activated, this, &PlanarBar::displayChosen);
    connect(invert_, &QToolButton::toggled, this, &PlanarBar::invertToggled);
    connect(turn, &QToolButton::clicked, this, &PlanarBar::turnAsked);
    connect(mirror, &QToolButton::clicked, this, &PlanarBar::mirrorAsked);
    connect(fit, &QToolButton::clicked, this, &PlanarBar::fitAsked);
    connect(back_, &QToolButton::clicked, this, &PlanarBar::backAsked);
    // A click on a control does not take the keyboard focus from the image.
    for (QWidget* control : findChildren<QWidget*>()) control->setFocusPolicy(Qt::TabFocus);
}

QToolButton* PlanarBar::addButton(const char* name, const QString& text, const QString& tip) {
    auto* button = new QToolButton;
    describe(*button, name, text, tip);
    button->setText(text);
    layout()->addWidget(button);
    return button;
}

void PlanarBar::setPlaces(int count, int place) {
    const QSignalBlocker blocker(places_);
    places_->setRange(0, count - 1);
    places_->setValue(place);
    places_->setEnabled(count > 1);
}

void PlanarBar::setPlaying(bool plays) {
    const QSignalBlocker blocker(play_);
    play_->setChecked(plays);
    play_->setText(plays ? tr("Stop") : tr("Play"));
}

void PlanarBar::setCanPlay(bool can) {
    play_->setEnabled(can);
    speed_->setEnabled(can);
}

void PlanarBar::setDisplays(const QStringList& names, int chosen) {
    const QSignalBlocker blocker(displays_);
    displays_->clear();
    displays_->addItems(names);
    displays_->setCurrentIndex(chosen);
    displays_->setEnabled(!names.isEmpty());
}

void PlanarBar::setInverted(bool isInverted) {
    const QSignalBlocker blocker(invert_);
    invert_->setChecked(isInverted);
}

void PlanarBar::setCanGoBack(bool can) {
    back_->setVisible(can);
}

double PlanarBar::speed() const {
    const int index = speed_->currentIndex();
    return index < 0 ? 1.0 : kSpeeds.at(std::size_t(index));
}

}  // namespace macula::viewer
