// The options that macula-viewer and macula-viewer-bench share.
#pragma once

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <optional>

#include "base/result.h"
#include "viewer/program/command_line.h"

namespace macula::viewer {

class ViewerOptions {
  public:
    // Who uses the window. A script measures: it begins anew and keeps nothing, unless it is told where.
    enum class User { person, script };

    ViewerOptions(const char* program, User user);

    // FOLDER, the options, --help and --version.
    void addTo(QCommandLineParser& parser) const;
    // The text that --help or --version asks for.
    std::optional<QString> textAskedFor(const QCommandLineParser& parser) const;
    // `folders` are the arguments that are no options: paths, or a link. Fails with usage.
    Result<CommandLine> read(const QCommandLineParser& parser, const QStringList& folders) const;
    // What is told in the terminal, in English. Without a hint it points to --help.
    Error usage(const QString& message, const QString& hint = {}) const;

  private:
    Result<void> readPanes(const QCommandLineParser& parser, CommandLine& result) const;
    Result<void> readSessions(const QCommandLineParser& parser, CommandLine& result) const;
    Result<QString> pathOf(const QString& given) const;
    Result<QSize> parseSize(const QString& text) const;
    Result<int> parseDays(const QString& source, const QString& text) const;

    QString program_;
    User user_;

    const QCommandLineOption preset_{"preset", "What is seen, e.g. ct-bone.", "NAME"};
    const QCommandLineOption lights_{"lights", "Where the light comes from, e.g. studio.", "NAME"};
    const QCommandLineOption view_{"view",
                                   "Looked at from anterior, posterior, left, right, superior, inferior, "
                                   "oblique, three-quarter or turned (default: by what was scanned).",
                                   "DIRECTION"};
    const QCommandLineOption device_{"device", "Index or part of the name of the Vulkan device.", "NAME"};
    const QCommandLineOption size_{
        "size", "Of the 3D picture in pixels, e.g. 800x600; of the window, where slices are shown.", "WxH"};
    const QCommandLineOption layout_;
    const QCommandLineOption language_;
    const QCommandLineOption highContrast_{"high-contrast", "Black, white and yellow."};
    const QCommandLineOption fontScale_{"font-scale", "Times the size of the desktop's letters, 0.8 to 2.",
                                        "X", "1"};
    const QCommandLineOption samples_{"spp", "Samples per pixel of a converged picture.", "N", "512"};
    const QCommandLineOption noModel_{
        "no-model", "Small traced pictures while a hand moves, instead of the preview of a model."};
    const QCommandLineOption sessions_{
        "sessions", "Where models, and how studies were left, are kept for the next time.", "FOLDER"};
    const QCommandLineOption noSession_{"no-session", "Keep nothing, and begin anew."};
    const QCommandLineOption keepDays_{
        "keep-days",
        "Before anything is opened, delete what is kept of studies that were not opened for N days. "
        "Default: MACULA_KEEP_DAYS of the environment, else nothing is deleted.",
        "N"};
};

}  // namespace macula::viewer
