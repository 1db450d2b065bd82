#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/window/status_controller.h"

#include <QHBoxLayout>
#include <QMainWindow>
#include <QStatusBar>
#include <QToolBar>
#include <chrono>
#include <utility>
#include <variant>

#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/panes/panes_controller.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"
#include "viewer/status/study_texts.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kRateLasts{1000};
constexpr std::chrono::milliseconds kPreparingIsTold{200};  // shorter ones go unnoticed

}  // namespace

StatusController::StatusController(const WindowContext& context, const PanesController& panes)
    : QObject(&context.window),
      context_(context),
      panes_(panes),
      badge_(new FidelityBadge),
      description_(new ElidingLabel(tr("Series"))),
      fidelity_(new ElidingLabel(tr("How true the picture is"))),
      volumeText_(new ElidingLabel(tr("Voxels and their size"))),
      modelText_(new ElidingLabel(tr("The preview with all pixels that is shown while a hand moves; it gets "
                                     "sharper while nothing moves"))),
      pictureText_(new ElidingLabel(tr("Pixels, pictures per second"))),
      deviceText_(new ElidingLabel(tr("Device"))) {
    // The fidelity is elided last, because it says how far the picture can be trusted.
    fidelity_->keepLongest();
    makeTimers();
    connect(&context_.viewport, &Viewport::rendered, this, &StatusController::onRendered);
    connect(&panes_, &PanesController::layoutShown, this, &StatusController::tellOfPicture);
}

void StatusController::makeTimers() {
    rateEnds_.setSingleShot(true);
    rateEnds_.setInterval(kRateLasts);
    connect(&rateEnds_, &QTimer::timeout, this,
            [this] { pictureText_->setFullText(pictureText_->fullText().section(QLatin1Char(','), 0, 0)); });
    prepares_.setSingleShot(true);
    prepares_.setInterval(kPreparingIsTold);
    connect(&prepares_, &QTimer::timeout, this, [this] {
        if (!panes_.isVolumeShown()) return;
        badge_->hide();  // the picture on screen is an older one
        fidelity_->setFullText(preparing_);
    });
}

void StatusController::addDescription(QToolBar& bar) {
    description_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar.addWidget(description_);
}

void StatusController::addTo(QStatusBar& bar) {
    // In a widget of its own: a temporary message hides the bar's widgets, and a badge that shows itself
    // would lie over the message.
    auto* badgePlace = new QWidget;
    auto* row = new QHBoxLayout(badgePlace);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(badge_);
    bar.addWidget(badgePlace);
    bar.addWidget(fidelity_, 1);
    bar.addPermanentWidget(modelText_);
    bar.addPermanentWidget(pictureText_);
    bar.addPermanentWidget(volumeText_);
    bar.addPermanentWidget(deviceText_);
    fidelity_->setFullText(tr("No study is open"));
}

void StatusController::showTexts() {
    const bool names = context_.viewport.namesShown();
    const StudyTexts texts =
        images_ ? textsOfImages(*images_, names) : textsOf(context_.session.study(), names);
    context_.window.setWindowTitle(texts.title);
    volumeText_->setFullText(texts.voxels);
    description_->setFullText(texts.description, texts.whyThisOne);
}

void StatusController::setImagesShown(std::optional<study::Identity> identity) {
    images_ = std::move(identity);
    showTexts();
    tellOfPicture();
}

QString StatusController::description() const {
    return description_->fullText();
}

QString StatusController::voxels() const {
    return volumeText_->fullText();
}

QString StatusController::rate() const {
    return pictureText_->fullText();
}

QString StatusController::fidelity() const {
    return fidelity_->fullText();
}

QString StatusController::badge() const {
    return badge_->text();
}

QString StatusController::model() const {
    return modelText_->fullText();
}

void StatusController::tellOfPicture() {
    const bool isShown = panes_.isVolumeShown() && !images_;
    const live::FrameShown* frame = isShown ? context_.viewport.frameOnScreen() : nullptr;
    if (frame != nullptr) return tellOfFrame(*frame);
    rateEnds_.stop();
    badge_->hide();
    pictureText_->setFullText({});
    modelText_->setFullText({});
    fidelity_->setFullText(images_                        ? tr("Images, not in 3D")
                           : !context_.session.hasStudy() ? tr("No study is open")
                           : !isShown                     ? withoutVolumeText(panes_.grid().shownLayout())
                           : pictureFailed_               ? tr("No picture")
                                                          : tr("The picture in 3D is being made…"));
}

