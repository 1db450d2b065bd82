// What hands do with the lights, in the panel and in the picture.
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <memory>
#include <optional>

#include "scene/lights/edited_rig.h"
#include "viewer/session/viewer_session.h"

namespace macula::viewer {

// Which light is chosen, and how the rig that is seen changes: a rig of the list is never changed, the first
// edit makes an own one of the state. Proposes rigs to the session, which outlives it.
class LightsEditing : public QObject {
    Q_OBJECT

  public:
    explicit LightsEditing(ViewerSession& session, QObject* parent = nullptr);

    // A study is open, and its look has lights.
    bool isUsable() const;
    // That of the state, or the default one of its look. Never null.
    std::shared_ptr<const trace::LightRig> rig() const;
    std::size_t chosen() const;  // 0 where there is no light
    void choose(std::size_t light);
    const trace::SoftLight* light() const;  // the chosen one; null: the rig has none

    // Handles lie over the picture while the panel is open.
    bool hasHandles() const { return isPanelOpen_ && isUsable(); }
    void setPanelOpen(bool open);

    // What the rig is turned by, seen by that eye. Nothing for a camera that is none.
    std::optional<app::LightStand> stand(const Camera& camera) const;
    void setCamera(const Camera& camera) { camera_ = camera; }

    // The chosen light takes these numbers; a drag, until the session's endDrag.
    Result<void> drag(const trace::SoftLight& light);
    void strengthen(double factor);        // likewise, and ends by itself after a pause
    Result<void> setSky(double radiance);  // likewise; what was black becomes grey
    // To what the state had when the drag began; null: the default lights.
    void dragBack(const std::shared_ptr<const trace::LightRig>& lights);
    // One step each.
    Result<void> add();  // a light from above the viewer's left shoulder, and chooses it
    Result<void> remove();
    Result<void> keepTo(trace::LightFrame frame);
    void use(std::shared_ptr<const trace::LightRig> rig);

  signals:
    void changed();  // what panel and picture show of it

  private:
    Result<void> propose(Result<trace::LightRig> rig, bool isDrag);

    ViewerSession& session_;
    Camera camera_;
    std::size_t chosen_ = 0;
    bool isPanelOpen_ = false;
    QTimer wheelEnds_;
};

}  // namespace macula::viewer
