#include "app/ui/code/engine/code_rows.h"

#include "app/ui/code/code_colors.h"

#include <QCoreApplication>

namespace app {

namespace {

struct CodeRowsText
{
    Q_DECLARE_TR_FUNCTIONS(CodeRowsText)
};

QByteArray inked(const QString &text, Ink ink)
{
    return QByteArray(text.toUtf8().size(), static_cast<char>(ink));
}

CodeRow headingOf(const CodeSection &section, std::size_t index)
{
    const QStringList files = section.files();
    const QString caption = files.isEmpty() ? QString() : QStringLiteral("   ") + fileName(files.first());
    return {CodeRow::Kind::heading, index, 0, section.title + caption,
            inked(section.title, Ink::heading) + inked(caption, Ink::caption)};
}

/// Returns the row that names the file of the lines from `index` on.
CodeRow fileRow(std::size_t section, std::size_t index, const CodeLine &line)
{
    const QString name = fileName(line.file);
    const QString text = line.isPlumbing ? CodeRowsText::tr("%1: added up by the method").arg(name) : name;
    return {CodeRow::Kind::file, section, index, text, inked(text, Ink::caption), line.isPlumbing};
}

}

std::vector<CodeRow> rowsOf(const CodeListing &listing, Gone gone)
{
    std::vector<CodeRow> rows;
    for (std::size_t s = 0; s < listing.sections.size(); ++s) {
        const CodeSection &section = listing.sections[s];
        rows.push_back(headingOf(section, s));
        auto next = gone == Gone::shown ? section.gone.begin() : section.gone.end();
        const auto addGone = [&](std::size_t before) {
            for (; next != section.gone.end() && next->before <= before; ++next)
                rows.push_back({CodeRow::Kind::gone, s, before, next->text, inked(next->text, Ink::comment)});
        };
        for (std::size_t i = 0; i < section.lines.size(); ++i) {
            const CodeLine &line = section.lines[i];
            addGone(i);
            if (i > 0 && (section.lines[i - 1].file != line.file ||
                          section.lines[i - 1].isPlumbing != line.isPlumbing))
                rows.push_back(fileRow(s, i, line));
            rows.push_back(
                {CodeRow::Kind::code, s, i, line.source.text, inksOf(line.source.text), line.isPlumbing});
        }
        addGone(section.lines.size());
        rows.push_back({CodeRow::Kind::gap, s, 0, {}, {}});
    }
    return rows;
}

QString keyOf(const CodeSection &section)
{
    switch (section.role) {
    case CodeSection::Role::scene:
        return QStringLiteral("scene");
    case CodeSection::Role::order:
        return QStringLiteral("order");
    case CodeSection::Role::phase:
        break;
    }
    return section.title.section(' ', 1); // without its number
}

QString keyOfPlumbing()
{
    return QStringLiteral("plumbing");
}

QString plainText(const CodeSection &section)
{
    QString text = QStringLiteral("// %1\n").arg(section.title);
    const CodeLine *last = nullptr;
    for (const CodeLine &line : section.lines) {
        // Two regions of a file may not be adjacent, so each region gets its own position.
        if (!last || last->file != line.file || line.source.number <= last->source.number)
            text += QStringLiteral("// %1:%2\n").arg(line.file).arg(line.source.number);
        text += line.source.text + '\n';
        last = &line;
    }
    return text;
}

}
