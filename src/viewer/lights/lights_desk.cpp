#include "viewer/lights/lights_desk.h"

#include <QScrollBar>
#include <utility>

#include "base/atomic_file.h"
#include "pipeline/trace/light_rig_json.h"
#include "scene/choice/lights_choice.h"
#include "scene/state/parameters.h"
#include "viewer/lights/lights_panel.h"

namespace macula::viewer {

LightsDesk::LightsDesk(StudyEditor& session, LightsHost host, QWidget* window)
    : QObject(window),
      session_(session),
      host_(std::move(host)),
      window_(window),
      editing_(session),
      tool_(session, editing_),
      panel_(new LightsPanel(session, editing_, window)),
      scrolls_(new QScrollArea(window)),
      metering_(this, {.progressed = [](const ProgressUpdate&) {},
                       .ended = [this](const Result<double>& exposure) { useMetered(exposure); }}) {
    // Scrolls, because the panel is too tall for a small screen.
    scrolls_->setObjectName(QStringLiteral("lights-scrolls"));
    scrolls_->setFrameShape(QFrame::NoFrame);
    scrolls_->setFocusPolicy(Qt::NoFocus);  // its contents have the focus
    scrolls_->setWidgetResizable(true);
    scrolls_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolls_->setWidget(panel_);
    scrolls_->setMinimumWidth(panel_->minimumSizeHint().width() +
                              scrolls_->verticalScrollBar()->sizeHint().width());
    connect(&editing_, &LightsEditing::changed, this, &LightsDesk::marksChanged);
    connect(panel_, &LightsPanel::saveAsked, this, &LightsDesk::save);
    connect(panel_, &LightsPanel::openAsked, this, &LightsDesk::open);
    connect(panel_, &LightsPanel::meteringAsked, this, &LightsDesk::meter);
    connect(panel_, &LightsPanel::lookedAt, this, [this] { editing_.setCamera(host_.seen().camera); });
    // An exposure metered for another picture is of no use.
    const auto stop = [this] {
        if (!metering_.running()) return;
        metering_.cancel();
        panel_->setMetering(false);
    };
    connect(&session_, &StudyEditor::studyShown, this, stop);
    connect(&session_, &StudyEditor::changed, this, stop);
}

void LightsDesk::save() {
    const auto rig = editing_.rig();
    auto* dialog = new QFileDialog(window_, tr("Save the lights"), host_.folder(), tr("Lights (*.json)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->selectFile(QString::fromStdString(rig->name) + QStringLiteral(".json"));
    host_.ask(dialog, [this, json = toJson(*rig)](const QString& path) {
        if (const Result<void> written = writeTextAtomically(path.toStdString(), json); !written)
            return Q_EMIT failed(written.error());
        Q_EMIT told(tr("The lights are written to %1. Use them with --lights %1.").arg(path));
    });
}

void LightsDesk::open() {
    auto* dialog =
        new QFileDialog(window_, tr("Open lights"), host_.folder(), tr("Lights (*.json);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    host_.ask(dialog, [this](const QString& path) {
        Result<trace::LightRig> rig = scene::chooseLightRig(path.toStdString());
        if (!rig) return Q_EMIT failed(rig.error());
        editing_.use(std::make_shared<const trace::LightRig>(*std::move(rig)));
    });
}

void LightsDesk::meter() {
    if (!editing_.isUsable()) return;
    panel_->setMetering(true);
    metering_.start([picture = host_.seen(), device = host_.device](Progress& progress) {
        return pictures::meteredExposureOf(picture, device, progress);
    });
}

void LightsDesk::useMetered(const Result<double>& exposure) {
    panel_->setMetering(false);
    if (!exposure) {
        if (exposure.error().code != ErrorCode::cancelled) panel_->tell(exposure.error());
        return;
    }
    session_.change(tr("Exposure"), [&](scene::StudyState& next) {
        scene::parameter("exposure").set(next.settings, *exposure);
    });
}

}  // namespace macula::viewer
