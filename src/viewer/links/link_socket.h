// Hands links on to the window that is there already, so that a RIS does not open one window for each study.
#pragma once

#include <QLocalServer>
#include <QObject>
#include <QString>
#include <filesystem>
#include <optional>

namespace macula::viewer {

// The folder of the sockets, which nobody but the user can enter: macula in $XDG_RUNTIME_DIR. Nothing where
// that is not set, or is not such a folder; then each link opens a window.
std::optional<std::filesystem::path> linkSocketFolder();

// Listens for links of this user's programs on this display. A message is one link and a line end, at most
// study::kMostBytesOfLink long; anything else is dropped unanswered. Whoever hears a link must ask before it
// does what the link says: any web page can make one. Lives on the UI thread.
class LinkServer : public QObject {
    Q_OBJECT

  public:
    explicit LinkServer(QObject* parent = nullptr);

    bool isListening() const { return server_.isListening(); }

  Q_SIGNALS:
    void linkCame(const QString& link);

  private:
    void receive(QLocalSocket* socket);

    QLocalServer server_;
};

// Hands the link to the newest window of this user on this display. False where there is none, or none that
// answers. Needs the application.
bool handOver(const QString& link);

}  // namespace macula::viewer
