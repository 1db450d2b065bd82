// The program is asked to end from outside: by a terminal, a shutdown, or whoever started it.
#pragma once

#include <QObject>
#include <QSocketNotifier>

namespace macula::viewer {

// While it lives, SIGTERM, SIGINT and SIGHUP are told here, on the UI thread, instead of ending the program
// at once. The second of a kind ends it at once. One at a time.
class QuitSignals : public QObject {
    Q_OBJECT

  public:
    explicit QuitSignals(QObject* parent = nullptr);
    ~QuitSignals() override;  // signals do again what they did before

  signals:
    void asked();

  private:
    void onReadable();

    QSocketNotifier* notifier_ = nullptr;  // null: signals end the program at once
};

}  // namespace macula::viewer
