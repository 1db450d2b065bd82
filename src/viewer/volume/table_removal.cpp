#include "viewer/volume/table_removal.h"

#include <utility>

#include "scene/drawing/shown_clip.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

TableRemoval::TableRemoval(QObject* parent)
    : QObject(parent),
      action_(tr("&Remove Table"), this),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<Found>& outcome) { onEnded(outcome); }}) {
    action_.setObjectName(QStringLiteral("remove-table"));
    action_.setCheckable(true);
    action_.setShortcut(keyOf(KeyAction::removeTable));
    connect(&action_, &QAction::triggered, this, &TableRemoval::onTriggered);
    setVolume(nullptr);
}

void TableRemoval::setVolume(std::shared_ptr<const Volume> volume) {
    volume_ = std::move(volume);
    found_.reset();
    asked_ = false;
    action_.setChecked(false);
    action_.setEnabled(volume_ && volume_->unit() == Unit::hounsfield);
    if (!volume_) {
        action_.setToolTip(tr("No study is open"));
    } else if (!action_.isEnabled()) {
        action_.setToolTip(tr("The table can be left out of CT in Hounsfield units only"));
    } else {
        action_.setToolTip(tr("Leave out the table and what else lies beside the patient"));
    }
    if (job_.cancel()) Q_EMIT ended();
}

void TableRemoval::ask(bool removed) {
    if (!action_.isEnabled() || action_.isChecked() == removed) return;
    action_.setChecked(removed);
    onTriggered();
}

void TableRemoval::cancel() {
    if (!job_.cancel()) return;
    action_.setChecked(false);
    Q_EMIT ended();
}

std::optional<Mask> TableRemoval::mask() const {
    return asked_ && found_ ? scene::maskOf(found_) : std::nullopt;
}

QStringList TableRemoval::notes() const {
    QStringList notes;
    if (!asked_ || !found_) return notes;
    for (const Message& message : found_->messages) notes << inWindowsLanguage(message);
    return notes;
}

void TableRemoval::onTriggered() {
    if (!action_.isChecked()) {
        cancel();
        asked_ = false;
        Q_EMIT changed();
    } else if (found_) {
        onEnded(found_);
    } else {
        job_.start([volume = volume_](Progress& progress) -> Result<Found> {
            MACULA_TRY(segment::PatientMask mask, segment::findPatient(*volume, progress));
            return std::make_shared<const segment::PatientMask>(std::move(mask));
        });
        Q_EMIT began();
    }
}

void TableRemoval::onEnded(const Result<Found>& outcome) {
    Q_EMIT ended();
    if (!outcome) {
        action_.setChecked(false);
        if (outcome.error().code != ErrorCode::cancelled) Q_EMIT failed(outcome.error());
        return;
    }
    found_ = *outcome;
    asked_ = true;
    // Unchecks the action if no table was found.
    action_.setChecked(found_->removedMl > 0.0);
    Q_EMIT changed();
}

}  // namespace macula::viewer
