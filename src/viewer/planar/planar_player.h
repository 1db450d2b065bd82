// The clock of a loop of images.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace macula::viewer {

// Tells when the next frame is due. A frame that comes late is shown all the same: none is left out. Lives on
// the UI thread.
class PlanarPlayer : public QObject {
    Q_OBJECT

  public:
    explicit PlanarPlayer(QObject* parent = nullptr);

    void start(double firstMs);  // how long the frame on screen still stays
    void stop();
    bool isPlaying() const { return isPlaying_; }
    void holdFor(double ms);  // the frame that was due stays for that long
    void askAgain();          // the frame that was due is not there yet

  Q_SIGNALS:
    void due();

  private:
    void wait();

    bool isPlaying_ = false;
    QTimer timer_;
    QElapsedTimer clock_;
    double dueMs_ = 0.0;  // by the clock
};

}  // namespace macula::viewer