void StatusController::onStudyShown() {
    pictureFailed_ = false;
    showTexts();
    tellOfPicture();
    context_.notes.set(NoteOn::picture, QString());
    if (deviceIsBack_) context_.notes.set(NoteOn::device, QString());
}

void StatusController::onRendered(const live::RenderEvent& event) {
    // The preparation has finished, or another text replaces it.
    if (std::holds_alternative<live::FrameShown>(event) ||
        std::holds_alternative<live::RenderFailure>(event) ||
        std::holds_alternative<live::DeviceReady>(event) ||
        std::holds_alternative<live::DeviceRestarting>(event))
        prepares_.stop();
    if (const auto* frame = std::get_if<live::FrameShown>(&event)) {
        onFrame(*frame);
    } else if (const auto* ready = std::get_if<live::DeviceReady>(&event)) {
        onDeviceReady(*ready);
    } else if (std::holds_alternative<live::DeviceRestarting>(event)) {
        onDeviceRestarting();
    } else if (const auto* changed = std::get_if<live::ModelChanged>(&event)) {
        if (changed->study == context_.viewport.study()) onModel(changed->model);
    } else if (const auto* preparing = std::get_if<live::Preparing>(&event)) {
        preparing_ = inWindowsLanguage(preparing->what) + QStringLiteral("…");
        if (!prepares_.isActive()) prepares_.start();
    } else if (std::holds_alternative<live::PictureRemoved>(event)) {
        tellOfPicture();
    } else if (const auto* failure = std::get_if<live::RenderFailure>(&event)) {
        onFailure(*failure);
    }
}

void StatusController::onDeviceReady(const live::DeviceReady& ready) {
    deviceText_->setFullText(QString::fromStdString(ready.name));
    deviceText_->setToolTip(QString::fromStdString(ready.description));
    isFirstStart_ = ready.isFirstStart;
    if (!context_.session.hasStudy() || !panes_.isVolumeShown()) tellOfPicture();  // no picture will follow
}

void StatusController::onDeviceRestarting() {
    badge_->hide();
    fidelity_->setFullText(tr("Starting the graphics device again…"));
    deviceIsBack_ = false;
    context_.notes.set(NoteOn::device,
                       tr("The graphics device stopped responding and is started again; the picture is made "
                          "anew. If this comes back, update the graphics driver."));
    context_.notes.show();
}

void StatusController::onFailure(const live::RenderFailure& failure) {
    pictureFailed_ = true;
    if (!std::exchange(deviceIsBack_, true)) {
        context_.notes.set(NoteOn::device, QString());  // the error replaces this note
        context_.notes.show();
    }
    tellOfPicture();
    context_.notifications.fail(failure.error);
}

void StatusController::onModel(const hybrid::ModelNews& model) {
    if (hybrid::isFitToBeShown(model)) isFirstStart_ = false;  // its kernels are compiled now
    if (panes_.isVolumeShown())
        modelText_->setFullText(modelText(model, isFirstStart_), aboutModel(model, isFirstStart_));
}

void StatusController::onFrame(const live::FrameShown& frame) {
    pictureFailed_ = false;
    QStringList about;
    for (const Message& message : frame.messages) about << inWindowsLanguage(message);
    // Only if the note is new: a person who dismissed it has read it.
    context_.notes.showIfOther(NoteOn::picture, about.join(QLatin1Char(' ')));
    if (!std::exchange(deviceIsBack_, true)) {
        context_.notes.set(NoteOn::device,
                           tr("The graphics device stopped responding and was started again. If this comes "
                              "back, update the graphics driver."));
        if (context_.notes.bar().isVisible()) context_.notes.show();  // otherwise a person has dismissed it
    }
    tellOfPicture();
    Q_EMIT frameShown(frame);
}

void StatusController::tellOfFrame(const live::FrameShown& frame) {
    QString text = fidelityText(frame);
    if (frame.samplesLeftOut > 0) text += tr(", %n samples left out", nullptr, int(frame.samplesLeftOut));
    if (!frame.messages.empty())
        text += tr(", less than the full resolution");  // also when the note is dismissed
    fidelity_->setFullText(text);
    badge_->setFidelity(live::fidelityOf(frame));
    onModel(frame.model);
    QString pictureText = QStringLiteral("%1×%2").arg(frame.width).arg(frame.height);
    if (frame.framesPerSecond > 0.0 && frame.stage == live::Stage::moving) {
        pictureText += tr(", %1/s").arg(withLocalNumbers(QString::number(frame.framesPerSecond, 'f', 1)));
        rateEnds_.start();
    }
    pictureText_->setFullText(pictureText);
}

}  // namespace macula::viewer
