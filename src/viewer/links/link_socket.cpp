#include "viewer/links/link_socket.h"

#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocalSocket>
#include <QTimer>
#include <algorithm>
#include <cerrno>

#include "base/sha256.h"
#include "study/link/link_text.h"

namespace macula::viewer {

namespace {

namespace fs = std::filesystem;

constexpr int kConnectMs = 1000;
constexpr int kAnswerMs = 3000;  // a window that takes longer to answer hangs
constexpr int kMostWaiting = 8;
constexpr std::size_t kDigitsOfDisplay = 12;
constexpr const char* kTaken = "ok\n";

bool isPrivateFolder(const fs::path& folder) {
    struct stat status {};
    return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid() &&
           (status.st_mode & 077) == 0;
}

// Sockets of one display have names that begin alike.
QString beginOfName() {
    const bool isWayland = QGuiApplication::platformName().startsWith(QLatin1String("wayland"));
    const QByteArray display = qgetenv(isWayland ? "WAYLAND_DISPLAY" : "DISPLAY");
    const std::string digest = sha256Hex(display.toStdString()).substr(0, kDigitsOfDisplay);
    return QStringLiteral("viewer-%1-").arg(QString::fromStdString(digest));
}

bool takes(const QString& socketPath, const QByteArray& message) {
    QLocalSocket socket;
    socket.connectToServer(socketPath);
    if (!socket.waitForConnected(kConnectMs)) {
        // It was killed and left its socket behind.
        if (socket.error() == QLocalSocket::ConnectionRefusedError) QLocalServer::removeServer(socketPath);
        return false;
    }
    socket.write(message);
    QByteArray answer;
    while (!answer.endsWith('\n') && socket.waitForReadyRead(kAnswerMs)) answer += socket.readAll();
    return answer == kTaken;
}

}  // namespace

std::optional<fs::path> linkSocketFolder() {
    const QByteArray runtime = qgetenv("XDG_RUNTIME_DIR");
    if (runtime.isEmpty()) return {};
    const fs::path above = runtime.toStdString();
    if (!above.is_absolute() || !isPrivateFolder(above)) return {};
    const fs::path folder = above / "macula";
    if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return {};
    return isPrivateFolder(folder) ? std::optional(folder) : std::nullopt;
}

LinkServer::LinkServer(QObject* parent) : QObject(parent) {
    const auto folder = linkSocketFolder();
    if (!folder) return;
    server_.setSocketOptions(QLocalServer::UserAccessOption);
    server_.setMaxPendingConnections(kMostWaiting);
    connect(&server_, &QLocalServer::newConnection, this, [this] {
        while (QLocalSocket* socket = server_.nextPendingConnection()) receive(socket);
    });
    const QString path =
        QDir(QString::fromStdString(folder->string())).filePath(beginOfName() + QString::number(getpid()));
    QLocalServer::removeServer(path);  // of an earlier process of this number
    server_.listen(path);
}

void LinkServer::receive(QLocalSocket* socket) {
    connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
    constexpr qint64 kMost = qint64(study::kMostBytesOfLink) + 1;
    socket->setReadBufferSize(kMost + 1);
    QTimer::singleShot(kAnswerMs, socket, [socket] { socket->abort(); });
    const auto read = [this, socket] {
        const QByteArray message = socket->peek(kMost + 1);
        const qsizetype end = message.indexOf('\n');
        if (end < 0 && message.size() <= kMost) return;
        const std::string_view link(message.constData(), std::size_t(std::max<qsizetype>(end, 0)));
        if (end < 0 || !study::isLink(link)) return socket->abort();
        socket->disconnect(this);
        socket->write(kTaken);
        socket->flush();
        socket->disconnectFromServer();
        Q_EMIT linkCame(QString::fromUtf8(message.left(end)));
    };
    connect(socket, &QLocalSocket::readyRead, this, read);
    if (socket->bytesAvailable() > 0) read();
}

bool handOver(const QString& link) {
    const auto folder = linkSocketFolder();
    const QByteArray message = link.toUtf8() + '\n';
    if (!folder || message.size() > qsizetype(study::kMostBytesOfLink) + 1 ||
        link.contains(QLatin1Char('\n')))
        return false;
    const QDir sockets(QString::fromStdString(folder->string()));
    const QStringList filter{beginOfName() + QLatin1Char('*')};
    for (const QFileInfo& each : sockets.entryInfoList(filter, QDir::System | QDir::Files, QDir::Time)) {
        if (takes(each.filePath(), message)) return true;
    }
    return false;
}

}  // namespace macula::viewer
