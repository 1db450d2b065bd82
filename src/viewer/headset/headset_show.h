// The study of the window in a headset, beside the window: on a thread and a device of its own.
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

// What is to be shown, and what may be chosen there.
struct HeadsetWish {
    std::shared_ptr<const Volume> volume = {};
    app::Drawing drawing = {};  // complete
    std::vector<std::shared_ptr<const TransferFunction>> presets = {};
    std::filesystem::path pictures = {};  // where those that are taken go; empty: none can be
};

// What hands have chosen in the room, or somebody in the window.
struct HeadsetChoice {
    std::shared_ptr<const TransferFunction> transferFunction = {};
    std::shared_ptr<const Clip> clip = {};  // null: all of the volume is shown
};

// One session at a time. Everything may go wrong there - no software of a headset, no headset, one that is
// unplugged - and is told in a sentence; the window goes on, and another session can be begun. Lives on the
// UI thread.
class HeadsetShow : public QObject {
    Q_OBJECT

  public:
    explicit HeadsetShow(QObject* parent);
    ~HeadsetShow() override;  // ends the session, and waits for that

    // Nothing happens while a session is there.
    void start(HeadsetWish wish);
    void stop();     // `ended` is told when it has
    void abandon();  // the same, and what is chosen there counts no more: it is of another study
    bool isRunning() const { return job_.running(); }
    // What was chosen in the window meanwhile.
    void propose(HeadsetChoice choice);

  signals:
    void began();
    void mirrored(const QImage& leftEye);  // a few times a second; holds no names
    void chosen(const macula::viewer::HeadsetChoice& choice);
    void noted(const QString& sentence);
    void failed(const macula::Error& error);
    void ended(const QString& figures);  // whatever it ended by; empty where it failed

  private:
    struct Shared;

    BackgroundJob<std::string> job_;
    std::shared_ptr<Shared> shared_;
    CancelToken token_;
    bool isAbandoned_ = false;
};

}  // namespace macula::viewer
