// One slider from fast to accurate for frames in motion.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <cstddef>
#include <optional>

#include "live/quality/quality_front.h"

namespace macula::viewer {

// A button that names the stop and opens the slider. Its stops are those of the quality front; until a person
// chooses one, the quality is automatic. Shows what a stop costs on this machine in this window. Lives on the
// UI thread.
class QualityControl : public QToolButton {
    Q_OBJECT

  public:
    explicit QualityControl(live::QualityFront front, QWidget* parent = nullptr);

    const live::QualityFront& front() const { return front_; }
    // The frame time of this machine relative to the measuring one; nothing: not known yet.
    void setSlowness(std::optional<double> slowness);
    std::optional<double> slowness() const { return slowness_; }
    void setView(const live::WindowView& view);
    void setBounces(int bounces);  // the current picture's; the slider does not change them

    // Nothing: automatic.
    std::optional<std::size_t> stop() const { return stop_; }
    void setStop(std::optional<std::size_t> stop);
    void step(int by);  // towards the accurate end; the first step ends automatic
    QString words() const { return words_->text(); }  // the cost of the stop

  Q_SIGNALS:
    void changed(const macula::live::LiveQuality& quality);

  private:
    void makePanel();
    void showStop();
    void tell();
    QString wordsOf(const live::FrontPoint& stop) const;
    std::size_t nearestStop() const;

    live::QualityFront front_;
    std::optional<double> slowness_;
    live::WindowView view_;
    int bounces_ = 0;
    std::optional<std::size_t> stop_;
    live::LiveQuality told_;
    QSlider* slider_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    QLabel* words_ = nullptr;
};

}  // namespace macula::viewer
