#include "viewer/second/second_volume_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSlider>
#include <QStandardItemModel>
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/second/second_curve.h"
#include "scene/state/carried_view.h"
#include "scene/transfer/same_transfer.h"
#include "viewer/language/harmless_text.h"
#include "viewer/menus/controls.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

constexpr int kPercent = 100;
constexpr int kArrowsPx = 40;
constexpr double kLargest = 1e9;  // limit for the ends of a window, as in files

struct ViewRow {
    scene::SecondVolumePlace view;
    const char* title;
};
constexpr std::array kViews{
    ViewRow{scene::SecondVolumePlace::hidden,
            QT_TRANSLATE_NOOP("macula::viewer::SecondVolumeBar", "Study alone")},
    ViewRow{scene::SecondVolumePlace::beside,
            QT_TRANSLATE_NOOP("macula::viewer::SecondVolumeBar", "Side by side")},
    ViewRow{scene::SecondVolumePlace::instead,
            QT_TRANSLATE_NOOP("macula::viewer::SecondVolumeBar", "Second alone")},
    ViewRow{scene::SecondVolumePlace::over,
            QT_TRANSLATE_NOOP("macula::viewer::SecondVolumeBar", "In colours over the study")}};

struct ColourRow {
    slices::ColourTable colours;
    const char* title;
};
constexpr std::array kColours{
    ColourRow{slices::ColourTable::hotIron, QT_TRANSLATE_NOOP("macula::viewer::SecondVolumeBar", "Hot iron")},
    ColourRow{slices::ColourTable::green, QT_TRANSLATE_NOOP("macula::viewer::SecondVolumeBar", "Green")},
    ColourRow{slices::ColourTable::grey, QT_TRANSLATE_NOOP("macula::viewer::SecondVolumeBar", "Grey")}};

void setItemEnabled(QComboBox& box, int index, bool enabled) {
    auto* model = qobject_cast<QStandardItemModel*>(box.model());
    if (model != nullptr) model->item(index)->setEnabled(enabled);
}

// The step of the arrows for a window of this width.
double stepOf(double width) {
    return std::pow(10.0, std::floor(std::log10(std::max(width, 1e-6))) - 1.0);
}

}  // namespace

SecondVolumeBar::SecondVolumeBar(StudyEditor& session, SecondVolumeLoader& beside, QWidget* parent)
    : QToolBar(tr("Second Volume"), parent),
      session_(session),
      secondVolume_(beside),
      tag_(new ElidingLabel(tr("The second volume"))) {
    setObjectName(QStringLiteral("beside-bar"));
    setMovable(false);
    tag_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addViews();
    addLinks();
    addColours();
    addWindow();
    addLinkedWindow();
    addIn3d();
    addWidget(tag_);
    QAction* close = addAction(tr("Close"), &secondVolume_, &SecondVolumeLoader::close);
    describe(*close, "close-beside", tr("Close the second volume; the study stays"));
    for (QComboBox* list : {views_, links_, colours_, presets_})
        connect(list, &QComboBox::activated, this, &SecondVolumeBar::listLeft);
    connect(&session_, &StudyEditor::changed, this, &SecondVolumeBar::showState);
    connect(&secondVolume_, &SecondVolumeLoader::secondChanged, this, &SecondVolumeBar::showState);
    connect(&secondVolume_, &SecondVolumeLoader::began, this, &SecondVolumeBar::showState);
    connect(&secondVolume_, &SecondVolumeLoader::ended, this, &SecondVolumeBar::showState);
    showState();
}

void SecondVolumeBar::addViews() {
    views_ = new QComboBox(this);
    describe(*views_, "beside-view", tr("How the second volume is shown"),
             tr("The second volume beside the study, in its place, or over it. J puts it in the place "
                "of the study, and back"));
    for (const ViewRow& row : kViews) views_->addItem(tr(row.title));
    connect(views_, &QComboBox::activated, this,
            [this](int index) { secondVolume_.setView(kViews.at(std::size_t(index)).view); });
    addWidget(views_);
}

void SecondVolumeBar::addLinks() {
    links_ = new QComboBox(this);
    describe(*links_, "beside-link", tr("How the second volume is linked"),
             tr("What takes a place in the study to the same place in the second volume. By hand, the wheel "
                "over the second volume moves it alone"));
    links_->addItems({tr("By hand"), tr("Same frame of reference"), tr("Registered")});
    connect(links_, &QComboBox::activated, this, [this](int index) {
        switch (scene::kSecondVolumeLinks.at(std::size_t(index))) {
            case scene::SecondVolumeLink::byHand:
                secondVolume_.linkByHand();
                break;
            case scene::SecondVolumeLink::sameFrame:
                secondVolume_.linkByFrame();
                break;
            case scene::SecondVolumeLink::registered:
                secondVolume_.registerNow();
                break;
        }
        showState();  // shows the old link until registration has finished
    });
    addWidget(links_);
}

