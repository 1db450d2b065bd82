#include "viewer/program/viewer_options.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QUrl>

#include "pipeline/trace/settings.h"
#include "scene/camera/view_directions.h"
#include "study/link/link_text.h"
#include "viewer/keys/keys.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr int kLargestEdge = trace::kMaxPictureSide;
constexpr int kSmallestEdge = 160;
constexpr const char* kKeepDaysVariable = "MACULA_KEEP_DAYS";

std::optional<scene::Layout> layoutOf(const QString& text) {
    for (const LayoutRow& row : kLayouts) {
        if (text.toStdString() == nameOf(row.layout)) return row.layout;
    }
    return std::nullopt;
}

}  // namespace

ViewerOptions::ViewerOptions(const char* program, User user)
    : program_(QLatin1String(program)),
      user_(user),
      layout_("layout",
              user == User::person
                  ? "Which panes: fourPanes, volume, axial, coronal or sagittal."
                  : "Which panes: fourPanes, volume, axial, coronal or sagittal; else volume for orbit and "
                    "changes.",
              "NAME", "fourPanes"),
      language_("language",
                user == User::person ? "Of the window: en or de; else that of the desktop."
                                     : "Of the window: en or de; else English.",
                "CODE") {}

void ViewerOptions::addTo(QCommandLineParser& parser) const {
    parser.addPositionalArgument(
        QStringLiteral("FOLDER"),
        QStringLiteral("A folder with DICOM files, or a file: one of its images, its "
                       "DICOMDIR, an imaging manifest, a ZIP, tar or ISO 9660 file with studies, or NIfTI, "
                       "NRRD or MetaImage; or a link, "
                       "macula://open?study=UID."),
        QStringLiteral("[FOLDER]"));
    parser.addOptions({preset_, lights_, view_, device_, size_, layout_, language_, highContrast_, fontScale_,
                       samples_, noModel_, sessions_, noSession_, keepDays_});
    parser.addHelpOption();
    parser.addVersionOption();
}

std::optional<QString> ViewerOptions::textAskedFor(const QCommandLineParser& parser) const {
    // Before there is a QCoreApplication, Qt does not know the name.
    if (parser.isSet(QStringLiteral("help")))
        return parser.helpText().replace(QLatin1String("<executable_name>"), program_);
    if (parser.isSet(QStringLiteral("version")))
        return QStringLiteral("%1 %2\n").arg(program_, QCoreApplication::applicationVersion());
    return std::nullopt;
}

Error ViewerOptions::usage(const QString& message, const QString& hint) const {
    const QString next = hint.isEmpty() ? QStringLiteral("Run %1 --help.").arg(program_) : hint;
    return {ErrorCode::usage, Text::verbatim(message.toStdString()), {}, Text::verbatim(next.toStdString())};
}

// Desktops pass files as addresses where a program takes links too.
Result<QString> ViewerOptions::pathOf(const QString& given) const {
    if (!given.startsWith(QLatin1String("file:"), Qt::CaseInsensitive)) return given;
    const QUrl address(given, QUrl::StrictMode);
    const bool isHere = address.host().isEmpty() || address.host() == QLatin1String("localhost");
    if (!address.isValid() || !isHere || !address.path().startsWith(QLatin1Char('/')) || address.hasQuery() ||
        address.hasFragment())
        return usage(QStringLiteral("The address of a file is none of this machine."),
                     "Give the path of the folder or file.");
    return address.path(QUrl::FullyDecoded);
}

Result<QSize> ViewerOptions::parseSize(const QString& text) const {
    static const QRegularExpression pattern(QStringLiteral("^(\\d{1,5})x(\\d{1,5})$"));
    const QRegularExpressionMatch match = pattern.match(text);
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    if (!match.hasMatch() || size.width() < kSmallestEdge || size.height() < kSmallestEdge ||
        size.width() > kLargestEdge || size.height() > kLargestEdge) {
        return usage(QStringLiteral("'%1' is not a size.").arg(text), "Write it like 800x600.");
    }
    return size;
}

Result<int> ViewerOptions::parseDays(const QString& source, const QString& text) const {
    bool isNumber = false;
    const int days = text.toInt(&isNumber);
    if (!isNumber || days < 1 || days > kMostKeptDays)
        return usage(QStringLiteral("%1 is '%2', which is not a number of days.").arg(source, text),
                     "Give a whole number from 1 to 36500; without one nothing is deleted by itself.");
    return days;
}

