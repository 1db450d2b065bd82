// Measures how long the event loop of the user interface was blocked.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace macula::viewer {

// A timer on the UI thread fires every 5 ms; when it is late, other work held up the event loop, and clicks
// would have waited as long.
class UiHeartbeat : public QObject {
    Q_OBJECT

  public:
    explicit UiHeartbeat(QObject* parent = nullptr);

    void start();
    void stop();
    // The longest hold-up since start(), beyond the interval itself.
    double longestStallMs() const { return longestMs_; }
    // The processor time of this thread in that hold-up; for the rest of it the thread waited, for a core or
    // for something else. 0 on systems other than Linux.
    double ownWorkInItMs() const { return ownWorkInItMs_; }
    // How often a hold-up was longer than a person notices.
    static constexpr double kNoticedMs = 50.0;
    long noticed() const { return noticed_; }
    long beats() const { return beats_; }

  private:
    void beat();

    QTimer timer_;
    QElapsedTimer sinceLast_;
    double longestMs_ = 0.0;
    double ownWorkInItMs_ = 0.0;
    double ownWorkMs_ = 0.0;  // processor time of this thread at the last beat
    long noticed_ = 0;
    long beats_ = 0;
};

}  // namespace macula::viewer
