#include "viewer/language/core_words.h"

#include <QFile>
#include <QHash>
#include <QList>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <QXmlStreamReader>
#include <algorithm>
#include <optional>

namespace macula::viewer {

namespace {

constexpr qsizetype kMostRemembered = 512;  // a picture in motion says the same again and again
constexpr int kMostNested = 3;              // a reason within a sentence within a sentence

// A sentence with places that a program has filled in.
struct Pattern {
    QRegularExpression source;
    QList<int> places;  // the number of the place that each group stands for
    QString translation;
    qsizetype fixedLetters = 0;
    bool keepsPlaces = false;  // text of a file stands there
};

struct Words {
    QHash<QString, QString> titles;
    QHash<QString, QString> pieces;  // single words, which mean that only within a sentence
    QHash<QString, QString> exact;
    QList<Pattern> patterns;  // the one that says most by itself first
    QHash<QString, QString> remembered;
    QString decimalSign = QStringLiteral(".");
};

Words& words() {
    static Words known;
    return known;
}

const QRegularExpression& placePattern() {
    static const QRegularExpression pattern(QStringLiteral("%([1-9])"));
    return pattern;
}

// What stands at a place does not go on over the end of a sentence, unless it is the last.
std::optional<Pattern> patternOf(const QString& source, const QString& translation) {
    Pattern pattern{.translation = translation};
    QString expression;
    qsizetype from = 0;
    auto matches = placePattern().globalMatch(source);
    if (!matches.hasNext()) return std::nullopt;
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        const QString fixed = source.mid(from, match.capturedStart() - from);
        expression += QRegularExpression::escape(fixed);
        pattern.fixedLetters += fixed.size();
        from = match.capturedEnd();
        expression +=
            from == source.size() ? QStringLiteral("(.+)") : QStringLiteral("((?:(?![.?!] [A-Z]).)*?)");
        pattern.places << match.captured(1).toInt();
    }
    expression += QRegularExpression::escape(source.mid(from));
    pattern.fixedLetters += source.size() - from;
    pattern.source = QRegularExpression(QRegularExpression::anchoredPattern(expression),
                                        QRegularExpression::DotMatchesEverythingOption);
    return pattern;
}

void add(Words& known, const QString& source, const QString& translation, bool keepsPlaces) {
    if (source.isEmpty() || translation.isEmpty()) return;
    if (auto pattern = patternOf(source, translation)) {
        pattern->keepsPlaces = keepsPlaces;
        known.patterns << *std::move(pattern);
    } else {
        known.exact.insert(source, translation);
    }
}

QString translated(const QString& text, int depth);

QString filledIn(const Pattern& pattern, const QRegularExpressionMatch& match, int depth) {
    static const QRegularExpression isNumber(QStringLiteral("^-?\\d+\\.\\d+$"));
    QString text;
    qsizetype from = 0;
    auto places = placePattern().globalMatch(pattern.translation);
    while (places.hasNext()) {
        const QRegularExpressionMatch place = places.next();
        text += pattern.translation.mid(from, place.capturedStart() - from);
        from = place.capturedEnd();
        const qsizetype group = pattern.places.indexOf(place.captured(1).toInt());
        if (group < 0) continue;  // translation_test.cpp finds such
        const QString said = match.captured(int(group) + 1);
        if (pattern.keepsPlaces) {
            text += said;
        } else {
            text += isNumber.match(said).hasMatch() ? withLocalNumbers(said) : translated(said, depth + 1);
        }
    }
    return text + pattern.translation.mid(from);
}

std::optional<QString> asAWhole(const QString& text, int depth) {
    const Words& known = words();
    if (const auto found = known.exact.constFind(text); found != known.exact.constEnd()) return *found;
    if (depth > 0) {
        if (const auto piece = known.pieces.constFind(text); piece != known.pieces.constEnd()) return *piece;
    }
    for (const Pattern& pattern : known.patterns) {
        const QRegularExpressionMatch match = pattern.source.match(text);
        if (match.hasMatch()) return filledIn(pattern, match, depth);
    }
    return std::nullopt;
}

QString translated(const QString& text, int depth) {
    if (depth > kMostNested) return text;
    const QString plain = text.trimmed();  // pieces of a sentence begin with a space
    if (plain.isEmpty()) return text;
    const auto at = text.indexOf(plain);
    const QString before = text.left(at);
    const QString after = text.mid(at + plain.size());
    if (const auto whole = asAWhole(plain, depth)) return before + *whole + after;
    static const QRegularExpression sentenceEnds(QStringLiteral("(?<=[.?!]) (?=[A-Z])"));
    QStringList sentences = plain.split(sentenceEnds);
    if (sentences.size() < 2) return text;
    for (QString& sentence : sentences) sentence = translated(sentence, depth + 1);
    return before + sentences.join(QLatin1Char(' ')) + after;
}

QString joined(const std::string& first, const std::string& second) {
    const QString one = inWindowsLanguage(first);
    const QString two = inWindowsLanguage(second);
    return one.isEmpty() || two.isEmpty() ? one + two : one + QLatin1Char(' ') + two;
}

}  // namespace

