// One slider from fast to accurate: how frames in motion are made.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <cstddef>
#include <optional>

#include "live/quality/quality_front.h"

namespace macula::viewer {

// A button that tells the stop, and opens the slider. Its stops are those of the front; until somebody
// chooses one, the window does by itself what there is time for. What a stop costs is told for this machine
// and this window. Lives on the UI thread.
class QualityControl : public QToolButton {
    Q_OBJECT

  public:
    explicit QualityControl(app::QualityFront front, QWidget* parent = nullptr);

    const app::QualityFront& front() const { return front_; }
    // How many times as long this machine takes as the one that measured; nothing: not known yet.
    void setSlowness(std::optional<double> slowness);
    std::optional<double> slowness() const { return slowness_; }
    void setView(const app::WindowView& view);
    void setBounces(int bounces);  // of what is shown: the slider leaves them alone

    // Nothing: by itself.
    std::optional<std::size_t> stop() const { return stop_; }
    void setStop(std::optional<std::size_t> stop);
    void step(int by);  // towards the accurate end; the first one leaves what the window does by itself
    QString words() const { return words_->text(); }  // that say what the stop costs

  signals:
    void changed(const macula::app::LiveQuality& quality);

  private:
    void makePanel();
    void showStop();
    void tell();
    QString wordsOf(const app::FrontPoint& stop) const;
    std::size_t nearestStop() const;

    app::QualityFront front_;
    std::optional<double> slowness_;
    app::WindowView view_;
    int bounces_ = 0;
    std::optional<std::size_t> stop_;
    app::LiveQuality told_;
    QSlider* slider_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    QLabel* words_ = nullptr;
};

}  // namespace macula::viewer
