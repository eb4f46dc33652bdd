#include "lessons/api/listing.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QHash>
#include <QTranslator>

#include <algorithm>
#include <stdexcept>

namespace lessons {

namespace {

const QString wholeFrame = QStringLiteral("frame");
const QString gapBegin = QStringLiteral("//>");
const QString gapEnd = QStringLiteral("//<");
const QString commentSign = QStringLiteral("// ");
const QString translations = QStringLiteral(":/i18n/");
constexpr auto commentContext = "listing"; ///< of comments in the translations
constexpr qsizetype indentOfFunction = 4;
constexpr qsizetype commentWidth = 38; ///< characters: fits into the code panel of a window of 1280 px

struct ListingText
{
    Q_DECLARE_TR_FUNCTIONS(ListingText)
};

[[noreturn]] void rejectLine(int line, const QString &why)
{
    throw std::runtime_error(ListingText::tr("line %1: %2").arg(line).arg(why).toStdString());
}

/// Returns the lines of `text`. The part after the last line break is a line if it is not empty.
QStringList linesOf(const QString &text)
{
    QStringList lines = text.split('\n');
    if (lines.back().isEmpty())
        lines.pop_back();
    return lines;
}

/// Returns `lines` as a text in which each line ends with a line break.
QString textOf(const QStringList &lines)
{
    return lines.isEmpty() ? QString() : lines.join('\n') + '\n';
}

qsizetype indentOf(const QString &line)
{
    const auto isSpace = [](QChar c) { return c == ' '; };
    return std::find_if_not(line.begin(), line.end(), isSpace) - line.begin();
}

/// Returns the indentation that all lines with text share.
qsizetype sharedIndent(const QStringList &lines)
{
    qsizetype shared = -1;
    for (const QString &line : lines) {
        if (!line.trimmed().isEmpty())
            shared = shared < 0 ? indentOf(line) : std::min(shared, indentOf(line));
    }
    return std::max<qsizetype>(0, shared);
}

qsizetype indentOfGap(const QStringList &lines, const Gap &gap)
{
    return sharedIndent(lines.mid(gap.firstLine - 1, gap.lineCount));
}

/// Returns `text` as a comment, with further line breaks between words.
QStringList asComment(const QString &text)
{
    QStringList lines;
    for (const QString &paragraph : linesOf(text)) {
        QString line;
        for (const QString &word : paragraph.split(' ')) {
            if (!line.isEmpty() && line.size() + 1 + word.size() > commentWidth) {
                lines << commentSign + line;
                line.clear();
            }
            line += line.isEmpty() ? word : ' ' + word;
        }
        lines << commentSign + line;
    }
    return lines;
}

/// Returns the index of the first letter of a comment in `line`, or the length of the line.
qsizetype beginOfComment(const QString &line)
{
    const qsizetype sign = line.indexOf(commentSign);
    return sign < 0 ? line.size() : sign + commentSign.size();
}

QStringList commentsIn(const QString &text)
{
    QStringList comments;
    for (const QString &line : text.split('\n')) {
        const QString comment = line.mid(beginOfComment(line));
        if (!comment.isEmpty() && !comments.contains(comment))
            comments << comment;
    }
    return comments;
}

/// Returns `text` with the comments that `replacements` has replaced by those there.
QString withComments(const QString &text, const QHash<QString, QString> &replacements)
{
    QStringList lines = text.split('\n');
    for (QString &line : lines) {
        const qsizetype begin = beginOfComment(line);
        const QString comment = line.mid(begin);
        line = line.left(begin) + replacements.value(comment, comment);
    }
    return lines.join('\n');
}

/// Returns for each of `comments` the one in the language of the window.
QHash<QString, QString> translated(const QStringList &comments)
{
    QHash<QString, QString> all;
    for (const QString &comment : comments)
        all.insert(comment, QCoreApplication::translate(commentContext, comment.toUtf8().constData()));
    return all;
}

}

bool CodeTask::isWholeFrame() const
{
    return id == wholeFrame;
}

const Gap *Listing::gap(const QString &id) const
{
    const auto found = std::find_if(gaps.begin(), gaps.end(), [&](const Gap &one) { return one.id == id; });
    return found == gaps.end() ? nullptr : &*found;
}

QString Listing::solution(const QString &id) const
{
    if (id == wholeFrame)
        return text;
    const Gap *place = gap(id);
    if (!place)
        return {};
    QStringList lines = linesOf(text).mid(place->firstLine - 1, place->lineCount);
    const qsizetype indent = sharedIndent(lines);
    for (QString &line : lines)
        line = line.mid(indent);
    return textOf(lines);
}

QString Listing::with(const QString &id, const QString &code) const
{
    if (id == wholeFrame)
        return code;
    const Gap *place = gap(id);
    if (!place)
        return text;
    const QStringList lines = linesOf(text);
    const QString indent(indentOfGap(lines, *place), ' ');
    QStringList result = lines.mid(0, place->firstLine - 1);
    for (const QString &line : linesOf(code))
        result << (line.isEmpty() ? line : indent + line);
    result << lines.mid(place->firstLine - 1 + place->lineCount);
    return textOf(result);
}

QString Listing::emptied(const CodeTask &task) const
{
    const QStringList comment = asComment(task.comment);
    if (task.isWholeFrame())
        return textOf(comment + QStringList{"void frame()", "{", QString(indentOfFunction, ' '), "}"});
    const Gap *place = gap(task.id);
    if (!place)
        return text;
    QStringList lines = linesOf(with(task.id, textOf(comment)));
    lines.insert(lineToWrite(task) - 1, QString(indentOfGap(linesOf(text), *place), ' '));
    return textOf(lines);
}

int Listing::lineToWrite(const CodeTask &task) const
{
    const auto commentLines = static_cast<int>(asComment(task.comment).size());
    if (task.isWholeFrame())
        return commentLines + 3; // behind the head of the function and its brace
    const Gap *place = gap(task.id);
    return place ? place->firstLine + commentLines : 0;
}

QString Listing::inLanguageOfWindow(const QString &code) const
{
    if (code == text || comments.isEmpty() || !code.contains(commentSign))
        return code;
    const QHash<QString, QString> ofWindow = translated(comments);
    QHash<QString, QString> ofAny = ofWindow;
    for (const QString &file :
         QDir(translations).entryList({lesson + QStringLiteral("_*.qm")}, QDir::Files)) {
        QTranslator language;
        if (!language.load(translations + file))
            continue;
        for (const QString &comment : comments) {
            const QString other = language.translate(commentContext, comment.toUtf8().constData());
            if (!other.isEmpty())
                ofAny.insert(other, ofWindow.value(comment));
        }
    }
    return withComments(code, ofAny);
}

Listing parseListing(const QString &source)
{
    Listing listing;
    QStringList kept;
    bool isInGap = false;
    int number = 0;
    for (const QString &line : linesOf(source)) {
        ++number;
        const QString trimmed = line.trimmed();
        if (trimmed.startsWith(gapBegin)) {
            const QString id = trimmed.mid(gapBegin.size()).trimmed();
            if (isInGap)
                rejectLine(
                    number,
                    ListingText::tr("this gap begins inside another one. Write “//<” where that one ends."));
            if (id.isEmpty() || id == wholeFrame || listing.gap(id))
                rejectLine(number,
                           ListingText::tr("a gap needs an id that no other gap has. Write it after “//>”."));
            listing.gaps.push_back({id, static_cast<int>(kept.size()) + 1, 0});
            isInGap = true;
        } else if (trimmed == gapEnd) {
            if (!isInGap)
                rejectLine(
                    number,
                    ListingText::tr("no gap begins before this “//<”. Write “//> id” there, or remove it."));
            Gap &gap = listing.gaps.back();
            gap.lineCount = static_cast<int>(kept.size()) + 1 - gap.firstLine;
            if (gap.lineCount == 0)
                rejectLine(number, ListingText::tr(
                                       "the gap has no code. Write it above this line, or remove the gap."));
            isInGap = false;
        } else {
            kept << line;
        }
    }
    if (isInGap)
        rejectLine(number, ListingText::tr("the last gap has no end. Write “//<” after its code."));
    listing.text = textOf(kept);
    return listing;
}

Listing readListing(const QString &lesson, const QString &step)
{
    QFile file(QStringLiteral(":/listings/%1/%2.code").arg(lesson, step));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    Listing listing = parseListing(QString::fromUtf8(file.readAll()));
    listing.lesson = lesson;
    listing.comments = commentsIn(listing.text);
    listing.text = withComments(listing.text, translated(listing.comments));
    return listing;
}

}
