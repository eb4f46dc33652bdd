#include "app/model/web/page_file.h"

#include "app/model/web/page_words.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QtEndian>

namespace app {

namespace {

constexpr qsizetype sizeOfHeader = 4; ///< bytes that qCompress() puts before the zlib stream

QString resource(const QString &name)
{
    QFile file(":/page/" + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString scriptText()
{
    QString text = "\"use strict\";\n";
    for (const char *name :
         {"numbers.js", "camera.js", "shapes.js", "surroundings.js", "tree.js", "moments.js", "overlays.js",
          "circle.js", "legend.js", "scene.js", "prose.js", "listing.js", "plots.js", "player.js"})
        text += '\n' + resource(name);
    return text;
}

QString declarations(const PageColors &colors, const QString &scheme)
{
    QString text = QStringLiteral("{\n    color-scheme: %1;\n").arg(scheme);
    for (const auto &[name, color] : colors)
        text += QStringLiteral("    --%1: %2;\n").arg(name, color);
    return text + "}\n";
}

/// The reader's system chooses the colours, unless the page's switch does.
QString styleSheet(const PageParts &parts)
{
    const QString dark = declarations(parts.dark, "dark");
    return ":root " + declarations(parts.light, "light") +
           "@media (prefers-color-scheme: dark) {\n:root:not([data-colors=\"light\"]) " + dark + "}\n" +
           ":root[data-colors=\"dark\"] " + dark + '\n' + resource("player.css");
}

/// Returns the hash of an inline script or style sheet, as a Content-Security-Policy names it.
QString hashOf(const QString &text)
{
    const QByteArray hash = QCryptographicHash::hash(text.toUtf8(), QCryptographicHash::Sha256);
    return "'sha256-" + QString::fromLatin1(hash.toBase64()) + '\'';
}

}

QByteArray packed(const QByteArray &json, const QByteArray &numbers)
{
    char size[4];
    qToLittleEndian(static_cast<quint32>(json.size()), size);
    return qCompress(QByteArray(size, sizeof size) + json + numbers, 9).mid(sizeOfHeader).toBase64();
}

QByteArray pageText(const PageParts &parts)
{
    const QString style = styleSheet(parts), code = scriptText();
    QHash<QString, QString> values = {
        {"language", parts.language.toHtmlEscaped()},
        {"title", parts.title.toHtmlEscaped()},
        {"version", QCoreApplication::applicationVersion().toHtmlEscaped()},
        {"scriptHash", hashOf(code)},
        {"styleHash", hashOf(style)},
        {"style", style},
        {"script", code},
        {"icon", QString::fromLatin1(resource("icon.svg").toUtf8().toBase64())},
        {"data", QString::fromLatin1(parts.data)},
    };
    for (const auto &[name, text] : noRunWords())
        values[name] = text.toHtmlEscaped();
    const QString page = resource("player.html");
    static const QRegularExpression name("@(\\w+)@");
    QString text;
    qsizetype end = 0;
    for (auto found = name.globalMatch(page); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        text += QStringView(page).mid(end, match.capturedStart() - end);
        text += values.value(match.captured(1));
        end = match.capturedEnd();
    }
    return (text + page.mid(end)).toUtf8();
}

}
