// Writes the window's peripheral model to a file in the background.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>

#include "live/frame/render_events.h"
#include "live/model/model_to_write.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// Waits for the model from the render thread, then writes it. One at a time. Lives on the UI thread.
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

}  // namespace macula::viewer
