#include "viewer/documents/private_files.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "base/private_file.h"

namespace macula::viewer {

namespace {

// In memory where the system has such a folder, which ends with the session.
QString parentFolder() {
    const QString runtime = QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation);
    return !runtime.isEmpty() && QFileInfo(runtime).isWritable() ? runtime : QDir::tempPath();
}

}  // namespace

Result<QString> PrivateFiles::write(std::string_view bytes, const QString& suffix) {
    if (!folder_)
        folder_ =
            std::make_unique<QTemporaryDir>(parentFolder() + QStringLiteral("/macula-documents-XXXXXX"));
    if (!folder_->isValid()) {
        folder_.reset();
        return Error{ErrorCode::outputNotWritable,
                     Text("There is no room for a file that another program can open."),
                     {},
                     Text("Save the file to a folder of yours instead.")};
    }
    QString path = folder_->filePath(QStringLiteral("document-%1.%2").arg(++files_).arg(suffix));
    MACULA_TRY_VOID(writeTextPrivately(path.toStdString(), bytes));
    return path;
}

}  // namespace macula::viewer
