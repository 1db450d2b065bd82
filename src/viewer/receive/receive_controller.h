// Receives studies that others send, while a person wants it, and says what arrived. It opens nothing by
// itself.
#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <chrono>
#include <cstdint>

#include "base/progress.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/receive/reception.h"
#include "viewer/settings/receive_settings.h"

class QAction;
class QLabel;
class QMenu;

namespace macula::viewer {

class ArrivalBar;
class SettingsController;

// Lives on the UI thread; all that listens, reads and writes is on others.
class ReceiveController : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        SettingsController& settings;
        ArrivalBar& arrivals;
        std::chrono::milliseconds quiet;  // for how long nothing of a study comes until it counts as whole
    };
    ReceiveController(const WindowContext& context, Parts parts);

    void addAction(QMenu& file);
    QLabel* label() const { return label_; }  // while it listens; it belongs to the widget that shows it
    bool listening() const { return port_ != 0; }
    bool atRest() const { return job_.atRest(); }
    QString text() const;  // of the label; empty while nothing listens

    void setOn(bool on);

  Q_SIGNALS:
    void studiesChanged();  // images came, or a study is done

  private:
    void begin();
    void take(const ReceptionNews& news);
    void announce(const study::ReceivedStudy& study);
    void end(const Result<ReceptionEnd>& ended);
    void onSettings();
    void show();

    WindowContext context_;
    Parts parts_;
    QLabel* label_;
    QAction* action_ = nullptr;
    bool isWanted_ = false;
    CancelToken stop_;
    ReceiveSettings used_;             // by what listens
    study::ReceivingOptions options_;  // of these
    std::uint16_t port_ = 0;           // 0: nothing listens
    ReceptionNews news_;               // the last
    QSet<QString> said_;               // troubles, each of which is said once
    BackgroundJob<ReceptionEnd> job_;
};

}  // namespace macula::viewer
