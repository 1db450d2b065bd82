// Shows the window's study in a headset, on a thread and a device of its own.
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "scene/drawing/drawing.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// The study to show, and the presets that can be chosen there.
struct HeadsetShowRequest {
    std::shared_ptr<const Volume> volume = {};
    scene::Drawing drawing = {};  // complete
    std::vector<std::shared_ptr<const TransferFunction>> presets = {};
    std::filesystem::path pictures = {};  // folder of pictures taken there; empty: none can be taken
};

// A choice made in the headset or in the window.
struct HeadsetSelection {
    std::shared_ptr<const TransferFunction> transferFunction = {};
    std::shared_ptr<const Clip> clip = {};  // null: all of the volume is shown
};

// One XR session at a time. Any failure - no runtime, no headset, a headset unplugged - is reported by
// `failed`; the window keeps working, and another session can start. Lives on the UI thread.
class HeadsetShow : public QObject {
    Q_OBJECT

  public:
    explicit HeadsetShow(QObject* parent);
    ~HeadsetShow() override;  // ends the session and waits for its end

    // Does nothing while a session runs.
    void start(HeadsetShowRequest request);
    void stop();     // `ended` follows
    void abandon();  // stops, and ignores later choices in the headset: they are for another study
    bool isRunning() const { return job_.running(); }
    // Passes the window's choice to the headset.
    void propose(HeadsetSelection choice);

  Q_SIGNALS:
    void began();
    void mirrored(const QImage& leftEye);  // a few times a second; holds no names
    void chosen(const macula::viewer::HeadsetSelection& choice);
    void noted(const QString& sentence);
    void failed(const macula::Error& error);
    void ended(const QString& figures);  // after any end; empty on failure

  private:
    struct Shared;

    BackgroundJob<Text> job_;
    std::shared_ptr<Shared> shared_;
    CancelToken token_;
    bool isAbandoned_ = false;
};

}  // namespace macula::viewer
