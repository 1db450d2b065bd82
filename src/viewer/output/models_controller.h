// Saves the window's peripheral model as a file.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>

#include "live/frame/render_events.h"
#include "live/model/model_to_write.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

class WorkBar;

// Waits for the model from the render thread, then writes it to a file in the background. One at a time.
// Lives on the UI thread.
class ModelExport : public QObject {
    Q_OBJECT

  public:
    explicit ModelExport(QObject* parent = nullptr);

    struct Request {
        std::filesystem::path path;
        bool displayColours = false;
        std::shared_ptr<const Volume> volume{};  // both as they were when a person asked for the file
        scene::Drawing drawing{};
    };
    // `number` is FrameInput::modelRequests of the request.
    void expect(Request request, std::uint64_t number);
    void onTaken(const live::ModelSnapshot& taken);
    void cancel();
    bool running() const { return expected_ != 0 || job_.running(); }

  Q_SIGNALS:
    void began();
    void ended();
    void written(const QString& told);
    void failed(const macula::Error& error);

  private:
    void forgetStudy();

    Request request_;             // has volume and drawing only while the model is expected
    std::uint64_t expected_ = 0;  // 0: none
    BackgroundJob<std::size_t> job_;
};

// Lives on the UI thread.
class ModelsController : public QObject {
    Q_OBJECT

  public:
    explicit ModelsController(const WindowContext& context);

    WorkBar* bar() const { return bar_; }
    void addActions(QMenu& file);

    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel();

  Q_SIGNALS:
    void written();

  private:
    void askWhereToSave();

    WindowContext context_;
    ModelExport* export_;
    WorkBar* bar_;
};

}  // namespace macula::viewer
