// Turns signals that end the program into a Qt signal.
#pragma once

#include <QObject>
#include <QSocketNotifier>

namespace macula::viewer {

// While it lives, SIGTERM, SIGINT and SIGHUP emit `asked` on the UI thread instead of ending the program. The
// second signal of a kind ends it at once. Ignored signals stay ignored. One object at a time.
class QuitSignals : public QObject {
    Q_OBJECT

  public:
    explicit QuitSignals(QObject* parent = nullptr);
    ~QuitSignals() override;  // restores the earlier handlers

  Q_SIGNALS:
    void asked();

  private:
    void onReadable();

    QSocketNotifier* notifier_ = nullptr;  // null without a pipe: signals end the program at once
};

}  // namespace macula::viewer
