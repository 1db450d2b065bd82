// Quits the program, but finishes the files that are being written first, unless a person says otherwise.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

#include "viewer/context/window_context.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

// Lives on the UI thread.
class QuitController : public QObject {
    Q_OBJECT

  public:
    explicit QuitController(const WindowContext& context);

    // Quitting waits for the files of `writer`, which must outlive the window's last question. A writer with
    // kKeepsRest loses none of them.
    template <class Writer>
    void waitFor(Writer& writer) {
        bool keepsRest = false;
        if constexpr (requires { Writer::kKeepsRest; }) keepsRest = true;
        writers_.push_back(
            {[&writer] { return writer.unfinished(); }, [&writer] { writer.cancel(); }, keepsRest});
        connect(&writer, &Writer::written, this, &QuitController::quitIfDone);
        if constexpr (requires { writer.bar(); })
            connect(writer.bar(), &WorkBar::cancelClicked, this, &QuitController::stay);
    }

    QStringList unfinished() const;  // sentences: work that quitting would lose
    // Whether the window may close now. If something is being written it returns false, and asks without
    // blocking.
    bool mayClose();

  private:
    struct Writing {
        std::function<QString()> unfinished;
        std::function<void()> cancel;
        bool keepsRest = false;
    };
    QString ifQuitNow() const;
    void quitIfDone();
    void stay() { quitsWhenDone_ = false; }

    WindowContext context_;
    std::vector<Writing> writers_;
    bool quitsWhenDone_ = false;
};

}  // namespace macula::viewer
