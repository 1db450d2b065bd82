#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/receive/receive_controller.h"

#include <QAction>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QStringList>
#include <utility>

#include "net/dimse/address_range.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/settings_controller.h"
#include "viewer/status/notifications.h"
#include "viewer/watch/arrival_bar.h"

namespace macula::viewer {

namespace {

constexpr qsizetype kMostSaid = 100;

bool isOpenToOthersInTheClear(const net::StoreProviderOptions& provider) {
    return !provider.tls.isOn && !net::isOfThisMachineAlone(provider.address);
}

}  // namespace

ReceiveController::ReceiveController(const WindowContext& context, Parts parts)
    : QObject(&context.window),
      context_(context),
      parts_(parts),
      label_(new QLabel(&context.window)),
      job_(this, {.ended = [this](const Result<ReceptionEnd>& ended) { end(ended); }}) {
    label_->setObjectName(QStringLiteral("receive-state"));
    label_->setTextFormat(Qt::PlainText);
    label_->hide();
    connect(&parts_.settings, &SettingsController::receivingChanged, this, &ReceiveController::onSettings);
}

void ReceiveController::addAction(QMenu& file) {
    action_ = file.addAction(tr("&Receive Studies"));
    describe(*action_, "receive",
             tr("Take studies that others send to this machine, until it is switched off or the window "
                "closes; Settings, Receiving says who may send"));
    action_->setCheckable(true);
    connect(action_, &QAction::triggered, this, &ReceiveController::setOn);
    if (parts_.settings.settings().receiving.atStart) post(this, [this] { setOn(true); });
}

void ReceiveController::setOn(bool on) {
    isWanted_ = on;
    if (!on) stop_.cancel();
    if (on && !job_.running()) begin();
    show();
}

void ReceiveController::begin() {
    used_ = parts_.settings.settings().receiving;
    auto options = receivingOptions(used_);
    if (!options) {
        isWanted_ = false;
        show();
        return context_.notifications.showError(options.error());
    }
    options_ = *std::move(options);
    options_.limits.quiet = parts_.quiet;
    stop_ = CancelToken();
    said_.clear();
    const auto tell = [this](const ReceptionNews& news) { post(this, [this, news] { take(news); }); };
    job_.start([options = options_, stop = stop_, tell](Progress& progress) {
        return receiveUntilStopped(options, stop, progress, tell);
    });
}

void ReceiveController::take(const ReceptionNews& news) {
    const bool isFirst = std::exchange(port_, news.port) == 0;
    const bool hasChanged = news.arriving != news_.arriving || !news.done.empty();
    news_ = news;
    if (isFirst && isOpenToOthersInTheClear(options_.provider))
        context_.notifications.showNote(
            tr("Macula now receives studies. What other machines send is not encrypted; a certificate in "
               "Settings, Receiving encrypts it."));
    for (const study::ReceivedStudy& study : news.done) announce(study);
    if (news.trouble) {
        const QString sentence = inWindowsLanguage(*news.trouble);
        if (said_.size() < kMostSaid && !said_.contains(sentence)) {
            said_.insert(sentence);
            context_.notifications.showError(*news.trouble);
        }
    }
    show();
    if (hasChanged) Q_EMIT studiesChanged();
}

// The folder opens as one of fetched studies, with what is noted of it.
void ReceiveController::announce(const study::ReceivedStudy& study) {
    QStringList senders;
    for (const std::string& sender : study.senders) senders.append(QString::fromStdString(sender));
    parts_.arrivals.add({.folder = study.folder,
                         .file = study.folder,
                         .identity = study.identity,
                         .modalities = study.modalities,
                         .images = study.instances,
                         .sender = senders.join(QStringLiteral(", ")).toStdString()});
    QStringList told;
    for (const Message& message : study.messages) told.append(inWindowsLanguage(message));
    if (!told.isEmpty()) context_.notifications.showNote(told.join(QStringLiteral("\n")));
    // What was said of a full disk may be said again.
    said_.clear();
}

void ReceiveController::end(const Result<ReceptionEnd>& ended) {
    port_ = 0;
    news_ = {};
    if (!ended) {
        isWanted_ = false;
        context_.notifications.showError(ended.error());
    } else if (isWanted_) {
        begin();
    }
    show();
}

// It begins again with them, once it has ended.
void ReceiveController::onSettings() {
    ReceiveSettings now = parts_.settings.settings().receiving;
    now.atStart = used_.atStart;
    if (job_.running() && now != used_) stop_.cancel();
}

QString ReceiveController::text() const {
    if (port_ == 0) return {};
    if (news_.arriving.images > 0)
        return tr("%n images are arriving at port %1", nullptr, int(news_.arriving.images)).arg(port_);
    return tr("Receives as %1 at port %2").arg(QString::fromStdString(options_.provider.ownAe)).arg(port_);
}

void ReceiveController::show() {
    if (action_ != nullptr) action_->setChecked(isWanted_);
    QStringList more{tr("Macula listens for studies that others send. File, Receive Studies ends it.")};
    if (news_.turnedAway > 0 && news_.whyTurnedAway)
        more.append(tr("%n connections were turned away. The last: %1", nullptr, int(news_.turnedAway))
                        .arg(inWindowsLanguage(*news_.whyTurnedAway)));
    if (news_.refused > 0)
        more.append(
            tr("%n objects were refused, and their sender was told so.", nullptr, int(news_.refused)));
    label_->setText(text());
    label_->setToolTip(more.join(QLatin1Char('\n')));
    label_->setVisible(port_ != 0);
}

}  // namespace macula::viewer