void SecondVolumeBar::addColours() {
    colours_ = new QComboBox(this);
    describe(*colours_, "beside-colours", tr("Colours of the second volume"),
             tr("Colours of the second volume where it lies over the study"));
    for (const ColourRow& row : kColours) colours_->addItem(tr(row.title));
    connect(colours_, &QComboBox::activated, this, [this](int index) {
        if (secondVolume_.state() == nullptr) return;
        session_.change(tr("Colours"), [index](scene::StudyState& next) {
            next.secondVolume->colours = kColours.at(std::size_t(index)).colours;
        });
    });
    addWidget(colours_);
    opacity_ = new QSlider(Qt::Horizontal, this);
    opacity_->setObjectName(QStringLiteral("beside-opacity"));
    opacity_->setRange(0, kPercent);
    opacity_->setAccessibleName(tr("Opacity of the second volume in percent"));
    constexpr int kSliderPx = 100;
    opacity_->setFixedWidth(kSliderPx);
    connect(opacity_, &QSlider::valueChanged, this, [this](int percent) {
        opacity_->setToolTip(tr("Opacity of the second volume over the study: %1 %").arg(percent));
        if (isShowing_ || secondVolume_.state() == nullptr) return;
        session_.drag(tr("Opacity"), [percent](scene::StudyState& next) {
            next.secondVolume->opacity = double(percent) / kPercent;
        });
        // Keys and the wheel emit no sliderReleased, which would end the step.
        if (!opacity_->isSliderDown()) session_.endDrag();
    });
    connect(opacity_, &QSlider::sliderReleased, &session_, &StudyEditor::endDrag);
    addWidget(opacity_);
}

void SecondVolumeBar::addWindow() {
    const auto add = [this](const char* name, const QString& text) {
        auto* box = new QDoubleSpinBox(this);
        box->setObjectName(QString::fromLatin1(name));
        box->setRange(-kLargest, kLargest);
        box->setKeyboardTracking(false);  // "25" is not 2 for a moment
        box->setAccessibleName(text);
        // Otherwise the box would be as wide as its range, which no value needs.
        box->setMaximumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("-100,000.00 Bq/mL")) +
                             kArrowsPx);
        connect(box, &QDoubleSpinBox::valueChanged, this, &SecondVolumeBar::proposeWindow);
        connect(box, &QDoubleSpinBox::editingFinished, &session_, &StudyEditor::endDrag);
        addWidget(box);
        return box;
    };
    black_ = add("beside-black", tr("Window of the second volume from"));
    white_ = add("beside-white", tr("Window of the second volume up to"));
}

void SecondVolumeBar::addLinkedWindow() {
    oneWindow_ = new QCheckBox(tr("One window"), this);
    describe(*oneWindow_, "beside-one-window", tr("One window for the study and the second volume"),
             tr("Slices of both through one window, as phases are compared. Both have to have one unit"));
    connect(oneWindow_, &QCheckBox::clicked, this, [this](bool on) {
        if (secondVolume_.state() == nullptr) return;
        session_.change(tr("Window of the second volume"), [&](scene::StudyState& next) {
            // Starts from the linked window, so that the picture does not change when the link ends.
            if (!on) next.secondVolume->window = secondWindow();
            next.secondVolume->linksWindow = on;
        });
        showState();
    });
    addWidget(oneWindow_);
}

// The window with which slices show the second volume.
DisplayWindow SecondVolumeBar::secondWindow() const {
    const scene::SecondVolumeState& state = *secondVolume_.state();
    if (state.linksWindow) return scene::shownWindow(session_.study(), session_.state().slices);
    return state.window.value_or(secondVolume_.second()->usualWindow);
}

void SecondVolumeBar::addIn3d() {
    in3d_ = new QCheckBox(tr("In 3D too"), this);
    describe(
        *in3d_, "beside-in3d", tr("The second volume in the 3D picture"),
        tr("The second volume in one 3D picture with the study. It has to be of the same patient, and linked "
           "by more than hand; projections show the study alone"));
    connect(in3d_, &QCheckBox::clicked, this, [this](bool on) {
        if (secondVolume_.state() == nullptr) return;
        session_.change(tr("Second volume in 3D"),
                        [on](scene::StudyState& next) { next.secondVolume->in3d = on; });
        showState();
    });
    addWidget(in3d_);
    presets_ = new QComboBox(this);
    describe(
        *presets_, "beside-preset", tr("Preset of the second volume in 3D"),
        tr("What the second volume is drawn with in 3D: window, colours and opacity from here, or a preset"));
    presets_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    constexpr int kLetters = 14;
    presets_->setMinimumContentsLength(kLetters);
    connect(presets_, &QComboBox::activated, this, [this](int index) {
        if (secondVolume_.state() == nullptr || index < 0 || std::size_t(index) > listed_.size()) return;
        const auto preset = index == 0 ? nullptr : listed_[std::size_t(index) - 1];
        session_.change(tr("Preset of the second volume"),
                        [&](scene::StudyState& next) { next.secondVolume->preset = preset; });
    });
    addWidget(presets_);
}