Result<CommandLine> ViewerOptions::read(const QCommandLineParser& parser, const QStringList& folders) const {
    CommandLine result;
    if (folders.size() > 1) return usage(QStringLiteral("Only one folder or link can be opened at a time."));
    if (!folders.isEmpty() && study::isLink(folders.front().toStdString())) {
        if (user_ == User::script) return usage(QStringLiteral("A script opens no links."), "Give a folder.");
        result.link = folders.front();
    } else if (!folders.isEmpty()) {
        MACULA_TRY(result.folder, pathOf(folders.front()));
    }
    result.isAlone = parser.optionNames().isEmpty();
    result.preset = parser.value(preset_);
    result.lights = parser.value(lights_);
    result.device = parser.value(device_);
    result.choosesView = parser.isSet(preset_) || parser.isSet(lights_) || parser.isSet(view_);
    bool isNumber = false;
    result.samples = parser.value(samples_).toUInt(&isNumber);
    if (!isNumber || result.samples == 0)
        return usage(QStringLiteral("'%1' is not a number of samples.").arg(parser.value(samples_)));
    result.usesModel = !parser.isSet(noModel_);
    MACULA_TRY_VOID(readPanes(parser, result));
    MACULA_TRY_VOID(readSessions(parser, result));
    return result;
}

// How the window looks, and from where its volume is looked at.
Result<void> ViewerOptions::readPanes(const QCommandLineParser& parser, CommandLine& result) const {
    if (parser.isSet(view_)) {
        result.view = scene::viewDirectionOf(parser.value(view_).toStdString());
        if (!result.view)
            return usage(QStringLiteral("There is no view '%1'.").arg(parser.value(view_)),
                         "The views are anterior, posterior, left, right, superior, inferior, oblique, "
                         "three-quarter and turned.");
    }
    if (parser.isSet(size_)) {
        MACULA_TRY(result.size, parseSize(parser.value(size_)));
    }
    const auto layout = layoutOf(parser.value(layout_));
    if (!layout)
        return usage(QStringLiteral("There is no layout '%1'.").arg(parser.value(layout_)),
                     "The layouts are fourPanes, volume, axial, coronal and sagittal.");
    result.layout = *layout;
    result.choosesLayout = parser.isSet(layout_);
    if (parser.isSet(language_)) {
        result.language = languageOf(parser.value(language_));
        if (!result.language)
            return usage(QStringLiteral("There is no language '%1'.").arg(parser.value(language_)),
                         "The languages are en and de.");
    }
    result.highContrast = parser.isSet(highContrast_);
    result.choosesFontScale = parser.isSet(fontScale_);
    bool isNumber = false;
    result.fontScale = parser.value(fontScale_).toDouble(&isNumber);
    if (!isNumber || !(result.fontScale >= kSmallestFontScale && result.fontScale <= kLargestFontScale))
        return usage(QStringLiteral("'%1' is not a scale of letters.").arg(parser.value(fontScale_)),
                     "Write 0.8 to 2.");
    return {};
}

// What is kept for the next time, where, and for how long.
Result<void> ViewerOptions::readSessions(const QCommandLineParser& parser, CommandLine& result) const {
    if (parser.isSet(sessions_)) result.sessions = parser.value(sessions_);
    if (result.sessions && (result.sessions->isEmpty() || parser.isSet(noSession_)))
        return usage(QStringLiteral("--sessions needs a folder, and does not go with --no-session."));
    result.keepsStudies = !parser.isSet(noSession_) && (result.sessions || user_ == User::person);
    const QString preset = qEnvironmentVariable(kKeepDaysVariable);
    if (parser.isSet(keepDays_)) {
        if (!result.keepsStudies)
            return usage(QStringLiteral("--keep-days does nothing where nothing is kept."),
                         user_ == User::person ? "Leave --no-session out." : "Say --sessions FOLDER.");
        MACULA_TRY(result.keepDays, parseDays(QStringLiteral("--keep-days"), parser.value(keepDays_)));
    } else if (result.keepsStudies && !preset.isEmpty()) {
        MACULA_TRY(result.keepDays, parseDays(QLatin1String(kKeepDaysVariable), preset));
    }
    return {};
}

}  // namespace macula::viewer
