// Measures how well the picture follows while a hand turns the volume.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <cstdint>
#include <vector>

namespace macula::viewer {

class OrbitGauge : public QObject {
    Q_OBJECT

  public:
    explicit OrbitGauge(MainWindow& window, QObject* parent = nullptr);

    void begin();
    void end();
    double framesPerSecond() const;  // 0 before it has ended
    // "width" and "height" of the picture, "seconds", "frames", "framesPerSecond", "modelFrames" (of splats,
    // with all pixels), "latencyMedianMs", "latency95thMs".
    QJsonObject toJson() const;

  private:
    void onFrame(const live::FrameShown& frame);

    MainWindow& window_;
    bool isRunning_ = false;
    QElapsedTimer since_;
    double seconds_ = 0.0;
    std::uint64_t lastInput_ = 0;
    std::size_t ofModel_ = 0;
    QSize size_;
    std::vector<double> latenciesMs_;
};

}  // namespace macula::viewer