void useCoreWords(const QString& path) {
    Words& known = words();
    known = {};
    known.decimalSign = QLocale().decimalPoint();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return;
    QXmlStreamReader xml(&file);
    QString context;
    QString source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("source")) {
            source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            // "unfinished", "vanished" or "obsolete": nobody stands by it.
            const bool isDone = !xml.attributes().hasAttribute(QLatin1String("type"));
            const QString translation = xml.readElementText();
            if (!isDone) continue;
            if (context == QLatin1String("titles")) {
                known.titles.insert(source, translation);
            } else if (context == QLatin1String("pieces")) {
                known.pieces.insert(source, translation);
            } else {
                add(known, source, translation, context == QLatin1String("labels"));
            }
        }
    }
    std::ranges::stable_sort(known.patterns, std::ranges::greater(), &Pattern::fixedLetters);
}

QString inWindowsLanguage(const QString& text) {
    Words& known = words();
    if (known.exact.isEmpty() && known.patterns.isEmpty()) return text;
    if (const auto found = known.remembered.constFind(text); found != known.remembered.constEnd())
        return *found;
    if (known.remembered.size() >= kMostRemembered) known.remembered.clear();
    return *known.remembered.insert(text, translated(text, 0));
}

QString inWindowsLanguage(const std::string& text) {
    return inWindowsLanguage(QString::fromStdString(text));
}

QString listInWindowsLanguage(const std::string& facts, const QString& between) {
    QStringList all = QString::fromStdString(facts).split(between);
    for (QString& fact : all) fact = asAWhole(fact, 0).value_or(fact);
    return all.join(between);
}

QString titleInWindowsLanguage(const std::string& title) {
    const QString whole = QString::fromStdString(title);
    // "CT-Bone (edited 2)": see scene::ownCopy.
    static const QRegularExpression edited(QStringLiteral("^(.+) \\(edited( \\d+)?\\)$"));
    const QHash<QString, QString>& titles = words().titles;
    const QRegularExpressionMatch copy = edited.match(whole);
    if (!copy.hasMatch()) return titles.value(whole, whole);
    const QString mark = titles.value(QStringLiteral("edited"), QStringLiteral("edited"));
    const QString of = copy.captured(1);
    return QStringLiteral("%1 (%2%3)").arg(titles.value(of, of), mark, copy.captured(2));
}

QString inWindowsLanguage(const Error& error) {
    return joined(error.message, error.hint);
}

QString inWindowsLanguage(const Message& message) {
    return joined(message.sentence, message.action);
}

QString withLocalNumbers(QString text) {
    const QString& sign = words().decimalSign;
    if (sign == QLatin1String(".")) return text;
    static const QRegularExpression point(QStringLiteral("(?<=\\d)\\.(?=\\d)"));
    return text.replace(point, sign);
}

}  // namespace macula::viewer
