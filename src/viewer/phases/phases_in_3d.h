// Phases in the 3D picture: the one that slices show, and the models from which they play.
#pragma once

#include "viewer/viewport/phase_in_3d.h"  // before Qt, see vulkan_window.h

#include <QObject>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>

#include "live/frame/render_events.h"
#include "study/open/opened_study.h"
#include "viewer/context/window_context.h"

namespace macula::viewer {

class PhaseLoader;

// Off until a person switches it on: another volume costs the device seconds on a slow machine, and a 3D
// picture of another phase than the open one is no picture of the study that is saved. While it is on, models
// of all phases are learnt in the background. Lives on the UI thread.
class PhasesIn3d : public QObject {
    Q_OBJECT

  public:
    // `loader` decodes the phases, and outlives this.
    PhasesIn3d(const WindowContext& context, const PhaseLoader& loader, QObject* parent);

    // Another study, or none (`count` 0). Switches this off: 3D shows what is open, once it has it.
    void begin(std::size_t count, std::size_t open);
    void setOn(bool on);
    bool isOn() const { return isOn_; }
    void setLearning(bool learns);  // whether models of phases are learnt while it is on
    // The phase on slices, once it is decoded; null: the open one. `text` says which it is.
    void show(std::size_t phase, std::shared_ptr<const study::OpenedStudy> study, const QString& text);
    void setPlaying(bool plays);
    void loadedMore();  // of the loader: more phases can be learnt
    // Whether the 3D pane shows the phase of show(), or will not show any.
    bool isSeen() const;
    QString note() const;  // how many phases are learnt; empty: nothing to say

  Q_SIGNALS:
    void noteChanged();

  private:
    void onRendered(const live::RenderEvent& event);
    void publish();
    bool isAnother() const { return isOn_ && shown_ != open_; }
    std::vector<std::string> notes() const;
    std::shared_ptr<const live::PhaseScenes> phases();

    WindowContext context_;
    const PhaseLoader& loader_;
    bool isOn_ = false;
    bool learns_ = true;
    bool isPlaying_ = false;
    bool hasFailed_ = false;  // no picture will follow
    std::size_t count_ = 0;
    std::size_t open_ = 0;
    std::size_t shown_ = 0;
    std::shared_ptr<const study::OpenedStudy> study_;  // of shown_; null: the open one
    QString text_;
    std::shared_ptr<const live::PhaseScenes> phases_;  // the last ones: the same list is published again
    std::optional<live::PhaseModelsChanged> models_;
};

}  // namespace macula::viewer
