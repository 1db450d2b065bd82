#include "viewer/watch/arrival_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <algorithm>

#include "study/open/identity.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostWaiting = 100;

bool isSame(const study::ArrivedStudy& a, const study::ArrivedStudy& b) {
    return a.folder == b.folder && a.identity.studyInstanceUid == b.identity.studyInstanceUid;
}

}  // namespace

ArrivalBar::ArrivalBar(QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), open_(new QPushButton(this)), seen_(new QPushButton(this)) {
    makePlain(*text_, "arrival-text");
    open_->setText(tr("Open"));
    describe(*open_, "arrival-open", tr("Open"), tr("Open the study that arrived"));
    seen_->setText(tr("Not Now"));
    describe(*seen_, "arrival-seen", tr("Not now"), tr("Close this message; the study stays where it is"));
    connect(open_, &QPushButton::clicked, this, [this] {
        if (waiting_.empty()) return;
        const study::ArrivedStudy study = waiting_.front();
        next();
        Q_EMIT openAsked(study);
    });
    connect(seen_, &QPushButton::clicked, this, &ArrivalBar::next);
    auto* row = new QHBoxLayout(this);
    row->addWidget(text_, 1);
    row->addWidget(open_);
    row->addWidget(seen_);
    hide();
}

void ArrivalBar::add(const study::ArrivedStudy& study) {
    const auto known = std::ranges::find_if(
        waiting_, [&](const study::ArrivedStudy& other) { return isSame(study, other); });
    if (known != waiting_.end()) {
        *known = study;
    } else if (waiting_.size() < kMostWaiting) {
        waiting_.push_back(study);
    }
    refresh();
}

void ArrivalBar::dropFolder(const std::filesystem::path& folder) {
    std::erase_if(waiting_, [&](const study::ArrivedStudy& study) { return study.folder == folder; });
    refresh();
}

void ArrivalBar::showNames(bool shown) {
    namesShown_ = shown;
    refresh();
}

QString ArrivalBar::text() const {
    return isHidden() ? QString() : text_->text();
}

void ArrivalBar::next() {
    if (!waiting_.empty()) waiting_.pop_front();
    refresh();
}

void ArrivalBar::refresh() {
    setVisible(!waiting_.empty());
    if (waiting_.empty()) return;
    const study::ArrivedStudy& study = waiting_.front();
    QString text = whereItArrived(study);
    if (namesShown_) {
        const QString name = QString::fromStdString(study::nameForPeople(study.identity.patientName));
        text += QStringLiteral(", ") + (name.isEmpty() ? tr("no patient name") : name);
    }
    text += QLatin1Char('.');
    if (waiting_.size() > 1) text += tr(" %n more arrived.", nullptr, int(waiting_.size() - 1));
    text_->setText(text.simplified());
}

// The names of folders may be those of patients.
QString ArrivalBar::whereItArrived(const study::ArrivedStudy& study) const {
    QStringList list;
    for (const std::string& modality : study.modalities) list.append(QString::fromStdString(modality));
    const QString modalities = list.join(QLatin1Char('/'));
    const int images = int(study.images);
    if (!study.sender.empty())
        return tr("A new study was sent by %1: %2, %n images", nullptr, images)
            .arg(QString::fromStdString(study.sender), modalities);
    if (namesShown_)
        return tr("A new study arrived in %1: %2, %n images", nullptr, images)
            .arg(QString::fromStdString(study.folder.filename().string()), modalities);
    return tr("A new study arrived in a folder that is watched: %1, %n images", nullptr, images)
        .arg(modalities);
}

}  // namespace macula::viewer