// Lists the presets for the volume's unit, and the preset of the state, wherever it comes from.
void SecondVolumeBar::fillPresets(const scene::SecondVolumeState& state) {
    std::vector<std::shared_ptr<const TransferFunction>> wanted;
    const Unit unit = secondVolume_.second()->study.volume->unit();
    for (const auto& preset : session_.catalogue().presets)
        if (suits(*preset, unit)) wanted.push_back(preset);
    const auto isOurs = [&](const auto& each) { return scene::isSame(*each, *state.preset); };
    if (state.preset && std::ranges::none_of(wanted, isOurs)) wanted.push_back(state.preset);
    if (wanted != listed_ || presets_->count() == 0) {
        listed_ = std::move(wanted);
        presets_->clear();
        presets_->addItem(tr("As over slices"));
        for (const auto& preset : listed_) presets_->addItem(harmless(titleOr(preset->title, preset->name)));
    }
    const auto at = state.preset ? std::ranges::find_if(listed_, isOurs) : listed_.end();
    presets_->setCurrentIndex(at == listed_.end() ? 0 : int(at - listed_.begin()) + 1);
}

void SecondVolumeBar::proposeWindow() {
    if (isShowing_ || secondVolume_.state() == nullptr) return;
    const double low = black_->value();
    const double high = white_->value();
    if (!(high > low)) return showState();  // not a window: the old one stays
    session_.drag(tr("Window of the second volume"), [&](scene::StudyState& next) {
        (next.secondVolume->linksWindow ? next.slices.window : next.secondVolume->window) = DisplayWindow{
            .center = 0.5 * (low + high), .width = high - low, .explanation = {}, .function = "LINEAR_EXACT"};
    });
}

void SecondVolumeBar::showState() {
    const scene::SecondVolumeState* state = secondVolume_.state();
    setVisible(state != nullptr);
    if (state == nullptr) return;
    const QScopedValueRollback shows(isShowing_, true);
    const SecondVolumeTexts& second = *secondVolume_.second();
    const Volume& volume = *second.study.measured();
    const auto view = std::ranges::find(kViews, state->view, &ViewRow::view);
    views_->setCurrentIndex(int(view - kViews.begin()));
    setItemEnabled(*views_, int(scene::SecondVolumePlace::over), state->isLinked());
    links_->setCurrentIndex(int(state->link));
    setItemEnabled(*links_, int(scene::SecondVolumeLink::sameFrame), secondVolume_.canShareFrame());
    setItemEnabled(*links_, int(scene::SecondVolumeLink::registered), secondVolume_.canRegister());
    const bool isOver = state->view == scene::SecondVolumePlace::over;
    const bool mayBe = scene::maySecondBeIn3d(session_.study().identity, second.study.identity);
    const bool isFused = mayBe && scene::isSecondIn3d(*state);
    in3d_->setEnabled(mayBe && state->isLinked() && state->view != scene::SecondVolumePlace::hidden);
    in3d_->setChecked(isFused);
    fillPresets(*state);
    presets_->setEnabled(isFused);
    colours_->setEnabled(isOver || (isFused && !state->preset));
    opacity_->setEnabled(isOver || (isFused && !state->preset));
    const auto colours = std::ranges::find(kColours, state->colours, &ColourRow::colours);
    colours_->setCurrentIndex(int(colours - kColours.begin()));
    opacity_->setValue(int(std::lround(state->opacity * kPercent)));
    const Volume& study = *session_.study().volume;
    oneWindow_->setEnabled(state->linksWindow ||
                           (study.unit() == volume.unit() && study.unitName() == volume.unitName()));
    oneWindow_->setChecked(state->linksWindow);
    const DisplayWindow window = secondWindow();
    const QString unit = harmless(QString::fromStdString(volume.unitName()));
    for (QDoubleSpinBox* box : {black_, white_}) {
        const double step = stepOf(window.width);
        box->setDecimals(std::clamp(int(-std::floor(std::log10(step))), 0, 6));
        box->setSingleStep(step);
        box->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
        box->setToolTip(tr("What is black and what is white of the second volume, in its own unit"));
    }
    black_->setValue(window.center - 0.5 * window.width);
    white_->setValue(window.center + 0.5 * window.width);
    QString text = second.tag + QStringLiteral(". ");
    text +=
        secondVolume_.isRegistering() ? tr("Registering…") : linkText(*state, second.study.dose.has_value());
    tag_->setFullText(text, second.patientNote);
}

}  // namespace macula::viewer
