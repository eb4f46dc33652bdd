#include "app/model/code/source_files.h"

#include <QFile>

#include <algorithm>
#include <limits>

namespace app {

namespace {

bool isBlank(const SourceLine &line)
{
    return line.text.trimmed().isEmpty();
}

qsizetype indentOf(const QString &text)
{
    const auto first = std::find_if(text.begin(), text.end(), [](QChar c) { return !c.isSpace(); });
    return first - text.begin();
}

void trimBlankEnds(std::vector<SourceLine> &lines)
{
    while (!lines.empty() && isBlank(lines.back()))
        lines.pop_back();
    lines.erase(lines.begin(), std::find_if_not(lines.begin(), lines.end(), isBlank));
}

void dedent(std::vector<SourceLine> &lines)
{
    qsizetype common = std::numeric_limits<qsizetype>::max();
    for (const SourceLine &line : lines) {
        if (!isBlank(line))
            common = std::min(common, indentOf(line.text));
    }
    for (SourceLine &line : lines)
        line.text = isBlank(line) ? QString() : line.text.mid(common);
}

}

std::optional<std::vector<SourceLine>> SourceFiles::text(const sim::Region &region)
{
    const QString mark = QStringLiteral("//! [%1]").arg(QString::fromStdString(region.marker));
    std::vector<SourceLine> lines;
    bool inside = false;
    int number = 0;
    for (const QString &line : linesOf(QString::fromStdString(region.file))) {
        ++number;
        const QString bare = line.trimmed();
        if (bare == mark) {
            if (inside) {
                trimBlankEnds(lines);
                dedent(lines);
                return lines;
            }
            inside = true;
        } else if (inside && !bare.startsWith(QLatin1String("//!"))) {
            lines.push_back({line, number});
        }
    }
    return std::nullopt;
}

const QStringList &SourceFiles::linesOf(const QString &file)
{
    const auto known = m_files.constFind(file);
    if (known != m_files.constEnd())
        return *known;
    QFile source(QStringLiteral(":/source/") + file);
    QStringList lines;
    if (source.open(QIODevice::ReadOnly | QIODevice::Text))
        lines = QString::fromUtf8(source.readAll()).split('\n');
    return *m_files.insert(file, lines);
}

}
