#include "viewer/planar/planar_bar.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
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

using Kind = study::ImageMeasurement::Kind;

}  // namespace

PlanarBar::PlanarBar(QWidget* parent)
    : QWidget(parent),
      play_(new QToolButton),
      places_(new QSlider(Qt::Horizontal)),
      speed_(new QComboBox),
      displays_(new QComboBox),
      presentations_(new QComboBox),
      measure_(new QToolButton) {
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
    describe(*presentations_, "images-presentation", tr("Presentation state"),
             tr("How somebody left the images for others: windows, marks and texts"));
    for (QComboBox* list : {displays_, presentations_}) {
        list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        list->setMinimumContentsLength(kLettersOfDisplay);
    }
    presentations_->hide();
    makeMenu();
    row->addWidget(play_);
    row->addWidget(speed_);
    row->addWidget(places_, 1);
    row->addWidget(presentations_);
    row->addWidget(displays_);
    row->addWidget(measure_);
    boxes_ = addButton("image-boxes", tr("Boxes"), tr("Several images side by side, and hanging protocols"));
    boxes_->setPopupMode(QToolButton::InstantPopup);
    boxes_->hide();
    invert_ = addButton("invert-image", tr("Invert"), tr("Show bright values dark; I"));
    invert_->setCheckable(true);
    QToolButton* turn = addButton("turn-image", tr("Turn"), tr("Turn the picture by 90° clockwise; R"));
    QToolButton* mirror = addButton("mirror-image", tr("Mirror"), tr("Exchange left and right; M"));
    QToolButton* fit = addButton("fit-image", tr("Fit"), tr("Show the whole picture; F"));
    back_ = addButton("images-back", tr("Back"), tr("Back to the volume that is open; Esc"));
    connect(play_, &QToolButton::toggled, this, &PlanarBar::playToggled);
    connect(places_, &QSlider::valueChanged, this, &PlanarBar::placeChosen);
    connect(displays_, &QComboBox::activated, this, &PlanarBar::displayChosen);
    connect(presentations_, &QComboBox::activated, this, &PlanarBar::presentationChosen);
    connect(invert_, &QToolButton::toggled, this, &PlanarBar::invertToggled);
    connect(turn, &QToolButton::clicked, this, &PlanarBar::turnAsked);
    connect(mirror, &QToolButton::clicked, this, &PlanarBar::mirrorAsked);
    connect(fit, &QToolButton::clicked, this, &PlanarBar::fitAsked);
    connect(back_, &QToolButton::clicked, this, &PlanarBar::backAsked);
    // A click on a control does not take the keyboard focus from the image.
    for (QWidget* control : findChildren<QWidget*>())
        if (!control->isWindow()) control->setFocusPolicy(Qt::TabFocus);
}

void PlanarBar::makeMenu() {
    describe(*measure_, "measure-image", tr("Measure"),
             tr("Measure on the image: distance, angle, ellipse, Cobb angle; overlays"));
    measure_->setText(tr("Measure"));
    measure_->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(measure_);
    auto* tools = new QActionGroup(menu);
    const auto add = [&](std::optional<Kind> tool, const char* name, const QString& text) {
        QAction* action = menu->addAction(text);
        action->setObjectName(QLatin1String(name));
        action->setCheckable(true);
        tools->addAction(action);
        tools_[tool] = action;
        connect(action, &QAction::triggered, this, [this, tool] { Q_EMIT toolChosen(tool); });
    };
    // A tabulator sets off a key that is no shortcut of the window.
    add({}, "image-window-tool", tr("Window: drag") + QStringLiteral("\tW"));
    add(Kind::distance, "image-distance", tr("Distance") + QStringLiteral("\tD"));
    add(Kind::angle, "image-angle", tr("Angle") + QStringLiteral("\tG"));
    add(Kind::ellipse, "image-ellipse", tr("Ellipse") + QStringLiteral("\tE"));
    add(Kind::cobb, "image-cobb", tr("Cobb angle: two lines") + QStringLiteral("\tC"));
    tools_[{}]->setChecked(true);
    menu->addSeparator();
    copy_ = menu->addAction(tr("Copy Measurements"), this, &PlanarBar::copyAsked);
    copy_->setObjectName(QStringLiteral("copy-image-measurements"));
    save_ = menu->addAction(tr("Save Measurements…"), this, &PlanarBar::saveAsked);
    save_->setObjectName(QStringLiteral("save-image-measurements"));
    removeAll_ = menu->addAction(tr("Remove All Measurements"), this, &PlanarBar::removeAllAsked);
    removeAll_->setObjectName(QStringLiteral("remove-image-measurements"));
    menu->addSeparator();
    overlays_ = menu->addAction(tr("Overlays of the file") + QStringLiteral("\tO"));
    overlays_->setObjectName(QStringLiteral("image-overlays"));
    overlays_->setCheckable(true);
    connect(overlays_, &QAction::toggled, this, &PlanarBar::overlaysToggled);
    measure_->setMenu(menu);
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

void PlanarBar::setPresentations(const QStringList& names, int chosen) {
    const QSignalBlocker blocker(presentations_);
    presentations_->clear();
    presentations_->addItems(names);
    presentations_->setCurrentIndex(chosen);
    presentations_->setVisible(!names.isEmpty());
}

void PlanarBar::setTool(std::optional<Kind> tool) {
    tools_.at(tool)->setChecked(true);
}

void PlanarBar::setOverlays(bool hasOnes, bool shown) {
    const QSignalBlocker blocker(overlays_);
    overlays_->setEnabled(hasOnes);
    overlays_->setChecked(shown);
}

void PlanarBar::setHasMeasurements(bool has) {
    for (QAction* action : {copy_, save_, removeAll_}) action->setEnabled(has);
}

void PlanarBar::setBoxesMenu(QMenu* menu) {
    boxes_->setMenu(menu);
    boxes_->setVisible(menu != nullptr);
}

double PlanarBar::speed() const {
    const int index = speed_->currentIndex();
    return index < 0 ? 1.0 : kSpeeds.at(std::size_t(index));
}

}  // namespace macula::viewer
