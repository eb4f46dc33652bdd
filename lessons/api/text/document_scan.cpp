#include "lessons/api/text/document_scan.h"

#include "lessons/api/text/document.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringDecoder>

namespace lessons {

namespace {

struct ScanText
{
    Q_DECLARE_TR_FUNCTIONS(DocumentScan)
};

const QString fence = QStringLiteral("```");

bool isFence(const QString &line)
{
    return line.trimmed().startsWith(fence);
}

/// Returns the lines of `source`, without line ends.
QStringList decodedLines(const QByteArray &source, const QString &file)
{
    QStringDecoder decoder(QStringDecoder::Utf8);
    const QString text = decoder(source);
    if (decoder.hasError() || text.contains(QChar(0))) {
        static const QRegularExpression bad(QStringLiteral("[\\x{fffd}\\x00]"));
        throw DocumentError(file,
                            static_cast<int>(QStringView(text).left(text.indexOf(bad)).count(u'\n')) + 1,
                            ScanText::tr("this is not UTF-8. Save the file with the encoding UTF-8."));
    }
    QStringList lines = text.split('\n');
    for (QString &line : lines) {
        if (line.endsWith('\r'))
            line.chop(1);
    }
    return lines;
}

/// Returns whether a line of text begins a new line of Markdown, also within a paragraph.
bool beginsLine(const QString &line)
{
    if (line.isEmpty() || line.front().isLetter())
        return false; // most lines
    static const QRegularExpression sign(QStringLiteral("^([-*+] |\\d+[.)] |[|>]|#{1,6} )"));
    return sign.match(line).hasMatch();
}

}

ScannedDocument scanDocument(const QByteArray &source, const QString &file)
{
    static const QRegularExpression headingPattern(QStringLiteral("^(#{1,3})\\s+(\\S.*)$"));
    static const QRegularExpression gluedPattern(QStringLiteral("^#{1,3}[A-Za-z]"));
    const QRegularExpressionMatch none;
    ScannedDocument document;
    DocumentPart *open = nullptr;
    int number = 0;
    int fenceLine = 0;
    for (const QString &line : decodedLines(source, file)) {
        ++number;
        if (isFence(line))
            fenceLine = fenceLine > 0 ? 0 : number;
        const auto heading = fenceLine == 0 && line.startsWith('#') ? headingPattern.match(line) : none;
        const auto level = heading.hasMatch() ? heading.capturedLength(1) : 0;
        if (!open && level != 1 && !line.trimmed().isEmpty())
            throw DocumentError(
                file, number,
                ScanText::tr("the title is missing. Begin the file with “# ” and the title of the step."));
        if (open && level == 1)
            throw DocumentError(file, number, ScanText::tr("this is a second title. Write “## ” instead."));
        if (fenceLine == 0 && level == 0 && gluedPattern.match(line).hasMatch())
            throw DocumentError(
                file, number,
                ScanText::tr("a space is missing after “#”. Write the heading as in “## Learnt”."));
        if (level == 1) {
            document.title = {heading.captured(2).trimmed(), number};
            open = &document.title;
        } else if (level == 2) {
            document.sections.push_back({{heading.captured(2).trimmed(), number}});
            open = &document.sections.back().part;
        } else if (level == 3 && !document.sections.empty()) {
            document.sections.back().fields.push_back({heading.captured(2).trimmed(), number});
            open = &document.sections.back().fields.back();
        } else if (open) {
            open->body << line;
        }
    }
    if (fenceLine > 0)
        throw DocumentError(file, fenceLine,
                            ScanText::tr("the code has no end. Write ``` on a line of its own after it."));
    if (!open)
        throw DocumentError(
            file, 1,
            ScanText::tr("the title is missing. Begin the file with “# ” and the title of the step."));
    return document;
}

QString joinedText(const QStringList &lines)
{
    QStringList blocks;
    QString block;
    bool isCode = false;
    const auto end = [&] {
        if (!block.isEmpty())
            blocks << block;
        block.clear();
    };
    for (const QString &line : lines) {
        const QString text = line.trimmed();
        if (isCode || isFence(line)) {
            if (!isCode)
                end();
            block += block.isEmpty() ? line : '\n' + line;
            isCode = isFence(line) ? !isCode : isCode;
            if (!isCode)
                end();
        } else if (text.isEmpty()) {
            end();
        } else if (block.isEmpty()) {
            block = text;
        } else {
            block += (beginsLine(text) ? '\n' : ' ') + text;
        }
    }
    end();
    return blocks.join(QStringLiteral("\n\n"));
}

FencedCode takeCode(const QStringList &lines)
{
    FencedCode result;
    QStringList code;
    int fences = 0;
    for (const QString &line : lines) {
        if (fences < 2 && isFence(line)) {
            ++fences;
        } else if (fences == 1) {
            code << line;
        } else if (fences == 2) {
            result.after << line;
        } else if (!line.trimmed().isEmpty()) {
            return {};
        }
    }
    result.isThere = fences == 2;
    result.code = code.join('\n');
    return result;
}

}
